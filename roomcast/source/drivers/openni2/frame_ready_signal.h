// SPDX-License-Identifier: Apache-2.0
// FrameReadySignal: rings when one of two streams has a new picture. OpenNI rings on threads of its
// own, which must not call it back (openni2_session.h), so this stays with its C functions.
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

  /// On OpenNI's thread. `color` may be null.
  void listen(const openni::VideoStream& depth, const openni::VideoStream* color);
  /// On OpenNI's thread, before the streams are destroyed.
  void silence();

  /// Whether the picture that came is depth; nothing when none comes within `patience`.
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
