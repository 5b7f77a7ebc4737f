// SPDX-License-Identifier: Apache-2.0
// FrameReadySignal: signals that one of two streams has a new picture. OpenNI calls back on its own
// threads, which must not call OpenNI in turn (openni2_session.h); hence OpenNI's C functions.
// Thread-safe.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>

#include <OpenNI.h>

namespace roomcast::source {

class FrameReadySignal {
 public:
  FrameReadySignal() = default;
  FrameReadySignal(const FrameReadySignal&) = delete;
  FrameReadySignal& operator=(const FrameReadySignal&) = delete;

  /// Call on OpenNI's thread. `color` may be null.
  void listen(const openni::VideoStream& depth, const openni::VideoStream* color);
  /// Call on OpenNI's thread, before the streams are destroyed.
  void silence();

  /// Returns whether the new picture is depth; nothing if none comes within `patience`.
  [[nodiscard]] std::optional<bool> wait(std::chrono::milliseconds patience);

 private:
  static void depth_came(OniStreamHandle stream, void* bell);
  static void color_came(OniStreamHandle stream, void* bell);
  void ring(bool& has_come);

  OniStreamHandle depth_ = nullptr, color_ = nullptr;
  OniCallbackHandle depth_callback_ = nullptr, color_callback_ = nullptr;
  std::mutex mutex_;
  std::condition_variable rung_;
  bool depth_has_come_ = false, color_has_come_ = false;
};

}  // namespace roomcast::source
