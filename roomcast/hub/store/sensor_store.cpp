// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/store/sensor_store.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <utility>

#include "roomcast/geometry/sensor_pose.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {

namespace {

constexpr char kLoad[] =
    "SELECT name, id, world_from_depth, expected_error_mm, depth_scale "
    "FROM sensors WHERE room = ?1 ORDER BY id";
constexpr char kSave[] = "INSERT OR REPLACE INTO sensors VALUES (?1, ?2, ?3, ?4, ?5, ?6)";
constexpr char kForget[] = "DELETE FROM sensors WHERE room = ?1";
constexpr char kForgetOne[] = "DELETE FROM sensors WHERE room = ?1 AND name = ?2";

std::optional<SensorPose> read_pose(const Statement& row, int column) {
  std::array<double, 16> row_major{};
  const std::string_view bytes = row.blob(column);
  if (bytes.size() != sizeof(row_major)) return std::nullopt;
  std::memcpy(row_major.data(), bytes.data(), bytes.size());
  const auto expected_error_mm = static_cast<float>(row.real(column + 1));
  const double depth_scale = row.real(column + 2);
  const bool makes_sense =
      std::ranges::all_of(row_major, [](double x) { return std::isfinite(x); }) &&
      expected_error_mm >= 0 && depth_scale >= wire::kMinDepthScale &&
      depth_scale <= wire::kMaxDepthScale;
  if (!makes_sense) return std::nullopt;
  return SensorPose{.world_from_depth = exact_transform_from_row_major(row_major),
                    .source = PoseSource::kStored,
                    .state = PoseState::kUnverified,
                    .expected_error_mm = expected_error_mm,
                    .depth_scale = depth_scale};
}

std::optional<KnownSensor> read_sensor(const Statement& row) {
  const std::int64_t id = row.integer(1);
  if (id < 0 || id >= std::int64_t{wire::kMaxSensors}) return std::nullopt;
  return KnownSensor{row.text(0), SensorId{static_cast<std::uint16_t>(id)}, read_pose(row, 2)};
}

}  // namespace

Result<std::vector<KnownSensor>> SensorStore::load(const std::string& room) const {
  Statement rows(database_, kLoad);
  rows.bind(1, room);
  std::vector<KnownSensor> sensors;
  while (rows.next()) {
    if (auto sensor = read_sensor(rows)) sensors.push_back(*std::move(sensor));
  }
  if (!rows.finished()) return database_.failure("cannot read the stored sensors");
  return sensors;
}

Status SensorStore::save(const std::string& room, std::span<const KnownSensor> sensors) {
  return database_.in_transaction([&]() -> Status {
    for (const KnownSensor& sensor : sensors) {
      Statement statement(database_, kSave);
      statement.bind(1, room).bind(2, sensor.name).bind(3, std::int64_t{sensor.id.value});
      if (sensor.pose) {
        const auto row_major = row_major_from_transform(sensor.pose->world_from_depth);
        statement.bind_blob(4, row_major.data(), sizeof(row_major));
        statement.bind(5, sensor.pose->expected_error_mm);
      }
      statement.bind(6, sensor.pose ? sensor.pose->depth_scale : 1.0);
      if (!statement.run()) return database_.failure("cannot store a sensor");
    }
    return {};
  });
}

Status SensorStore::forget(const std::string& room) {
  if (Statement(database_, kForget).bind(1, room).run()) return {};
  return database_.failure("cannot forget the sensors of a room");
}

Status SensorStore::forget(const std::string& room, const std::string& sensor) {
  Statement row(database_, kForgetOne);
  if (!row.bind(1, room).bind(2, sensor).run()) return database_.failure("cannot forget a sensor");
  if (database_.changed_rows() > 0) return {};
  return Error{ErrorCode::kNotFound, "this room has no sensor \"" + sensor + "\""};
}

}  // namespace roomcast::hub
