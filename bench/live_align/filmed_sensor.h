// SPDX-License-Identifier: Apache-2.0
// FilmedSensor: a simulated sensor that provides its bundle and then its depth at any time. Input
// of the live alignment suites. Single-threaded.
#pragma once

#include <memory>
#include <string>

#include "roomcast/alignment/bundle/calibration_bundle.h"
#include "roomcast/core/result.h"
#include "roomcast/simulator/simulated_room.h"
#include "roomcast/simulator/simulated_sensor.h"

namespace roomcast::bench {

class FilmedSensor {
 public:
  static Result<FilmedSensor> open(std::shared_ptr<const simulator::SimulatedRoom> room,
                                   const simulator::SimulatedSensor::Options& options);

  /// Bundle of `frames` frames of the first seconds of scene time.
  [[nodiscard]] Result<alignment::CalibrationBundle> bundle(int frames);
  [[nodiscard]] const DepthImage& depth_mm(nanoseconds scene_time);
  /// Colour at the time of the last call of depth_mm().
  [[nodiscard]] const ColorImage& color();
  [[nodiscard]] const SensorCalibration& calibration() const { return sensor_->calibration(); }
  [[nodiscard]] const RigidTransform& world_from_depth() const {
    return sensor_->world_from_depth();
  }

 private:
  FilmedSensor(std::unique_ptr<simulator::SimulatedSensor> sensor, std::string name);

  std::unique_ptr<simulator::SimulatedSensor> sensor_;
  simulator::SimulatedSensor::Moment moment_;
  simulator::AutoExposure exposure_;
  std::string name_;
  std::uint64_t frame_ = 0;
  DepthImage depth_mm_;
  ColorImage color_;
};

}  // namespace roomcast::bench
