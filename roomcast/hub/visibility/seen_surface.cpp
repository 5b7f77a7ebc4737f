// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/visibility/seen_surface.h"

#include <algorithm>

namespace roomcast::hub {
namespace {

/// A cell of which the two distances differ by less has one point, m.
constexpr double kOneSurface_m = 0.1;

/// The point at z = 1 m that the centre of a cell shows; depth frame, metres.
Eigen::Vector3d cell_ray(const wire::pb::CoarseDepth& depth, const wire::pb::Intrinsics& lens,
                         std::uint32_t column, std::uint32_t row) {
  const double u = (column + 0.5) * lens.width() / depth.columns() - 0.5;
  const double v = (row + 0.5) * lens.height() / depth.rows() - 0.5;
  return {(u - lens.cx()) / lens.fx(), (v - lens.cy()) / lens.fy(), 1};
}

bool is_about(double z_m, std::uint32_t near_cm, std::uint32_t far_cm) {
  constexpr double kShare = 0.08, kSlack_m = 0.15;  // of moving things and slanted cells
  return near_cm > 0 && z_m >= (1 - kShare) * near_cm / 100 - kSlack_m &&
         z_m <= (1 + kShare) * far_cm / 100 + kSlack_m;
}

/// Smaller changes are noise, or an arm; sensors send changes of 15 cm at once.
constexpr std::uint32_t kChange_cm = 15;

std::uint8_t quiet_after(std::uint8_t before, std::uint32_t was_cm, std::uint32_t is_cm) {
  const bool has_changed = std::max(was_cm, is_cm) - std::min(was_cm, is_cm) > kChange_cm;
  if (has_changed) return 0;
  return std::min<std::uint8_t>(before + 1, CellQuiet::kQuiet);
}

/// For every cell of `depth`. After another number of cells, or with no message before, all are
/// still.
std::vector<CellQuiet> quiet_cells(const wire::pb::CoarseDepth& depth, const SeenSurface* before) {
  std::vector<CellQuiet> quiet(static_cast<std::size_t>(depth.near_cm_size()));
  if (before == nullptr || before->quiet.size() != quiet.size() ||
      before->sight.depth.columns() != depth.columns()) {
    return quiet;
  }
  const wire::pb::CoarseDepth& was = before->sight.depth;
  for (int cell = 0; cell < depth.near_cm_size(); ++cell) {
    const CellQuiet& known = before->quiet[static_cast<std::size_t>(cell)];
    quiet[static_cast<std::size_t>(cell)] = {
        quiet_after(known.near, was.near_cm(cell), depth.near_cm(cell)),
        quiet_after(known.far, was.far_cm(cell), depth.far_cm(cell))};
  }
  return quiet;
}

}  // namespace

bool SensorSight::sees(const Eigen::Vector3f& point_m) const {
  const Eigen::Vector3d in_depth = world_from_depth.rotation.transpose() *
                                   (point_m.cast<double>() - world_from_depth.translation_m);
  if (depth.near_cm().empty() || !(in_depth.z() > 0)) return false;
  const double u = (lens.fx() * in_depth.x() / in_depth.z() + lens.cx() + 0.5) / lens.width();
  const double v = (lens.fy() * in_depth.y() / in_depth.z() + lens.cy() + 0.5) / lens.height();
  if (!(u >= 0 && u < 1 && v >= 0 && v < 1)) return false;
  const int column = static_cast<int>(u * depth.columns()),
            row = static_cast<int>(v * depth.rows());
  const int cell = row * static_cast<int>(depth.columns()) + column;
  return is_about(in_depth.z(), depth.near_cm(cell), depth.far_cm(cell));
}

void link_other(SensorId sensor, const SensorSight* sight, SeenSurface& surface) {
  for (SurfacePoint& point : surface.points) {
    std::erase_if(point.others, [&](const OtherView& other) { return other.sensor == sensor; });
    if (sight == nullptr || !sight->sees(point.at_m)) continue;
    const Eigen::Vector3f sensor_m = sight->world_from_depth.translation_m.cast<float>();
    point.others.push_back({sensor, (sensor_m - point.at_m).normalized()});
  }
}

SeenSurface seen_surface(const wire::pb::CoarseDepth& depth, const wire::pb::Intrinsics& lens,
                         const RigidTransform& world_from_depth, const SeenSurface* before) {
  SeenSurface surface{{}, quiet_cells(depth, before), {depth, lens, world_from_depth}};
  const Eigen::Vector3d sensor_m = world_from_depth.translation_m;
  const auto add = [&](const Eigen::Vector3d& ray, double z_m, std::uint8_t quiet) {
    const Eigen::Vector3d at_m = world_from_depth * Eigen::Vector3d(ray * z_m);
    const Eigen::Vector3d to_sensor = (sensor_m - at_m).normalized();
    surface.points.push_back(
        {at_m.cast<float>(), to_sensor.cast<float>(), {}, quiet < CellQuiet::kQuiet});
  };
  for (std::uint32_t row = 0; row < depth.rows(); ++row) {
    for (std::uint32_t column = 0; column < depth.columns(); ++column) {
      const auto cell = static_cast<int>(row * depth.columns() + column);
      const double near_m = depth.near_cm(cell) / 100.0, far_m = depth.far_cm(cell) / 100.0;
      if (!(near_m > 0)) continue;
      const Eigen::Vector3d ray = cell_ray(depth, lens, column, row);
      const CellQuiet& quiet = surface.quiet[static_cast<std::size_t>(cell)];
      add(ray, near_m, quiet.near);
      if (far_m > near_m + kOneSurface_m) add(ray, far_m, quiet.far);
    }
  }
  return surface;
}

}  // namespace roomcast::hub
