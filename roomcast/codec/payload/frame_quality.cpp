// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/payload/frame_quality.h"

#include <algorithm>
#include <cmath>

namespace roomcast::codec {
namespace {

// Measured with registered colour of simulated and real rooms: so many steps of libvpx's quantiser
// halve a frame.
constexpr double kHalvingSteps = 9;
// So many steps double the step of depth; at kUsualQuantizer it is kUsualDepthStep.
constexpr double kDoublingSteps = 19.5, kUsualQuantizer = 20, kUsualDepthStep = 2.5;

constexpr double kNewsWeight = 0.4;      // of the newest frame in what is known of sizes
constexpr double kMixWeight = 0.1;       // the same for the share of droppable frames
constexpr double kMinColorShare = 0.25;  // of a frame's wanted size, whatever depth takes
constexpr int kFinestKey = 10;           // a finer key frame would only delay the frames after it
constexpr int kMaxChange = 4;            // of the quantiser from frame to frame, without colour

// Bytes per pixel of colour at kUsualQuantizer, before any frame is known.
constexpr double kKeyBytesPerPixel = 0.18, kReferenceBytesPerPixel = 0.02,
                 kDroppableBytesPerPixel = 0.01;

/// log2 of bytes at quantiser 0, from the bytes at a quantiser.
double log2_at_zero(double bytes, int quantizer) {
  return std::log2(std::max(bytes, 1.0)) + quantizer / kHalvingSteps;
}

int quantizer_for(double log2_of_bytes_at_zero, double wanted_bytes) {
  const double steps = kHalvingSteps * (log2_of_bytes_at_zero - std::log2(wanted_bytes));
  return static_cast<int>(std::ceil(steps));
}

}  // namespace

FrameQuality::Kind FrameQuality::kind_of(const FrameRole& role) {
  if (role.key) return kKey;
  return role.layer == 0 ? kReference : kDroppable;
}

void FrameQuality::choose(const FrameRole& role, std::size_t color_pixels) {
  kind_ = kind_of(role);
  color_pixels_ = color_pixels;
  guess_sizes(color_pixels);
  if (kind_ != kKey) droppable_ += kMixWeight * ((kind_ == kDroppable ? 1 : 0) - droppable_);
  if (!has_target()) return;
  const int wanted = kind_ == kKey ? quantizer_for_key() : quantizer_between_keys();
  quantizer_ = std::clamp(wanted, kMinQuantizer, kMaxQuantizer);
}

double FrameQuality::depth_step() const {
  const double step = kUsualDepthStep * std::exp2((quantizer_ - kUsualQuantizer) / kDoublingSteps);
  return std::clamp(step, kMinDepthStep, kMaxDepthStep);
}

void FrameQuality::guess_sizes(std::size_t color_pixels) {
  constexpr double kPerPixel[] = {kKeyBytesPerPixel, kReferenceBytesPerPixel,
                                  kDroppableBytesPerPixel};
  for (int kind = 0; kind < kKinds; ++kind) {
    if (sizes_[kind].known) continue;
    const double pixels = static_cast<double>(color_pixels);
    sizes_[kind].color_log2 =
        log2_at_zero(kPerPixel[kind] * pixels, static_cast<int>(kUsualQuantizer));
  }
}

int FrameQuality::quantizer_for_key() const {
  const Sizes& key = sizes_[kKey];
  if (color_pixels_ == 0) return coarser_or_finer(key.depth_bytes, target_.key_bytes);
  const double depth = key.known ? key.depth_bytes : target_.key_bytes / 2;
  const double color = std::max(target_.key_bytes - depth, kMinColorShare * target_.key_bytes);
  return std::max(kFinestKey, quantizer_for(key.color_log2, color));
}

// Frames of all roles get the same quality: a reference costs more than its share, and the frames
// that depend on it alone cost less.
int FrameQuality::quantizer_between_keys() const {
  const auto mean = [this](double reference, double droppable) {
    return (1 - droppable_) * reference + droppable_ * droppable;
  };
  const Sizes &reference = sizes_[kReference], &droppable = sizes_[kDroppable];
  const double depth = mean(reference.depth_bytes, droppable.depth_bytes);
  if (color_pixels_ == 0) return coarser_or_finer(depth, target_.bytes);
  const double color = std::max(target_.bytes - depth, kMinColorShare * target_.bytes);
  const double at_zero = mean(std::exp2(reference.color_log2), std::exp2(droppable.color_log2));
  return quantizer_for(std::log2(at_zero), color);
}

int FrameQuality::coarser_or_finer(double depth_bytes, double wanted_bytes) const {
  if (depth_bytes <= 0 || wanted_bytes <= 0) return quantizer_;
  const double steps = kDoublingSteps * std::log2(depth_bytes / wanted_bytes);
  return quantizer_ +
         static_cast<int>(std::lround(std::clamp<double>(steps, -kMaxChange, kMaxChange)));
}

void FrameQuality::coded(std::size_t depth_bytes, std::size_t color_bytes) {
  Sizes& sizes = sizes_[kind_];
  const double weight = sizes.known ? kNewsWeight : 1;
  sizes.depth_bytes += weight * (static_cast<double>(depth_bytes) - sizes.depth_bytes);
  if (color_pixels_ > 0) {
    const double log2 = log2_at_zero(static_cast<double>(color_bytes), quantizer_);
    sizes.color_log2 += weight * (log2 - sizes.color_log2);
    sizes.known = true;
  }
}

}  // namespace roomcast::codec
