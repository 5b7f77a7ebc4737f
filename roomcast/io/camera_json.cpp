// SPDX-License-Identifier: Apache-2.0
#include "roomcast/io/camera_json.h"

#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "roomcast/io/json_fields.h"

namespace roomcast::io {
namespace {

constexpr double kMinFocal = 0.05, kMaxFocal = 100;  // times the picture's width
constexpr double kLargestDepthScale = 1;             // one metre per unit
constexpr double kLargestDepthBias_m = 0.5;
constexpr double kQuaternionTolerance = 1e-3;
constexpr std::uint64_t kLargestDepthValue = std::numeric_limits<std::uint16_t>::max();

void read_lens(const JsonFields& fields, CameraIntrinsics& camera) {
  camera.fx = fields.number("fx");
  camera.fy = fields.number("fy");
  camera.cx = fields.number("cx");
  camera.cy = fields.number("cy");
  camera.k1 = fields.number("k1", 0);
  camera.k2 = fields.number("k2", 0);
  camera.k3 = fields.number("k3", 0);
  camera.p1 = fields.number("p1", 0);
  camera.p2 = fields.number("p2", 0);
}

CameraIntrinsics read_camera(const JsonFields& fields) {
  CameraIntrinsics camera;
  camera.width = fields.integer("width");
  camera.height = fields.integer("height");
  read_lens(fields, camera);
  if (fields.text("distortion_model", "brown_conrady") != "brown_conrady") {
    fields.reject("distortion_model", "must be brown_conrady");
  }
  return camera;
}

void without_color(RecordedCamera& camera) {
  camera.has_color = false;
  camera.calibration.color = camera.calibration.depth;
  camera.calibration.color_is_registered = true;
}

void read_rig_form(const JsonFields& fields, RecordedCamera& camera) {
  SensorCalibration& calibration = camera.calibration;
  calibration.depth = read_camera(fields.object("depth"));
  if (!fields.has("color")) return without_color(camera);
  calibration.color = read_camera(fields.object("color"));
  calibration.color_is_registered = fields.boolean("color_is_registered", false);
  if (fields.has("color_from_depth") || !calibration.color_is_registered) {
    calibration.color_from_depth = fields.transform("color_from_depth");
  }
}

Eigen::Vector3d read_vector(const JsonFields& fields, const char* field) {
  const std::vector<double> numbers = fields.numbers(field);
  if (numbers.size() == 3) return {numbers[0], numbers[1], numbers[2]};
  fields.reject(field, "must be 3 numbers");
  return Eigen::Vector3d::Zero();
}

Eigen::Matrix3d read_rotation(const JsonFields& fields, const char* field) {
  const std::vector<double> q = fields.numbers(field);
  if (q.size() == 4) {
    const Eigen::Quaterniond rotation(q[3], q[0], q[1], q[2]);
    if (std::abs(rotation.norm() - 1) < kQuaternionTolerance) {
      return rotation.normalized().toRotationMatrix();
    }
  }
  fields.reject(field, "must be a unit quaternion, x y z w");
  return Eigen::Matrix3d::Identity();
}

void read_flat_color(const JsonFields& fields, RecordedCamera& camera) {
  SensorCalibration& calibration = camera.calibration;
  const bool estimated = fields.has("colour_intrinsics_estimated");
  const JsonFields color =
      fields.object(estimated ? "colour_intrinsics_estimated" : "colour_intrinsics");
  read_lens(color, calibration.color);
  if (color.has("depth_to_colour_translation_m")) {
    calibration.color_from_depth.translation_m =
        read_vector(color, "depth_to_colour_translation_m");
  } else if (fields.has("colour_tf_recorded")) {
    const JsonFields recorded = fields.object("colour_tf_recorded");
    calibration.color_from_depth = {read_rotation(recorded, "rotation_xyzw"),
                                    read_vector(recorded, "translation_m")};
  }
}

void read_flat_form(const JsonFields& fields, RecordedCamera& camera) {
  SensorCalibration& calibration = camera.calibration;
  calibration.depth.width = fields.integer("width");
  calibration.depth.height = fields.integer("height");
  calibration.color = calibration.depth;
  read_lens(fields.object("depth_intrinsics"), calibration.depth);
  if (!fields.has("colour_registered_to_depth")) return without_color(camera);
  calibration.color_is_registered = fields.boolean("colour_registered_to_depth", false);
  if (calibration.color_is_registered) {
    calibration.color = calibration.depth;
  } else {
    read_flat_color(fields, camera);
  }
}

void read_depth_values(const JsonFields& fields, RecordedCamera& camera) {
  camera.depth_scale_to_metre = fields.number("depth_scale_to_metre", 0.001);
  if (!(camera.depth_scale_to_metre > 0) || camera.depth_scale_to_metre > kLargestDepthScale) {
    fields.reject("depth_scale_to_metre", "must be above 0 and at most 1");
  }
  camera.depth_bias_m = fields.number("depth_bias_m", 0);
  if (!(std::abs(camera.depth_bias_m) <= kLargestDepthBias_m))
    fields.reject("depth_bias_m", "must be within half a metre");
  camera.invalid_depth = {0};
  for (const std::uint64_t value : fields.counts("invalid_depth", kLargestDepthValue)) {
    camera.invalid_depth.push_back(static_cast<std::uint16_t>(value));
  }
}

/// Numbers that no lens has come from mistakes, such as metres in place of pixels. Empty: none.
std::string mistake_in(const CameraIntrinsics& camera) {
  const double width = camera.width, height = camera.height;
  const auto is_focal = [&](double f) { return f >= kMinFocal * width && f <= kMaxFocal * width; };
  if (!is_focal(camera.fx) || !is_focal(camera.fy))
    return "has a focal length (fx, fy) that no lens of this picture's width has, in pixels";
  const auto is_near = [](double centre, double side) {
    return centre >= -side && centre <= 2 * side;
  };
  if (!is_near(camera.cx, width) || !is_near(camera.cy, height))
    return "has its centre (cx, cy) far outside the picture";
  return {};
}

void check_cameras(const JsonFields& fields, const SensorCalibration& calibration) {
  const auto check = [&](const char* name, const CameraIntrinsics& camera) {
    if (const Status status = camera.check(); !status.ok()) {
      fields.reject(name, "is refused: " + status.error().message);
    } else if (const std::string mistake = mistake_in(camera); !mistake.empty()) {
      fields.reject(name, mistake);
    }
  };
  check("depth", calibration.depth);
  check("color", calibration.color);
  const bool same_grid = calibration.color.width == calibration.depth.width &&
                         calibration.color.height == calibration.depth.height;
  if (calibration.color_is_registered && !same_grid) {
    fields.reject("color", "must have the size of depth where colour is registered");
  }
}

nlohmann::json camera_as_json(const CameraIntrinsics& camera) {
  return {
      {"width", camera.width}, {"height", camera.height}, {"fx", camera.fx},
      {"fy", camera.fy},       {"cx", camera.cx},         {"cy", camera.cy},
      {"k1", camera.k1},       {"k2", camera.k2},         {"k3", camera.k3},
      {"p1", camera.p1},       {"p2", camera.p2},         {"distortion_model", "brown_conrady"}};
}

}  // namespace

Result<RecordedCamera> read_camera_json(const std::filesystem::path& path) {
  const auto json = read_json_object(path);
  if (!json.ok()) return json.error();
  JsonProblems problems(path);
  const JsonFields fields(*json, "", problems);
  RecordedCamera camera;
  if (fields.has("depth_intrinsics")) {
    read_flat_form(fields, camera);
  } else {
    read_rig_form(fields, camera);
  }
  read_depth_values(fields, camera);
  check_cameras(fields, camera.calibration);
  if (const Status status = problems.status(); !status.ok()) return status.error();
  return camera;
}

std::string camera_json_text(const RecordedCamera& camera) {
  const SensorCalibration& calibration = camera.calibration;
  nlohmann::json json = {{"depth", camera_as_json(calibration.depth)},
                         {"depth_scale_to_metre", camera.depth_scale_to_metre},
                         {"depth_bias_m", camera.depth_bias_m},
                         {"invalid_depth", camera.invalid_depth}};
  if (camera.has_color) {
    json["color"] = camera_as_json(calibration.color);
    json["color_from_depth"] = row_major_from_transform(calibration.color_from_depth);
    json["color_is_registered"] = calibration.color_is_registered;
  }
  return json.dump(1) + "\n";
}

std::string camera_json_text(const SensorCalibration& calibration) {
  return camera_json_text(RecordedCamera{.calibration = calibration});
}

}  // namespace roomcast::io
