// SPDX-License-Identifier: Apache-2.0
// The scale that all of a rig's sensors have in common. Nothing that they see tells it: a room
// whose every distance is 2 % longer gives the same pictures to sensors that read 2 % too far. So
// it is not found but assumed, and its error is told beside the poses, as a share of all distances;
// the errors of the poses are what is left when all distances are right.
//
// The law: readings of a sensor that nobody calibrated are off by the factor exp(e), e normal with
// the prior's sigma, each sensor by itself. Together the sensors determine the differences of
// the e, and so every e but for their mean. The best estimate of the mean is 0, so factors
// are chosen whose mean logarithm is 0, and the mean's variance is sigma^2 / n for n sensors.
// With factors relative to one of them (factor 1 for the origin) it would be sigma^2. Calibrated
// sensors share a small error, chiefly multipath, which does not fall with their number. Both are
// weighed by the belief that the sensors are not calibrated: the variance of a mixture of two cases
// with one mean is the mean of their variances. Thread-safe (no state).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "roomcast/alignment/pair/sensor_correction.h"

namespace roomcast::alignment {

struct DepthScale {
  double factor = 1;          // on the sensor's readings; 1 where it is not determined
  double standard_error = 0;  // of an estimated factor, relative to the origin's; 0 where there is
                              // none, and for the origin
};

struct CommonScaleOptions {
  double calibrated_sigma = 0.0025;  // as DepthUncertainty::common_scale (ADR 9)

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("calibrated_sigma", calibrated_sigma, Range{0, 1});
  }
  [[nodiscard]] Status check() const { return check_fields("CommonScaleOptions", *this); }
};

/// `relative`: estimated with factor 1 for the origin. Multiplies the origin's factor, and all that
/// are determined relative to it, so that the mean of their logarithms is 0. Unchanged if there are
/// none, or if one is determined to be 1: that sensor is calibrated and has the true scale.
[[nodiscard]] std::vector<DepthScale> in_common_scale(std::vector<DepthScale> relative,
                                                      std::size_t origin);

/// One standard deviation of the common scale of `sensors` sensors, as a share. `sigma`: of the
/// scale of one that nobody calibrated.
[[nodiscard]] double common_scale_error(std::size_t sensors, double uncalibrated_belief,
                                        double sigma, const CommonScaleOptions& options = {});

}  // namespace roomcast::alignment
