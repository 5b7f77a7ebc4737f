// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/sensor_profile.h"

#include <Eigen/Geometry>

#include "roomcast/simulator/sensing/axial_noise.h"

namespace roomcast::simulator {
namespace {

CameraIntrinsics lens(int width, int height, double focal, double cx, double cy) {
  CameraIntrinsics camera;
  camera.width = width;
  camera.height = height;
  camera.fx = camera.fy = focal;
  camera.cx = cx;
  camera.cy = cy;
  return camera;
}

RigidTransform turned_and_shifted(double pitch, double yaw, double roll,
                                  const Eigen::Vector3d& shift_m) {
  const Eigen::Matrix3d rotation = (Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitX()) *
                                    Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitY()) *
                                    Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitZ()))
                                       .toRotationMatrix();
  return {rotation, shift_m};
}

/// Depth lens: fitted to the factory ray table of a real Kinect v2 (published at
/// github.com/Vaufreyd/RGBDSyncSDK). Colour: the usual nominal focal length, 52 mm from the depth
/// camera. The depth picture (60 degrees) is taller than the colour picture (54), as in the device.
/// Range: specified as 0.5 to 4.5 m; drivers report up to about 8 m.
SensorProfile kinect2() {
  SensorProfile profile;
  profile.model = CameraModel::kKinect2;
  profile.nominal.depth = lens(512, 424, 364.478, 252.95, 205.88);
  profile.nominal.depth.k1 = 0.0984;
  profile.nominal.depth.k2 = -0.2811;
  profile.nominal.depth.k3 = 0.0952;
  profile.nominal.color = lens(1920, 1080, 1064.0, 959.5, 539.5);
  profile.nominal.color.k1 = 0.018;
  profile.nominal.color.k2 = -0.033;
  profile.nominal.color.p1 = 0.0004;
  profile.nominal.color.p2 = -0.0003;
  profile.nominal.color_from_depth =
      turned_and_shifted(0.0026, 0.0051, -0.0022, {-0.052, 0.0002, -0.0005});
  profile.nearest_m = 0.5F;
  profile.farthest_m = 8.0F;
  profile.lateral_sigma_mm = 1.6F;  // Fankhauser et al. 2015, indoors, nearly constant over range
  profile.lost_signal = 0.0020F;    // ours, as are all shares of lost readings
  profile.safe_signal = 0.0060F;
  // The return of a white wall at the minimum specified range: matt surfaces saturate only nearer.
  profile.saturating_signal = 1.0F / (profile.nearest_m * profile.nearest_m);
  profile.lost_at_edge = 0.45F;
  profile.bias_offset_mm = 3.0F;
  profile.bias_wave_mm = 2.0F;
  profile.bias_wiggle_mm = 1.5F;
  return profile;
}

/// Lenses: nominal focal lengths from the specified field of view (75 x 65 degrees for the narrow
/// mode, 90 x 59 for colour); the Brown-Conrady terms, which replace the device's rational model,
/// are ours, and so is the rectangular picture (the device's narrow mode is cut at the corners).
/// Range and error bounds (17 mm random, 11 mm + 0.1 % systematic): Azure Kinect hardware
/// specification; confirmed by Toelgyessy et al., Sensors 21(2), 2021. Orbbec's Femto Bolt has the
/// same depth module and modes.
SensorProfile azure() {
  SensorProfile profile = kinect2();
  profile.model = CameraModel::kAzure;
  profile.nominal.depth = lens(640, 576, 504.0, 320.5, 333.0);
  profile.nominal.depth.k1 = 0.10;
  profile.nominal.depth.k2 = -0.18;
  profile.nominal.depth.k3 = 0.05;
  profile.nominal.color = lens(1920, 1080, 914.0, 958.0, 548.0);
  profile.nominal.color.k1 = 0.08;
  profile.nominal.color.k2 = -0.10;
  profile.nominal.color.k3 = 0.03;
  profile.nominal.color_from_depth =
      turned_and_shifted(0.105, 0.002, 0.001, {-0.032, -0.002, 0.004});  // tilted by 6 degrees
  profile.farthest_m = 5.5F;
  profile.bias_offset_mm = 3.0F;
  profile.bias_wave_mm = 1.5F;
  profile.bias_wiggle_mm = 1.5F;
  return profile;
}

