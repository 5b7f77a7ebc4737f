// SPDX-License-Identifier: Apache-2.0
// Camera model of a simulated sensor, and which of its errors are simulated. Plain data; the errors
// are described where they are implemented (docs/simulator.md lists them with their sources).
#pragma once

#include <optional>
#include <string_view>

namespace roomcast::simulator {

enum class CameraModel {
  kKinect2,  // time of flight, 512x424; colour 1920x1080
  kAzure,    // Azure Kinect and Orbbec Femto Bolt: time of flight, 640x576; colour 1920x1080
  kD435,     // Intel RealSense D435: active stereo, 848x480; colour 1920x1080
  kKinect1,  // Kinect v1, of harsh sensors only: structured light, 640x480; colour 640x480
};

/// "kinect2", "azure" or "d435".
[[nodiscard]] std::optional<CameraModel> camera_model_named(std::string_view name);
[[nodiscard]] std::string_view name_of(CameraModel model);
inline constexpr std::string_view kCameraModelNames = "kinect2, azure or d435";

/// Harsh sensors are as bad as those found in the field: what distinguishes a unit from its nominal
/// model is drawn at random, and nobody has calibrated it (harsh_unit.h).
enum class Harshness {
  kNone,
  kTimeOfFlight,     // Kinect v2 or Azure Kinect
  kStructuredLight,  // Kinect v1
  kMixed,            // each sensor is one or the other
};

/// "tof", "structured" or "mixed".
[[nodiscard]] std::optional<Harshness> harshness_named(std::string_view name);
[[nodiscard]] std::string_view name_of(Harshness harshness);

struct SensingOptions {
  CameraModel camera = CameraModel::kKinect2;
  bool half_color = false;             // 960x540, fast enough for live use
  bool noise = true;                   // all depth and colour errors
  bool calibration_error = true;       // the reported lens calibration is slightly wrong
  bool auto_exposure = true;           // exposure follows the scene; white balance differs per unit
  double interference_per_minute = 0;  // bursts of infrared interference between sensors
  bool mutual_interference = false;    // of the infrared light of the room's other sensors
  Harshness harsh = Harshness::kNone;  // if not kNone, `camera` has no effect

  /// An error-free sensor of the same model.
  [[nodiscard]] SensingOptions clean() const {
    SensingOptions perfect = *this;
    perfect.noise = perfect.calibration_error = perfect.auto_exposure = false;
    perfect.interference_per_minute = 0;
    perfect.mutual_interference = false;
    perfect.harsh = Harshness::kNone;
    return perfect;
  }
};

}  // namespace roomcast::simulator
