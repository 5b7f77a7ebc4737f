// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/dataset/rig_json.h"

#include <algorithm>
#include <cmath>

#include "roomcast/io/json_fields.h"

namespace roomcast::recording {
namespace {

constexpr int kVersion = 1;
constexpr double kLargestClockOffset_s = 4e9;  // a device time from 0 against the time of day
constexpr double kLargestRate_ppm = 1e4;
constexpr double kMinDepthScale = 0.5;
constexpr double kMaxDepthScale = 2;
constexpr double kLargestError_mm = 1e6;
constexpr std::uint64_t kLargestFrameNumber = 1U << 31U;

double limited(const io::JsonFields& fields, const char* field, double largest) {
  const double value = fields.number(field, 0);
  if (!(std::abs(value) <= largest)) fields.reject(field, "is far too large");
  return value;
}

double error_within(const io::JsonFields& fields, const char* field, double largest) {
  const double error = limited(fields, field, largest);
  if (error < 0) fields.reject(field, "must not be negative");
  return error;
}

RigSensorEntry read_sensor(const io::JsonFields& fields) {
  RigSensorEntry sensor;
  sensor.id = fields.text("id");
  if (!is_sensor_name(sensor.id)) fields.reject("id", "must be a name of 1 to 64 bytes");
  sensor.path = fields.text("path", sensor.id);
  if (!stays_inside(sensor.path)) fields.reject("path", "must stay inside the rig's folder");
  if (fields.has("world_from_depth"))
    sensor.world_from_depth = fields.transform("world_from_depth");
  sensor.clock_offset_s = limited(fields, "clock_offset_s", kLargestClockOffset_s);
  sensor.rate_ppm = limited(fields, "rate_ppm", kLargestRate_ppm);
  sensor.drop = fields.counts("drop", kLargestFrameNumber);
  sensor.depth_scale = fields.number("depth_scale", 1);
  if (!is_depth_scale(sensor.depth_scale)) fields.reject("depth_scale", "must be 0.5 to 2");
  sensor.expected_error_mm = error_within(fields, "expected_error_mm", kLargestError_mm);
  return sensor;
}

void check_sensors(const io::JsonFields& fields, const std::vector<RigSensorEntry>& sensors) {
  if (sensors.empty() || sensors.size() > kMaxRigSensors) {
    fields.reject("sensors", "must list 1 to " + std::to_string(kMaxRigSensors) + " sensors");
  }
  for (auto sensor = sensors.begin(); sensor != sensors.end(); ++sensor) {
    const auto same_id = [&](const RigSensorEntry& other) { return other.id == sensor->id; };
    if (std::any_of(sensors.begin(), sensor, same_id)) {
      fields.reject("sensors", "has two sensors with the id " + sensor->id);
    }
  }
}

nlohmann::json sensor_as_json(const RigSensorEntry& sensor) {
  nlohmann::json json = {{"id", sensor.id},
                         {"path", sensor.path.string()},
                         {"world_from_depth", nullptr},
                         {"clock_offset_s", sensor.clock_offset_s},
                         {"rate_ppm", sensor.rate_ppm},
                         {"drop", sensor.drop}};
  if (sensor.world_from_depth) {
    json["world_from_depth"] = row_major_from_transform(*sensor.world_from_depth);
  }
  if (sensor.depth_scale != 1) json["depth_scale"] = sensor.depth_scale;
  if (sensor.expected_error_mm != 0) json["expected_error_mm"] = sensor.expected_error_mm;
  return json;
}

}  // namespace

bool is_sensor_name(const std::string& name) {
  const auto control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; };
  return !name.empty() && name.size() <= kMaxSensorNameBytes &&
         std::none_of(name.begin(), name.end(), control);
}

bool is_depth_scale(double scale) {
  return scale >= kMinDepthScale && scale <= kMaxDepthScale;
}

bool stays_inside(const std::filesystem::path& path) {
  return !path.empty() && path.is_relative() &&
         std::none_of(path.begin(), path.end(), [](const auto& part) { return part == ".."; });
}

Result<RigDescription> read_rig_json(const std::filesystem::path& path) {
  const auto json = io::read_json_object(path);
  if (!json.ok()) return json.error();
  io::JsonProblems problems(path);
  const io::JsonFields fields(*json, "", problems);
  if (fields.number("version", kVersion) != kVersion) {
    return Error{ErrorCode::kUnsupported,
                 path.string() + " has a version that this roomcast cannot read; use a newer one"};
  }
  RigDescription rig;
  rig.fps = fields.number("fps");
  if (!(rig.fps > 0 && rig.fps <= kMaxFps)) fields.reject("fps", "must be above 0 and at most 240");
  rig.source = fields.text("source", "");
  rig.scale_error = error_within(fields, "scale_error", 1);
  for (const io::JsonFields& sensor : fields.objects("sensors")) {
    rig.sensors.push_back(read_sensor(sensor));
  }
  check_sensors(fields, rig.sensors);
  if (const Status status = problems.status(); !status.ok()) return status.error();
  return rig;
}

std::string rig_json_text(const RigDescription& rig) {
  nlohmann::json json = {{"version", kVersion},
                         {"fps", rig.fps},
                         {"world", "y up, metres, right-handed"},
                         {"source", rig.source},
                         {"sensors", nlohmann::json::array()}};
  if (rig.scale_error != 0) json["scale_error"] = rig.scale_error;
  for (const RigSensorEntry& sensor : rig.sensors)
    json["sensors"].push_back(sensor_as_json(sensor));
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace roomcast::recording
