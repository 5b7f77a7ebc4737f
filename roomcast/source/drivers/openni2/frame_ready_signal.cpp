// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/openni2/frame_ready_signal.h"

#include <utility>

#include <OniCAPI.h>

namespace roomcast::source {

void FrameReadySignal::listen(const openni::VideoStream& depth, const openni::VideoStream* color) {
  depth_ = depth._getHandle();
  oniStreamRegisterNewFrameCallback(depth_, depth_came, this, &depth_callback_);
  if (color == nullptr) return;
  color_ = color->_getHandle();
  oniStreamRegisterNewFrameCallback(color_, color_came, this, &color_callback_);
}

void FrameReadySignal::silence() {
  if (depth_ != nullptr) oniStreamUnregisterNewFrameCallback(depth_, depth_callback_);
  if (color_ != nullptr) oniStreamUnregisterNewFrameCallback(color_, color_callback_);
  depth_ = color_ = nullptr;
}

void FrameReadySignal::depth_came(OniStreamHandle, void* bell) {
  auto* const self = static_cast<FrameReadySignal*>(bell);
  self->ring(self->depth_has_come_);
}

void FrameReadySignal::color_came(OniStreamHandle, void* bell) {
  auto* const self = static_cast<FrameReadySignal*>(bell);
  self->ring(self->color_has_come_);
}

void FrameReadySignal::ring(bool& has_come) {
  {
    std::lock_guard lock(mutex_);
    has_come = true;
  }
  rung_.notify_one();
}

std::optional<bool> FrameReadySignal::wait(std::chrono::milliseconds patience) {
  std::unique_lock lock(mutex_);
  if (!rung_.wait_for(lock, patience, [this] { return depth_has_come_ || color_has_come_; }))
    return std::nullopt;
  const bool is_depth = depth_has_come_;
  (is_depth ? depth_has_come_ : color_has_come_) = false;
  return is_depth;
}

}  // namespace roomcast::source
