// SPDX-License-Identifier: Apache-2.0
// Interface of a kind of camera: CameraBackend lists and opens cameras, Camera delivers pictures.
// The parts that all cameras share (threads, pairing depth with colour, clocks, loss and
// reconnection, counters) are in CameraSource, so that a backend stays small. Metres, millimetres
// of depth, device time in nanoseconds of the camera's own clock. Threading: a backend may be
// called from any thread, one at a time; a Camera is used by one thread at a time.
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

/// A connected camera, or a file that can be opened like one.
struct CameraInfo {
  std::string place;  // for the backend: a serial number, a position, a URI or a path
  std::string model;
  std::string serial;                            // empty if the camera gives none
  std::optional<Error> obstacle = std::nullopt;  // why it cannot be opened, and the remedy
};

/// Properties of an open camera.
struct CameraDescription {
  std::string serial;  // empty if the camera gives none
  SensorCalibration calibration;
  bool has_color = true;  // if false, `color` equals `depth` and counts as registered
  double fps = 30;
};

/// An open, streaming camera. Its destructor stops and closes it.
class Camera {
 public:
  virtual ~Camera() = default;
  [[nodiscard]] virtual const CameraDescription& description() const = 0;

  /// Waits up to `patience` and adds new pictures, if any, to `pictures`. kUnavailable: the camera
  /// is lost. kClosed: a file has ended. kMalformed: a file is damaged.
  [[nodiscard]] virtual Status wait(FramePairing& pictures, std::chrono::milliseconds patience) = 0;

  /// Locks exposure or white balance, or both, at the current values. Called only for cameras whose
  /// backend has that ability.
  [[nodiscard]] virtual Status lock_color(bool exposure, bool white_balance) {
    if (!exposure && !white_balance) return {};
    return Error{ErrorCode::kUnsupported, "this camera cannot lock its colours"};
  }
};

class CameraBackend {
 public:
  virtual ~CameraBackend() = default;
  /// First part of a SPEC: "freenect".
  [[nodiscard]] virtual std::string kind() const = 0;
  /// The driver library, with its version if known: "libfreenect", "OpenNI 2.2.0".
  [[nodiscard]] virtual std::string library() const = 0;
  [[nodiscard]] virtual CameraAbilities abilities() const = 0;

  /// Lists the connected cameras. kUnavailable: the library does not start.
  [[nodiscard]] virtual Result<std::vector<CameraInfo>> list() = 0;

  /// Whether `place` is a file that this kind plays, instead of a camera.
  [[nodiscard]] virtual bool plays(const std::string& /*place*/) const { return false; }

  /// Opens and starts a camera from list(), or a file. kUnavailable: it exists but cannot be
  /// opened; kNotFound: it is gone. Called by open_camera (open_camera.h), which adds further
  /// reasons.
  [[nodiscard]] virtual Result<std::unique_ptr<Camera>> open(const CameraInfo& camera,
                                                             const CameraSettings& settings) = 0;
};

}  // namespace roomcast::source
