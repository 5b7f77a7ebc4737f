// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/export/thumbnail_strip.h"

#include <algorithm>

namespace roomcast::recording {
namespace {

constexpr int kFarthest_mm = 6000;

Rgb8 shade(std::uint16_t depth_mm) {
  if (depth_mm == 0) return {30, 30, 40};
  const int bright = 255 - std::min<int>(depth_mm, kFarthest_mm) * 205 / kFarthest_mm;
  const auto grey = static_cast<std::uint8_t>(bright);
  return {grey, grey, grey};
}

/// Nearest-neighbour sampling: a thumbnail needs no accuracy.
ColorImage thumbnail(const codec::DecodedFrame& pictures, int width, int height) {
  ColorImage small(width, height);
  const int from_width = pictures.depth_mm.width(), from_height = pictures.depth_mm.height();
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int fx = x * from_width / width, fy = y * from_height / height;
      small.at(x, y) =
          pictures.color.empty() ? shade(pictures.depth_mm.at(fx, fy)) : pictures.color.at(fx, fy);
    }
  }
  return small;
}

void paste(const ColorImage& small, int left, int top, ColorImage& picture) {
  for (int y = 0; y < small.height(); ++y)
    std::copy_n(small.view().row(y), small.width(), picture.view().row(top + y) + left);
}

}  // namespace

ThumbnailStrip::ThumbnailStrip(const std::vector<SetSensor>& sensors)
    : sensor_count_(sensors.size()) {
  if (!sensors.empty()) height_ = kWidth * sensors[0].depth.height / sensors[0].depth.width;
}

void ThumbnailStrip::add(const FrameSet& set) {
  if (count_++ % every_ != 0) return;
  Column column(sensor_count_);
  for (const SetFrame& frame : set.frames)
    column[frame.sensor] = thumbnail(*frame.pictures, kWidth, height_);
  columns_.push_back(std::move(column));
  if (columns_.size() < 2 * kInstants) return;
  for (std::size_t i = 1; i < kInstants; ++i) columns_[i] = std::move(columns_[2 * i]);
  columns_.resize(kInstants);
  every_ *= 2;
}

ColorImage ThumbnailStrip::picture() const {
  if (columns_.empty() || height_ == 0) return {};
  const std::size_t shown = std::min(kInstants, columns_.size());
  const int width = static_cast<int>(shown) * (kWidth + kGap) - kGap;
  const int height = static_cast<int>(sensor_count_) * (height_ + kGap) - kGap;
  ColorImage picture(width, height, {255, 255, 255});
  for (std::size_t i = 0; i < shown; ++i) {
    const std::size_t column = shown < 2 ? 0 : i * (columns_.size() - 1) / (shown - 1);
    for (std::size_t sensor = 0; sensor < sensor_count_; ++sensor) {
      paste(columns_[column][sensor], static_cast<int>(i) * (kWidth + kGap),
            static_cast<int>(sensor) * (height_ + kGap), picture);
    }
  }
  return picture;
}

}  // namespace roomcast::recording
