// SPDX-License-Identifier: Apache-2.0
#include "bench/codec/candidate.h"

#include <cstdlib>

namespace roomcast::bench {
namespace {

constexpr double kReportFps = 30;

// Noise on one surface stays below these differences: 10 mm and 1/32 of the distance.
constexpr int kSurfaceReach_mm = 10, kSurfaceShare = 32;

DepthQuality quality_of(const DepthError& error, double frames) {
  DepthQuality quality;
  quality.rms_input_mm = error.rms_input_mm();
  quality.max_input_mm = error.max_input_mm();
  if (error.has_truth()) {
    quality.rms_truth_mm = error.rms_truth_mm();
    quality.rms_truth_static_mm = error.rms_truth_mm(Motion::kStatic);
    quality.rms_truth_slow_mm = error.rms_truth_mm(Motion::kSlow);
    quality.rms_truth_moving_mm = error.rms_truth_mm(Motion::kMoving);
  }
  if (error.has_noise_free()) {
    quality.rms_noise_free_static_mm = error.rms_noise_free_mm(Motion::kStatic);
    quality.rms_noise_free_slow_mm = error.rms_noise_free_mm(Motion::kSlow);
    quality.rms_noise_free_moving_mm = error.rms_noise_free_mm(Motion::kMoving);
  }
  if (error.has_still()) {
    quality.rms_still_mm = error.rms_still_mm();
    quality.rms_still_input_mm = error.rms_still_input_mm();
  }
  quality.outliers_20mm = static_cast<double>(error.outliers()) / frames;
  quality.lost = static_cast<double>(error.lost()) / frames;
  quality.extra = static_cast<double>(error.extra()) / frames;
  return quality;
}

double bytes_of(const FrameCost& cost) {
  return static_cast<double>(cost.depth_bytes + cost.color_bytes);
}

}  // namespace

Status Candidate::run(const BenchFrame& frame, const BenchTruth& truth,
                      ImageView<const Motion> motion, bool key) {
  const auto cost = codec_->run(frame, key, decoded_);
  if (!cost.ok()) return cost.error();
  Measured& now = frames_.emplace_back();
  now.key = key;
  now.cost = *cost;
  if (!decoded_.depth_mm.empty()) {
    DepthTruth depth_truth;
    if (!truth.depth_mm.empty()) depth_truth = {truth.depth_mm, motion, truth.noise_free_mm};
    if (!truth.still_mm.empty()) depth_truth.still_mm = truth.still_mm;
    now.depth.add(decoded_.depth_mm, frame.depth_mm, depth_truth);
  }
  if (!decoded_.color.empty()) compare_color(frame, truth, now);
  return check_promise(frame.depth_mm, now.depth);
}

void Candidate::compare_color(const BenchFrame& frame, const BenchTruth& truth, Measured& now) {
  now.color_all.add(decoded_.color, truth.color, frame.seen);
  now.color_lost = find_shown(frame.seen, decoded_.seen);
  now.color.add(decoded_.color, truth.color, shown_);
  now.color_to_input.add(decoded_.color, frame.color, shown_);
  if (!decoded_.depth_mm.empty()) keep_measured_surface(frame.depth_mm);
  now.color_on_surface.add(decoded_.color, truth.color, shown_);
}

void Candidate::keep_measured_surface(DepthView measured_mm) {
  for (int y = 0; y < measured_mm.height; ++y) {
    for (int x = 0; x < measured_mm.width; ++x) {
      const int decoded_mm = decoded_.depth_mm.at(x, y);
      const int apart_mm = std::abs(measured_mm.at(x, y) - decoded_mm);
      if (kSurfaceShare * (apart_mm - kSurfaceReach_mm) > decoded_mm) shown_.at(x, y) = 0;
    }
  }
}

std::int64_t Candidate::find_shown(const MaskImage& seen, const MaskImage& decoded) {
  std::int64_t lost = 0;
  shown_.resize(seen.width(), seen.height());
  for (std::size_t i = 0; i < seen.view().pixel_count(); ++i) {
    shown_.data()[i] = seen.data()[i] & decoded.data()[i];
    lost += seen.data()[i] != 0 && decoded.data()[i] == 0;
  }
  return lost;
}

Status Candidate::check_promise(const DepthImage& input_mm, const DepthError& error) const {
  if (!choice_.bound_mm) return {};
  const bool kept = same_size(decoded_.depth_mm.view(), input_mm.view()) && error.lost() == 0 &&
                    error.extra() == 0 && error.max_input_mm() <= *choice_.bound_mm;
  if (kept) return {};
  return Error{ErrorCode::kMalformed, choice_.codec + " " + choice_.mode +
                                          " did not give back the depth that it promises."};
}

CodecBenchRow Candidate::row(int first, int key_interval) const {
  CodecBenchRow row;
  row.codec = choice_.codec;
  row.mode = choice_.mode;
  row.curve = choice_.curve;
  add_bytes(first, key_interval, row);
  add_quality(first, row);
  return row;
}

void Candidate::add_bytes(int first, int key_interval, CodecBenchRow& row) const {
  const auto mean = [&](bool keys, auto bytes) {
    double sum = 0;
    int count = 0;
    for (std::size_t i = static_cast<std::size_t>(first); i < frames_.size(); ++i) {
      if (frames_[i].key != keys) continue;
      sum += static_cast<double>(bytes(frames_[i].cost));
      ++count;
    }
    return count ? sum / count : static_cast<double>(bytes(frames_.front().cost));
  };
  const auto with_keys = [&](auto bytes) {
    return (mean(true, bytes) + (key_interval - 1) * mean(false, bytes)) / key_interval;
  };
  row.depth_bytes = with_keys([](const FrameCost& cost) { return cost.depth_bytes; });
  row.color_bytes = with_keys([](const FrameCost& cost) { return cost.color_bytes; });
  row.key_bytes = mean(true, bytes_of);
  row.delta_bytes = mean(false, bytes_of);
  row.mb_per_s = (row.depth_bytes + row.color_bytes) * kReportFps / 1e6;
}

void Candidate::add_quality(int first, CodecBenchRow& row) const {
  DepthError depth;
  LumaError color, color_on_surface, color_all, color_to_input;
  const double count = static_cast<double>(frames_.size()) - first;
  for (std::size_t i = static_cast<std::size_t>(first); i < frames_.size(); ++i) {
    const Measured& frame = frames_[i];
    depth.add(frame.depth);
    color.add(frame.color);
    color_on_surface.add(frame.color_on_surface);
    color_all.add(frame.color_all);
    color_to_input.add(frame.color_to_input);
    row.color_lost += static_cast<double>(frame.color_lost) / count;
    row.encode_ms += frame.cost.encode_ms / count;
    row.decode_ms += frame.cost.decode_ms / count;
  }
  if (!decoded_.depth_mm.empty()) row.depth = quality_of(depth, count);
  row.color_psnr_y = color.psnr_db();
  row.color_psnr_surface_y = color_on_surface.psnr_db();
  row.color_psnr_all_y = color_all.psnr_db();
  row.color_psnr_input_y = color_to_input.psnr_db();
}

}  // namespace roomcast::bench
