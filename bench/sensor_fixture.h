// SPDX-License-Identifier: Apache-2.0
// The join message of a sensor for transport benchmarks, whose frames are never decoded: a Kinect
// v2 at an arbitrary pose.
#pragma once

#include <string>

#include "roomcast/wire/control.pb.h"

namespace roomcast::bench {

[[nodiscard]] inline wire::pb::Join sensor_fixture(const std::string& name, double fps) {
  wire::pb::Join join;
  join.set_name(name);
  auto& sensor = *join.mutable_sensor();
  sensor.set_fps(fps);
  auto& calibration = *sensor.mutable_calibration();
  for (auto* camera : {calibration.mutable_depth(), calibration.mutable_color()}) {
    camera->set_width(512);
    camera->set_height(424);
    camera->set_fx(365);
    camera->set_fy(365);
    camera->set_cx(255.5);
    camera->set_cy(211.5);
  }
  for (int i = 0; i < 16; ++i) calibration.add_color_from_depth(i % 5 == 0 ? 1 : 0);
  return join;
}

}  // namespace roomcast::bench
