// SPDX-License-Identifier: Apache-2.0
#include <iomanip>
#include <ostream>

#include <nlohmann/json.hpp>

#include "bench/codec_bench.h"

namespace roomcast::bench {
namespace {

using nlohmann::ordered_json;

ordered_json or_null(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json to_json(const CodecBenchRow& row) {
  return {{"codec", row.codec},
          {"mode", row.mode},
          {"depth_bytes", row.depth_bytes},
          {"color_bytes", row.color_bytes},
          {"depth_bits_per_pixel", row.depth_bits_per_pixel},
          {"mb_per_s", row.mb_per_s},
          {"encode_ms", row.encode_ms},
          {"decode_ms", row.decode_ms},
          {"depth_encode_ms", row.depth_encode_ms},
          {"depth_decode_ms", row.depth_decode_ms},
          {"rms_input_mm", row.rms_input_mm},
          {"max_input_mm", row.max_input_mm},
          {"rms_truth_mm", or_null(row.rms_truth_mm)},
          {"rms_truth_static_mm", or_null(row.rms_truth_static_mm)},
          {"rms_truth_moving_mm", or_null(row.rms_truth_moving_mm)},
          {"outliers_20mm", row.outliers_20mm},
          {"color_psnr_y", or_null(row.color_psnr_y)}};
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

}  // namespace

void print_json(const CodecBenchReport& report, std::ostream& out) {
  ordered_json rows = ordered_json::array();
  for (const CodecBenchRow& row : report.rows) rows.push_back(to_json(row));
  const ordered_json json = {{"input", report.input},
                             {"frames", report.frames},
                             {"width", report.width},
                             {"height", report.height},
                             {"rows", rows}};
  out << json.dump() << "\n";
}

void print_table(const CodecBenchReport& report, std::ostream& out) {
  out << report.input << ": " << report.frames << " frames of " << report.width << "x"
      << report.height << "\n"
      << "codec     mode      depth B/f   bpp  colour B/f   MB/s  enc ms  dec ms  depth enc  dec"
         "  rms mm  max  >20mm/f  PSNR-Y\n";
  for (const CodecBenchRow& row : report.rows) {
    out << std::left << std::setw(10) << row.codec << std::setw(9) << row.mode << std::right;
    put(out, 10, 0, row.depth_bytes);
    put(out, 6, 2, row.depth_bits_per_pixel);
    put(out, 12, 0, row.color_bytes);
    put(out, 7, 2, row.mb_per_s);
    put(out, 8, 2, row.encode_ms);
    put(out, 8, 2, row.decode_ms);
    put(out, 11, 2, row.depth_encode_ms);
    put(out, 5, 2, row.depth_decode_ms);
    put(out, 8, 2, row.rms_truth_mm ? *row.rms_truth_mm : row.rms_input_mm);
    put(out, 5, 0, row.max_input_mm);
    put(out, 9, 0, row.outliers_20mm);
    put(out, 8, 1, row.color_psnr_y);
    out << "\n";
  }
}

}  // namespace roomcast::bench
