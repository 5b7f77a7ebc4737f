// SPDX-License-Identifier: Apache-2.0
#include "bench/live_align/filmed_sensor.h"

#include <utility>

#include "roomcast/alignment/bundle/bundle_capture.h"

namespace roomcast::bench {

/// Interval between the frames of a bundle: long enough that a person who walks by has left most of
/// them.
constexpr nanoseconds kFrameGap = std::chrono::milliseconds(800);

FilmedSensor::FilmedSensor(std::unique_ptr<simulator::SimulatedSensor> sensor, std::string name)
    : sensor_(std::move(sensor)),
      moment_(sensor_->make_moment()),
      exposure_(sensor_->auto_exposure()),
      name_(std::move(name)) {}

Result<FilmedSensor> FilmedSensor::open(std::shared_ptr<const simulator::SimulatedRoom> room,
                                        const simulator::SimulatedSensor::Options& options) {
  auto sensor = simulator::SimulatedSensor::open(std::move(room), options);
  if (!sensor) return sensor.error();
  return FilmedSensor(*std::move(sensor), "s" + std::to_string(options.index));
}

Result<alignment::CalibrationBundle> FilmedSensor::bundle(int frames) {
  alignment::BundleCapture capture(name_, sensor_->calibration());
  for (int i = 0; i < frames; ++i) {
    const DepthImage& depth = depth_mm(i * kFrameGap);
    if (const auto added = capture.add(depth, color()); !added) return added.error();
  }
  return capture.finish();
}

const DepthImage& FilmedSensor::depth_mm(nanoseconds scene_time) {
  sensor_->look(scene_time, moment_);
  sensor_->read_depth(frame_++, moment_, depth_mm_);
  return depth_mm_;
}

const ColorImage& FilmedSensor::color() {
  const float gain = sensor_->next_exposure(moment_.scene_time(), moment_, exposure_);
  sensor_->read_color(frame_, gain, moment_, color_);
  return color_;
}

}  // namespace roomcast::bench
