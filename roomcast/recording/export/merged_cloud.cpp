// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/export/merged_cloud.h"

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace roomcast::recording {
namespace {

Eigen::Isometry3f isometry(const RigidTransform& transform) {
  Eigen::Isometry3f result = Eigen::Isometry3f::Identity();
  result.linear() = transform.rotation.cast<float>();
  result.translation() = transform.translation_m.cast<float>();
  return result;
}

/// Weight of an observation: higher for frontal and near views.
float view_quality(const Eigen::Vector3f& point_m, const Eigen::Vector3f& normal) {
  const float distance = point_m.norm();
  return -normal.dot(point_m) / (distance * distance * distance);
}

/// The pixel's colour if the sensor has one, else grey.
Rgb8 color_at(const codec::DecodedFrame& pictures, int x, int y) {
  if (pictures.color.empty()) return {128, 128, 128};
  return pictures.color.at(x, y);
}

bool has_color(const codec::DecodedFrame& pictures, int x, int y) {
  return pictures.color_seen.empty() || pictures.color_seen.at(x, y) != 0;
}

constexpr int kVoxelBits = 21;

std::uint64_t voxel_of(const Eigen::Vector3f& point_m, float voxel_m) {
  const auto cell = [&](float coordinate_m) {
    const auto index = static_cast<std::int64_t>(std::floor(coordinate_m / voxel_m));
    return static_cast<std::uint64_t>(index) & ((std::uint64_t{1} << kVoxelBits) - 1);
  };
  return cell(point_m.x()) << (2 * kVoxelBits) | cell(point_m.y()) << kVoxelBits |
         cell(point_m.z());
}

struct VoxelSum {
  Eigen::Vector3f point_m = Eigen::Vector3f::Zero(), normal = Eigen::Vector3f::Zero(),
                  color = Eigen::Vector3f::Zero();
  float count = 0;
};

std::uint8_t rounded(float value) {
  return static_cast<std::uint8_t>(std::lround(value));
}

}  // namespace

Status MergedCloudOptions::check() const {
  if (crop_m && crop_m->isEmpty())
    return Error{ErrorCode::kInvalidArgument, "the crop box is empty; give two opposite corners"};
  if (!(voxel_m >= 0 && voxel_m <= 1))
    return Error{ErrorCode::kInvalidArgument, "the voxel size must be 0 to 1 m"};
  return {};
}

MergedCloud::MergedCloud(const std::vector<SetSensor>& sensors, MergedCloudOptions options)
    : options_(std::move(options)) {
  for (const SetSensor& sensor : sensors) points_.emplace_back(sensor.depth);
}

void MergedCloud::merge(const FrameSet& set, PointCloud& cloud) {
  cloud.clear();
  see(set);
  for (std::size_t i = 0; i < seen_.size(); ++i) add_points(i, cloud);
  if (options_.voxel_m > 0) thin_out(cloud, options_.voxel_m);
}

void MergedCloud::see(const FrameSet& set) {
  seen_.clear();
  for (const SetFrame& frame : set.frames) {
    if (!frame.world_from_depth && set.frames.size() > 1) continue;
    DepthPoints& points = points_[frame.sensor];
    const DepthImage& depth = frame.pictures->depth_mm;
    if (depth.width() != points.camera().width || depth.height() != points.camera().height)
      continue;
    points.set(depth);
    const auto pose = isometry(frame.world_from_depth.value_or(RigidTransform()));
    seen_.push_back({&frame, &points, pose, pose.inverse()});
  }
}

void MergedCloud::add_points(std::size_t sensor, PointCloud& cloud) const {
  const Seen& seen = seen_[sensor];
  const DepthPoints& points = *seen.points;
  for (int y = 0; y < points.camera().height; ++y) {
    for (int x = 0; x < points.camera().width; ++x) {
      if (!points.has(x, y)) continue;
      const Eigen::Vector3f world_m = seen.world_from_depth * points.point_m(x, y);
      if (options_.crop_m && !options_.crop_m->contains(world_m)) continue;
      const Eigen::Vector3f normal = seen.world_from_depth.linear() * points.normal(x, y);
      // Observations without colour get a lower quality, so that coloured ones are preferred.
      const float quality = view_quality(points.point_m(x, y), points.normal(x, y)) *
                            (has_color(*seen.frame->pictures, x, y) ? 1.0F : 0.01F);
      if (!options_.keep_doubles && another_sees_it_better(sensor, world_m, normal, quality))
        continue;
      cloud.add(world_m, normal, color_at(*seen.frame->pictures, x, y));
    }
  }
}

bool MergedCloud::another_sees_it_better(std::size_t sensor, const Eigen::Vector3f& world_m,
                                         const Eigen::Vector3f& normal, float quality) const {
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    if (i == sensor) continue;
    const Seen& other = seen_[i];
    const Eigen::Vector3f point_m = other.depth_from_world * world_m;
    const auto pixel = project(other.points->camera(), point_m.cast<double>());
    if (!pixel) continue;
    const int x = static_cast<int>(std::lround(pixel->x()));
    const int y = static_cast<int>(std::lround(pixel->y()));
    const CameraIntrinsics& camera = other.points->camera();
    if (x < 0 || y < 0 || x >= camera.width || y >= camera.height) continue;
    if (!other.points->has(x, y)) continue;
    // Maximum distance within one surface: noise of both readings, plus slant within a pixel.
    const float limit = 3 * reading_sigma_m(point_m.z()) + 0.02F;
    if (std::abs(other.points->z_m(x, y) - point_m.z()) > limit) continue;
    const Eigen::Vector3f there = other.depth_from_world.linear() * normal;
    if (there.dot(other.points->normal(x, y)) < 0.5F) continue;
    const float its = view_quality(other.points->point_m(x, y), other.points->normal(x, y)) *
                      (has_color(*other.frame->pictures, x, y) ? 1.0F : 0.01F);
    if (its > quality || (its == quality && i < sensor)) return true;
  }
  return false;
}

void thin_out(PointCloud& cloud, float voxel_m) {
  std::unordered_map<std::uint64_t, std::size_t> place_of;
  std::vector<VoxelSum> sums;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const auto [place, is_new] =
        place_of.try_emplace(voxel_of(cloud.points_m[i], voxel_m), sums.size());
    if (is_new) sums.emplace_back();
    VoxelSum& sum = sums[place->second];
    sum.point_m += cloud.points_m[i];
    sum.normal += cloud.normals[i];
    sum.color += Eigen::Vector3f(cloud.colors[i].r, cloud.colors[i].g, cloud.colors[i].b);
    ++sum.count;
  }
  cloud.clear();
  for (const VoxelSum& sum : sums) {
    const Eigen::Vector3f color = sum.color / sum.count;
    const float length = sum.normal.norm();
    cloud.add(sum.point_m / sum.count,
              length > 0 ? Eigen::Vector3f(sum.normal / length) : Eigen::Vector3f::UnitY().eval(),
              {rounded(color.x()), rounded(color.y()), rounded(color.z())});
  }
}

}  // namespace roomcast::recording
