// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/ros_recording.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "roomcast/recording/bytes/byte_source.h"
#include "roomcast/recording/import/bag_store.h"
#include "roomcast/recording/import/realsense_bag.h"
#include "roomcast/recording/import/ros2_store.h"
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

OpenedSensors open_ros2_recording(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::path file = path;
  // The folder of a recording of one part: metadata.yaml beside it is not needed.
  for (std::filesystem::directory_iterator at(path, error), end; !error && at != end;
       at.increment(error)) {
    const auto ending = at->path().extension();
    if (ending != ".mcap" && ending != ".db3") continue;
    if (file != path)
      return Error{ErrorCode::kUnsupported,
                   path.string() + " has several parts; import them one by one"};
    file = at->path();
  }
  auto source = open_file(file);
  if (!source) return source.error();
  constexpr std::string_view kSqlite("SQLite format 3\0", 16);
  std::array<std::uint8_t, kSqlite.size()> start{};
  const bool is_sqlite =
      (*source)->read(0, start).ok() && std::equal(start.begin(), start.end(), kSqlite.begin());
  auto store = is_sqlite ? open_sqlite_store(file) : open_mcap_store(file);
  if (!store) return store.error();
  return sensors_of(store, file);
}

}  // namespace roomcast::recording
