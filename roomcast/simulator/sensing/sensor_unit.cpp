// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/sensor_unit.h"

#include "roomcast/geometry/rotations.h"
#include "roomcast/simulator/random/value_noise.h"
#include "roomcast/simulator/sensing/harsh_unit.h"

namespace roomcast::simulator {
namespace {

/// A sequence of independent numbers in -1..1.
class Deviations {
 public:
  explicit Deviations(std::uint32_t key) : key_(key) {}
  double next() { return 2.0 * static_cast<double>(nth_unit(key_, count_++)) - 1.0; }

 private:
  std::uint32_t key_, count_ = 0;
};

RigidTransform nudged(RigidTransform transform, double angle_rad, double shift_m, Deviations& by) {
  const Eigen::Vector3d turn(by.next(), by.next(), by.next());
  const Eigen::Vector3d shift(by.next(), by.next(), by.next());
  transform.rotation = transform.rotation * rotation_from_vector(angle_rad * turn);
  transform.translation_m += shift_m * shift;
  return transform;
}

/// A lens with manufacturing tolerances.
CameraIntrinsics made(CameraIntrinsics lens, Deviations& by) {
  const double scale = lens.width / 640.0;  // the tolerances are in pixels at a width of 640
  lens.fx *= 1.0 + 0.003 * by.next();
  lens.fy = lens.fx * (1.0 + 0.0005 * by.next());
  lens.cx += 2.5 * scale * by.next();
  lens.cy += 2.5 * scale * by.next();
  if (lens.k1 == 0) return lens;  // rectified
  lens.k1 += 0.004 * by.next();
  lens.k2 += 0.006 * by.next();
  lens.k3 += 0.003 * by.next();
  return lens;
}

SensorCalibration made(const SensorCalibration& nominal, Deviations by) {
  SensorCalibration unit = nominal;
  unit.depth = made(nominal.depth, by);
  unit.color = made(nominal.color, by);
  unit.color_from_depth = nudged(nominal.color_from_depth, 0.002, 0.0005, by);
  return unit;
}

CameraIntrinsics misjudged(CameraIntrinsics lens, double centre_px, Deviations& by) {
  const double focal = 1.0 + kFocalError * by.next();
  lens.fx *= focal;
  lens.fy *= focal;
  lens.cx += centre_px * by.next();
  lens.cy += centre_px * by.next();
  return lens;
}

SensorCalibration misjudged(const SensorCalibration& exact, Deviations by) {
  SensorCalibration reported = exact;
  reported.depth = misjudged(exact.depth, kDepthCentreError_px, by);
  reported.color = misjudged(exact.color, kColorCentreError_px * exact.color.width / 1920.0, by);
  reported.color_from_depth =
      nudged(exact.color_from_depth, kExtrinsicError_rad, kExtrinsicError_m, by);
  return reported;
}

/// Brightness within 5 %, red and blue within another 6 % of green.
std::array<float, 3> color_gain(Deviations by) {
  const double brightness = 1.0 + 0.05 * by.next();
  const double red = brightness * (1.0 + 0.06 * by.next());
  const double blue = brightness * (1.0 + 0.06 * by.next());
  return {static_cast<float>(red), static_cast<float>(brightness), static_cast<float>(blue)};
}

std::uint32_t key_of(std::uint64_t seed, int index) {
  const auto folded =
      hash_of(static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32));
  return hash_of(folded, static_cast<std::uint32_t>(index));
}

}  // namespace

SensorUnit make_unit(const SensingOptions& options, std::uint64_t seed, int index) {
  if (options.harsh != Harshness::kNone) return make_harsh_unit(options, key_of(seed, index));
  SensorUnit unit;
  unit.profile = profile_of(options.camera, options.half_color);
  unit.key = key_of(seed, index);
  unit.exact = made(unit.profile.nominal, Deviations(hash_of(unit.key, 1)));
  unit.reported = options.calibration_error
                      ? misjudged(unit.exact, Deviations(hash_of(unit.key, 2)))
                      : unit.exact;
  if (options.auto_exposure) unit.color_gain = color_gain(Deviations(hash_of(unit.key, 3)));
  return unit;
}

}  // namespace roomcast::simulator
