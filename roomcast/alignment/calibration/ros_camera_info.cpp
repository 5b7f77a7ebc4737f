// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/calibration/ros_camera_info.h"

#include <vector>

#include <yaml-cpp/yaml.h>

#include "roomcast/io/file_bytes.h"

namespace roomcast::alignment::calibration {
namespace {

constexpr std::size_t kMatrixNumbers = 9, kLensNumbers = 5;

std::vector<double> numbers(const YAML::Node& file, const char* name, std::size_t count) {
  auto data = file[name]["data"].as<std::vector<double>>();
  if (data.size() != count) throw YAML::Exception(YAML::Mark(), "another count of numbers");
  return data;
}

/// yaml-cpp throws for missing fields and invalid numbers; the caller catches that.
CameraIntrinsics camera_of(const YAML::Node& file) {
  CameraIntrinsics camera;
  camera.width = file["image_width"].as<int>();
  camera.height = file["image_height"].as<int>();
  const auto matrix = numbers(file, "camera_matrix", kMatrixNumbers);
  camera.fx = matrix[0], camera.cx = matrix[2];
  camera.fy = matrix[4], camera.cy = matrix[5];
  const auto lens = numbers(file, "distortion_coefficients", kLensNumbers);
  camera.k1 = lens[0], camera.k2 = lens[1];
  camera.p1 = lens[2], camera.p2 = lens[3];
  camera.k3 = lens[4];
  return camera;
}

}  // namespace

Result<CameraIntrinsics> parse_camera_info(const std::string& yaml) {
  try {
    const YAML::Node file = YAML::Load(yaml);
    const auto model = file["distortion_model"].as<std::string>("plumb_bob");
    if (model != "plumb_bob") {
      return Error{ErrorCode::kUnsupported,
                   "the lens model " + model.substr(0, 40) + " is not supported, only plumb_bob"};
    }
    const CameraIntrinsics camera = camera_of(file);
    if (Status status = camera.check(); !status) return status.error();
    return camera;
  } catch (const YAML::Exception&) {
    return Error{ErrorCode::kMalformed,
                 "it is not a camera_info of ROS: image_width, image_height, 9 numbers in "
                 "camera_matrix.data and 5 in distortion_coefficients.data are needed"};
  }
}

Result<CameraIntrinsics> read_camera_info(const std::filesystem::path& file) {
  std::vector<std::uint8_t> bytes;
  if (Status status = io::read_file(file, kMaxCameraInfoBytes, bytes); !status)
    return status.error();
  auto camera = parse_camera_info({bytes.begin(), bytes.end()});
  if (camera) return camera;
  return Error{camera.error().code, file.string() + ": " + camera.error().message};
}

}  // namespace roomcast::alignment::calibration