/// Depth: rectified, so no distortion; 90 degrees at 848 pixels give f = 424; baseline 50 mm (Intel
/// D400 series datasheet). Colour: 69 degrees, at a distance of 14 mm. A disparity error of 0.08 px
/// is within the range that Intel's tuning paper calls well adjusted; 0.03 px of smooth error
/// corresponds to the datasheet's accuracy of about 2 % at 2 m; most units have much less.
SensorProfile d435() {
  SensorProfile profile;
  profile.model = CameraModel::kD435;
  profile.principle = DepthPrinciple::kStereo;
  profile.nominal.depth = lens(848, 480, 424.0, 424.5, 240.5);
  profile.nominal.color = lens(1920, 1080, 1386.0, 957.0, 541.0);
  profile.nominal.color_from_depth =
      turned_and_shifted(0.0005, -0.003, 0.002, {0.0143, 0.0006, 0.0006});
  profile.nearest_m = 0.28F;
  profile.farthest_m = 10.0F;
  profile.lateral_sigma_mm = 2.0F;  // ours
  profile.lost_signal = 0.0006F;
  profile.safe_signal = 0.0025F;
  profile.lost_at_edge = 0.30F;
  profile.baseline_mm = 50.0F;
  profile.subpixel = 0.08F;
  profile.bias_disparity_px = 0.03F;
  return profile;
}

/// Depth: 640x480 with f = 585, baseline 75 mm, disparities in eighths of a pixel (Konolige and
/// Mihelich, "Technical description of Kinect calibration", ROS wiki 2010). Disparity noise of half
/// a step: Khoshelham and Oude Elberink, "Accuracy and resolution of Kinect depth data for indoor
/// mapping applications", Sensors 12(2), 2012. Smooth disparity error: Herrera, Kannala, Heikkila,
/// "Joint depth and color camera calibration with distortion correction", PAMI 34(10), 2012.
SensorProfile kinect1() {
  SensorProfile profile;
  profile.model = CameraModel::kKinect1;
  profile.principle = DepthPrinciple::kStructuredLight;
  profile.nominal.depth = lens(640, 480, 585.0, 319.5, 239.5);
  profile.nominal.color = lens(640, 480, 525.0, 319.5, 239.5);
  profile.nominal.color_from_depth = turned_and_shifted(0, 0, 0, {0.025, 0, 0});
  profile.nearest_m = 0.5F;
  profile.farthest_m = 6.0F;
  profile.lateral_sigma_mm = 3.0F;  // ours
  profile.lost_signal = 0.0015F;    // ours
  profile.safe_signal = 0.0060F;
  profile.lost_at_edge = 0.30F;
  profile.baseline_mm = 75.0F;
  profile.subpixel = 0.0625F;
  profile.disparity_step_px = 0.125F;
  profile.bias_disparity_px = 0.10F;
  return profile;
}

/// Bins pixels two by two; pixel centres are at integer coordinates.
CameraIntrinsics halved(CameraIntrinsics camera) {
  camera.width /= 2;
  camera.height /= 2;
  camera.fx *= 0.5;
  camera.fy *= 0.5;
  camera.cx = 0.5 * (camera.cx + 0.5) - 0.5;
  camera.cy = 0.5 * (camera.cy + 0.5) - 0.5;
  return camera;
}

}  // namespace

float SensorProfile::axial_sigma_mm(float z_m, float theta) const {
  switch (model) {
    case CameraModel::kKinect2:
      return kinect2_sigma_mm(z_m, theta);
    case CameraModel::kAzure:
      return azure_sigma_mm(z_m, theta);
    case CameraModel::kD435:
    case CameraModel::kKinect1:
      break;
  }
  return stereo_sigma_mm(z_m, static_cast<float>(nominal.depth.fx), baseline_mm, subpixel);
}

namespace {

SensorProfile full_profile_of(CameraModel model) {
  switch (model) {
    case CameraModel::kKinect2:
      return kinect2();
    case CameraModel::kAzure:
      return azure();
    case CameraModel::kD435:
      return d435();
    case CameraModel::kKinect1:
      break;
  }
  return kinect1();
}

}  // namespace

SensorProfile profile_of(CameraModel model, bool half_color) {
  constexpr int kAlreadySmall_px = 1000;
  SensorProfile profile = full_profile_of(model);
  if (half_color && profile.nominal.color.width > kAlreadySmall_px)
    profile.nominal.color = halved(profile.nominal.color);
  return profile;
}

}  // namespace roomcast::simulator
