// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/ros_recording.h"

#include <string>
#include <utility>

#include "roomcast/recording/bytes/byte_source.h"
#include "roomcast/recording/import/bag_store.h"
#include "roomcast/recording/import/realsense_bag.h"
#include "roomcast/recording/import/ros_cameras.h"

namespace roomcast::recording {
namespace {

using OpenedSensors = Result<std::vector<std::unique_ptr<SensorFile>>>;

OpenedSensors sensors_of(const Result<std::shared_ptr<RosStore>>& store,
                         const std::filesystem::path& path) {
  const auto named = [&](const Error& error) {
    return Error{error.code, path.string() + ": " + error.message};
  };
  if (!store) return named(store.error());
  auto sensors = is_realsense(**store) ? realsense_sensors(*store, path.string())
                                       : ros_sensors(*store, path.string());
  if (!sensors) return named(sensors.error());
  return sensors;
}

}  // namespace

OpenedSensors open_ros1_bag(const std::filesystem::path& path) {
  auto source = open_file(path);
  if (!source) return source.error();
  return sensors_of(read_bag_store(*std::move(source)), path);
}

}  // namespace roomcast::recording
