// SPDX-License-Identifier: Apache-2.0
// OpenNi2Device: an open device of OpenNI 2, or a file, and its two streams. Threading: everything,
// including construction and destruction, on OpenNI's thread (on_openni2_thread), except the
// methods marked otherwise.
#pragma once

#include <optional>
#include <string>

#include <OpenNI.h>

#include "roomcast/source/camera/camera.h"
#include "roomcast/source/drivers/openni2/frame_ready_signal.h"
#include "roomcast/source/drivers/openni2/openni2_session.h"

namespace roomcast::source {

class OpenNi2Device {
 public:
  explicit OpenNi2Device(const CameraInfo& info);
  ~OpenNi2Device();

  /// Returns kUnavailable or kUnsupported with the reason if it does not start.
  [[nodiscard]] Status start(const std::string& uri, bool loop);
  /// Adds the newest picture of a stream, if there is one, to `pictures`.
  void take(bool is_depth, FramePairing& pictures);
  [[nodiscard]] Status lock_color(bool exposure, bool white_balance);

  // From any thread, after start().
  [[nodiscard]] const CameraDescription& description() const { return description_; }
  [[nodiscard]] bool plays_once() const { return plays_once_; }
  [[nodiscard]] bool is_gone() const { return departure_.happened(); }
  [[nodiscard]] FrameReadySignal& bell() { return bell_; }

 private:
  void calibrate();
  [[nodiscard]] bool reports_registration() const;

  const OpenNi2Session session_;  // outlives everything below
  OpenNi2DisconnectListener departure_;
  openni::Device device_;
  openni::VideoStream depth_, color_;
  FrameReadySignal bell_;
  CameraDescription description_;
  bool plays_once_ = false;
  DepthImage depth_mm_;  // reused
  ColorImage color_picture_;
};

}  // namespace roomcast::source
