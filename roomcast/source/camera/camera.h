// SPDX-License-Identifier: Apache-2.0
// What a kind of camera has to bring: CameraBackend lists and opens, Camera hands over pictures.
// Everything else that cameras share (threads, pairing depth with colour, clocks, loss and replug,
// counting) lies above, in CameraSource, so that a backend stays small. Metres, millimetres of
// depth, device time in nanoseconds of the camera's own clock. Threading: a backend may be asked
// from any thread, one at a time; a Camera is used by one thread at a time.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/source/camera/camera_settings.h"
#include "roomcast/source/camera/frame_pairing.h"

namespace roomcast::source {

/// A camera that is plugged in, or a file that can be opened like one.
struct CameraInfo {
  std::string place;  // for the backend: a serial number, a position, a URI, a path
  std::string model;
  std::string serial;                            // empty where the camera does not tell
  std::optional<Error> obstacle = std::nullopt;  // why it cannot be opened now, and what to do
};

/// What an open camera says of itself.
struct CameraDescription {
  std::string serial;  // empty where the camera does not tell
  SensorCalibration calibration;
  bool has_color = true;  // else `color` equals `depth` and counts as registered
  double fps = 30;
};

/// An open camera that streams. Its destructor stops and closes it.
class Camera {
 public:
  virtual ~Camera() = default;
  [[nodiscard]] virtual const CameraDescription& description() const = 0;

  /// Waits up to `patience` and puts what came into `pictures`; nothing may have come.
  /// kUnavailable: the camera is lost. kClosed: a file has ended.
  [[nodiscard]] virtual Status wait(FramePairing& pictures, std::chrono::milliseconds patience) = 0;

  /// Keeps exposure and white balance, as asked, at what they are now. Asked only of cameras whose
  /// backend says that they can.
  [[nodiscard]] virtual Status lock_color(bool exposure, bool white_balance) {
    if (!exposure && !white_balance) return {};
    return Error{ErrorCode::kUnsupported, "this camera cannot lock its colours"};
  }
};

class CameraBackend {
 public:
  virtual ~CameraBackend() = default;
  /// As a SPEC begins: "freenect".
  [[nodiscard]] virtual std::string kind() const = 0;
  /// The library behind it and its version, where it tells: "libfreenect", "OpenNI 2.2.0".
  [[nodiscard]] virtual std::string library() const = 0;
  [[nodiscard]] virtual CameraAbilities abilities() const = 0;

  /// What is plugged in. kUnavailable: the library does not start.
  [[nodiscard]] virtual Result<std::vector<CameraInfo>> list() = 0;

  /// Whether a place is no camera of the list but a file that this kind plays.
  [[nodiscard]] virtual bool plays(const std::string& /*place*/) const { return false; }

  /// Opens what list() gave, or a file, and starts it. kUnavailable: it is there but cannot be
  /// opened; kNotFound: it is gone. Called by open_camera (open_camera.h), which knows more
  /// reasons.
  [[nodiscard]] virtual Result<std::unique_ptr<Camera>> open(const CameraInfo& camera,
                                                             const CameraSettings& settings) = 0;
};

}  // namespace roomcast::source
