// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/azure_kinect_calibration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "roomcast/geometry/rational_lens.h"

namespace roomcast::recording {
namespace {

using nlohmann::json;

/// How a mode makes its picture of the sensor: binned to a size, then cropped.
struct Mode {
  int binned_width, binned_height, crop_x, crop_y, width, height;
  double largest_radius;  // of rays with readings
};

constexpr double kNarrow = 1.05;  // 75 x 65 degrees
constexpr double kWide = 1.74;    // 120 degrees
/// Colour beyond what depth of the narrow modes sees is not used.
constexpr double kColorOfNarrow = 1.1;

std::optional<Mode> depth_mode_of(std::string_view name) {
  if (name == "NFOV_2X2BINNED") return Mode{512, 512, 96, 90, 320, 288, kNarrow};
  if (name == "NFOV_UNBINNED") return Mode{1024, 1024, 192, 180, 640, 576, kNarrow};
  if (name == "WFOV_2X2BINNED") return Mode{512, 512, 0, 0, 512, 512, kWide};
  if (name == "WFOV_UNBINNED") return Mode{1024, 1024, 0, 0, 1024, 1024, kWide};
  return std::nullopt;
}

std::optional<Mode> color_mode_of(int height, bool narrow) {
  const double radius = narrow ? kColorOfNarrow : kWide;
  switch (height) {
    case 720:
      return Mode{1280, 960, 0, 120, 1280, 720, radius};
    case 1080:
      return Mode{1920, 1440, 0, 180, 1920, 1080, radius};
    case 1440:
      return Mode{2560, 1920, 0, 240, 2560, 1440, radius};
    case 1536:
      return Mode{2048, 1536, 0, 0, 2048, 1536, radius};
    case 2160:
      return Mode{3840, 2880, 0, 360, 3840, 2160, radius};
    case 3072:
      return Mode{4096, 3072, 0, 0, 4096, 3072, radius};
    default:
      return std::nullopt;
  }
}

/// The finite numbers of an array; nothing if it is none, has fewer, or an entry is not a number.
template <std::size_t kCount>
std::optional<std::array<double, kCount>> numbers_of(const json& object, const char* field) {
  const auto found = object.find(field);
  if (found == object.end() || !found->is_array() || found->size() < kCount) return std::nullopt;
  std::array<double, kCount> numbers{};
  for (std::size_t i = 0; i < kCount; ++i) {
    if (!(*found)[i].is_number()) return std::nullopt;
    numbers[i] = (*found)[i].get<double>();
    if (!std::isfinite(numbers[i])) return std::nullopt;
  }
  return numbers;
}

struct RawCamera {
  std::array<double, 14> lens{};  // cx cy fx fy k1 k2 k3 k4 k5 k6 codx cody p2 p1
  RigidTransform camera_from_origin;
  bool is_legacy_wide = false;  // of a 16:9 sensor
  bool is_rational_6kt = false;
};

const json* object_in(const json& object, const char* field) {
  const auto found = object.find(field);
  return found != object.end() && found->is_object() ? &*found : nullptr;
}

std::optional<RigidTransform> pose_of(const json& camera) {
  const json* const pose = object_in(camera, "Rt");
  if (pose == nullptr) return std::nullopt;
  const auto r = numbers_of<9>(*pose, "Rotation");
  const auto t = numbers_of<3>(*pose, "Translation");
  if (!r || !t) return std::nullopt;
  const std::array<double, 16> rows = {(*r)[0], (*r)[1], (*r)[2], (*t)[0], (*r)[3], (*r)[4],
                                       (*r)[5], (*t)[1], (*r)[6], (*r)[7], (*r)[8], (*t)[2],
                                       0,       0,       0,       1};
  const auto transform = transform_from_row_major(rows);
  if (!transform) return std::nullopt;
  return *transform;
}

std::string text_in(const json& object, const char* field) {
  const auto found = object.find(field);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::optional<RawCamera> raw_camera(const json& cameras, std::string_view location) {
  for (const json& camera : cameras) {
    if (!camera.is_object() || text_in(camera, "Location") != location) continue;
    const json* const intrinsics = object_in(camera, "Intrinsics");
    const auto pose = pose_of(camera);
    if (intrinsics == nullptr || !pose) return std::nullopt;
    const auto lens = numbers_of<14>(*intrinsics, "ModelParameters");
    const auto size_x = camera.find("SensorWidth"), size_y = camera.find("SensorHeight");
    const bool has_size = size_x != camera.end() && size_y != camera.end() &&
                          size_x->is_number_integer() && size_y->is_number_integer();
    if (!lens || !has_size) return std::nullopt;
    const double ratio = size_x->get<double>() * 9 - size_y->get<double>() * 16;
    return RawCamera{*lens, *pose, ratio == 0,
                     text_in(*intrinsics, "ModelType").find("Rational6KT") != std::string::npos};
  }
  return std::nullopt;
}

RationalLens raw_lens(const RawCamera& raw, const Mode& mode) {
  const auto& v = raw.lens;
  double cx = v[0], cy = v[1], fx = v[2], fy = v[3];
  if (raw.is_legacy_wide) {  // a 16:9 part of a 4:3 sensor
    cy = (cy * 2304 + 384) / 3072;
    fy = fy * 2304 / 3072;
  }
  RationalLens lens;
  lens.camera.width = mode.width, lens.camera.height = mode.height;
  lens.camera.fx = fx * mode.binned_width, lens.camera.fy = fy * mode.binned_height;
  lens.camera.cx = cx * mode.binned_width - mode.crop_x - 0.5;  // measured from pixels' corners
  lens.camera.cy = cy * mode.binned_height - mode.crop_y - 0.5;
  lens.camera.k1 = v[4], lens.camera.k2 = v[5], lens.camera.k3 = v[6];
  lens.k4 = v[7], lens.k5 = v[8], lens.k6 = v[9];
  lens.camera.p1 = v[13], lens.camera.p2 = v[12];
  return lens;
}

Error not_calibration() {
  return malformed("its calibration.json is not that of an Azure Kinect");
}

Result<ConvertedLens> convert(const RawCamera& raw, const Mode& mode) {
  // That older model halves the mixed tangential terms, and its centre of distortion can be moved.
  const bool has_old_terms = raw.lens[12] != 0 || raw.lens[13] != 0;
  const bool is_other =
      (raw.is_rational_6kt && has_old_terms) || raw.lens[10] != 0 || raw.lens[11] != 0;
  if (is_other)
    return Error{ErrorCode::kUnsupported, "its lens model is not supported: Rational6KT"};
  return polynomial_lens(raw_lens(raw, mode), mode.largest_radius);
}

}  // namespace

Result<AzureKinectCalibration> read_azure_kinect_calibration(std::span<const std::uint8_t> text,
                                                             const std::string& depth_mode,
                                                             int color_height) {
  const auto mode = depth_mode_of(depth_mode);
  if (!mode)
    return Error{ErrorCode::kUnsupported, "it has no depth: its mode is \"" + depth_mode + "\""};
  const json root =
      json::parse(text.begin(), std::find(text.begin(), text.end(), 0), nullptr, false);
  const json* const all = root.is_object() ? object_in(root, "CalibrationInformation") : nullptr;
  const auto cameras = all != nullptr ? all->find("Cameras") : json::const_iterator();
  if (all == nullptr || cameras == all->end() || !cameras->is_array()) return not_calibration();
  const auto depth = raw_camera(*cameras, "CALIBRATION_CameraLocationD0");
  if (!depth) return not_calibration();
  const auto depth_lens = convert(*depth, *mode);
  if (!depth_lens) return depth_lens.error();
  AzureKinectCalibration calibration;
  calibration.cameras = {depth_lens->camera, depth_lens->camera, {}, true};
  calibration.depth_error_px = depth_lens->largest_error_px;
  if (color_height == 0) return calibration;
  const auto color_mode = color_mode_of(color_height, mode->largest_radius == kNarrow);
  if (!color_mode)
    return Error{ErrorCode::kUnsupported, "its colour mode is not one of an Azure Kinect"};
  const auto color = raw_camera(*cameras, "CALIBRATION_CameraLocationPV0");
  if (!color) return not_calibration();
  const auto color_lens = convert(*color, *color_mode);
  if (!color_lens) return color_lens.error();
  calibration.cameras.color = color_lens->camera;
  calibration.cameras.color_from_depth =
      color->camera_from_origin * depth->camera_from_origin.inverse();
  calibration.cameras.color_is_registered = false;
  calibration.color_error_px = color_lens->largest_error_px;
  return calibration;
}

}  // namespace roomcast::recording
