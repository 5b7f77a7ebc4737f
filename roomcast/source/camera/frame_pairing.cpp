// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/camera/frame_pairing.h"

#include <chrono>
#include <utility>

namespace roomcast::source {
namespace {

nanoseconds half_a_period(double fps) {
  return std::chrono::duration_cast<nanoseconds>(std::chrono::duration<double>(0.5 / fps));
}

}  // namespace

FramePairing::FramePairing(double fps, bool has_color, Deliver deliver)
    : has_color_(has_color), tolerance_(half_a_period(fps)), deliver_(std::move(deliver)) {}

void FramePairing::depth(nanoseconds device_time, DepthImage& picture_mm) {
  if (depth_time_) ++unpaired_count_;
  std::swap(waiting_.depth_mm, picture_mm);
  depth_time_ = device_time;
  if (!has_color_ || together()) deliver();
}

void FramePairing::color(nanoseconds device_time, ColorImage& picture) {
  std::swap(waiting_.color, picture);
  color_time_ = device_time;
  if (depth_time_ && together()) deliver();
}

bool FramePairing::together() const {
  return color_time_ && std::chrono::abs(*color_time_ - *depth_time_) <= tolerance_;
}

void FramePairing::deliver() {
  waiting_.index = frame_count_++;
  waiting_.device_time = *depth_time_;
  depth_time_.reset();
  color_time_.reset();
  deliver_(waiting_);
}

void FramePairing::forget() {
  depth_time_.reset();
  color_time_.reset();
}

}  // namespace roomcast::source
