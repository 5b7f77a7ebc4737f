// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iomanip>
#include <ostream>
#include <string>

#include <nlohmann/json.hpp>

#include "bench/codec/codec_bench.h"

namespace roomcast::bench {
namespace {

using nlohmann::ordered_json;

ordered_json or_null(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

void add_depth(const std::optional<DepthQuality>& depth, ordered_json& json) {
  const DepthQuality quality = depth.value_or(DepthQuality{});
  const auto if_depth = [&](auto value) { return depth ? ordered_json(value) : ordered_json(); };
  json["rms_input_mm"] = if_depth(quality.rms_input_mm);
  json["max_input_mm"] = if_depth(quality.max_input_mm);
  json["rms_truth_mm"] = or_null(quality.rms_truth_mm);
  json["rms_truth_static_mm"] = or_null(quality.rms_truth_static_mm);
  json["rms_truth_slow_mm"] = or_null(quality.rms_truth_slow_mm);
  json["rms_truth_moving_mm"] = or_null(quality.rms_truth_moving_mm);
  json["rms_noise_free_static_mm"] = or_null(quality.rms_noise_free_static_mm);
  json["rms_noise_free_slow_mm"] = or_null(quality.rms_noise_free_slow_mm);
  json["rms_noise_free_moving_mm"] = or_null(quality.rms_noise_free_moving_mm);
  json["rms_still_mm"] = or_null(quality.rms_still_mm);
  json["rms_still_input_mm"] = or_null(quality.rms_still_input_mm);
  json["outliers_20mm"] = if_depth(quality.outliers_20mm);
  json["lost"] = if_depth(quality.lost);
  json["extra"] = if_depth(quality.extra);
}

ordered_json to_json(const CodecBenchRow& row) {
  ordered_json json = {{"codec", row.codec},
                       {"mode", row.mode},
                       {"depth_bytes", row.depth_bytes},
                       {"color_bytes", row.color_bytes},
                       {"key_bytes", row.key_bytes},
                       {"delta_bytes", row.delta_bytes},
                       {"depth_bits_per_pixel", row.depth_bits_per_pixel},
                       {"mb_per_s", row.mb_per_s},
                       {"encode_ms", row.encode_ms},
                       {"decode_ms", row.decode_ms}};
  add_depth(row.depth, json);
  json["color_psnr_y"] = or_null(row.color_psnr_y);
  json["color_psnr_surface_y"] = or_null(row.color_psnr_surface_y);
  json["color_psnr_all_y"] = or_null(row.color_psnr_all_y);
  json["color_psnr_input_y"] = or_null(row.color_psnr_input_y);
  json["color_lost"] = row.color_lost;
  return json;
}

const char* name_of(ColorReference reference) {
  switch (reference) {
    case ColorReference::kClean:
      return "clean";
    case ColorReference::kDenoised:
      return "denoised";
    case ColorReference::kInput:
      break;
  }
  return "input";
}

/// A number in a column, or a dash.
void put(std::ostream& out, int width, int digits, const std::optional<double>& value) {
  out << std::setw(width);
  if (value) {
    out << std::fixed << std::setprecision(digits) << *value;
  } else {
    out << "-";
  }
}

std::optional<double> if_any(double value) {
  return value > 0 ? std::optional(value) : std::nullopt;
}

/// Of the column of modes, for its longest name.
int mode_width(const CodecBenchReport& report) {
  std::size_t width = 11;
  for (const CodecBenchRow& row : report.rows) width = std::max(width, row.mode.size() + 1);
  return static_cast<int>(width);
}

void put_row(std::ostream& out, const CodecBenchRow& row, int mode_width) {
  out << std::left << std::setw(13) << row.codec << std::setw(mode_width) << row.mode << std::right;
  put(out, 9, 0, if_any(row.depth_bytes));
  put(out, 7, 3, if_any(row.depth_bits_per_pixel));
  put(out, 9, 0, if_any(row.color_bytes));
  put(out, 8, 3, row.mb_per_s);
  put(out, 8, 2, row.encode_ms);
  put(out, 8, 2, row.decode_ms);
  const DepthQuality depth = row.depth.value_or(DepthQuality{});
  const auto if_depth = [&](double value) {
    return row.depth ? std::optional(value) : std::nullopt;
  };
  put(out, 8, 2, if_depth(depth.rms_input_mm));
  put(out, 6, 0, if_depth(depth.max_input_mm));
  put(out, 8, 2, depth.rms_truth_mm);
  put(out, 7, 2, depth.rms_truth_static_mm);
  put(out, 6, 2, depth.rms_truth_slow_mm);
  put(out, 7, 2, depth.rms_truth_moving_mm);
  put(out, 7, 2, depth.rms_noise_free_static_mm);
  put(out, 6, 2, depth.rms_noise_free_slow_mm);
  put(out, 7, 2, depth.rms_noise_free_moving_mm);
  put(out, 8, 0, if_depth(depth.outliers_20mm));
  put(out, 7, 0, if_depth(depth.lost));
  put(out, 8, 1, row.color_psnr_y);
  put(out, 8, 1, row.color_psnr_surface_y);
  put(out, 6, 1, row.color_psnr_all_y);
  out << "\n";
}

/// The error on what stands still, where it is known.
void put_still_error(std::ostream& out, const CodecBenchRow& row) {
  if (!row.depth || !row.depth->rms_still_mm) return;
  out << row.codec << " " << row.mode << ": RMS to the median of still surfaces"
      << std::setprecision(2) << std::fixed << " " << *row.depth->rms_still_mm
      << " mm, of the input " << *row.depth->rms_still_input_mm << " mm\n";
}

}  // namespace

void print_json(const CodecBenchReport& report, std::ostream& out) {
  ordered_json rows = ordered_json::array();
  for (const CodecBenchRow& row : report.rows) rows.push_back(to_json(row));
  const ordered_json json = {{"input", report.input},
                             {"frames", report.frames},
                             {"measured_frames", report.measured_frames},
                             {"width", report.width},
                             {"height", report.height},
                             {"fps", report.fps},
                             {"key_every_s", report.key_every_s},
                             {"color_reference", name_of(report.color_reference)},
                             {"moving_share", or_null(report.moving_share)},
                             {"slow_share", or_null(report.slow_share)},
                             {"rows", rows}};
  out << json.dump() << "\n";
}

void print_table(const CodecBenchReport& report, std::ostream& out) {
  out << report.input << ": " << report.frames << " frames of " << report.width << "x"
      << report.height << ", the last " << report.measured_frames << " measured";
  if (report.moving_share) {
    out << std::fixed << std::setprecision(1) << "; " << *report.moving_share * 100
        << " % of the pixels move, " << *report.slow_share * 100 << " % slowly";
  }
  const int width = mode_width(report);
  const std::string blanks(static_cast<std::size_t>(width - 11), ' ');
  out << "\nBytes per frame with a key frame every " << std::setprecision(1) << std::fixed
      << report.key_every_s << " s; MB/s at 30 frames/s; CPU ms of one thread; depth errors in mm; "
      << "PSNR of luma against " << name_of(report.color_reference)
      << " colour, over pixels shown, "
      << "shown on the measured surface, all seen\n\n"
      << blanks
      << "                           depth          colour             CPU ms       to input  "
         "      depth error to truth  to noise-free reading   >20mm    lost          colour "
         "PSNR\n"
      << "codec        mode " << blanks
      << "       B/frame    bpp  B/frame    MB/s  encode  decode     rms   max  "
         "   rms static  slow moving static  slow moving  /frame /frame   shown surface   all\n";
  for (const CodecBenchRow& row : report.rows) put_row(out, row, width);
  for (const CodecBenchRow& row : report.rows) put_still_error(out, row);
}

}  // namespace roomcast::bench
