// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/pair/sensor_correction.h"

#include <cmath>

namespace roomcast::alignment {

double DepthUncertainty::uncalibrated_belief(double disagreement_m) const {
  const double odds = std::pow(disagreement_m / uncalibrated_from_m, uncalibrated_steepness);
  return odds / (1 + odds);
}

DepthUncertainty DepthUncertainty::given(double disagreement_m) const {
  DepthUncertainty doubt = *this;
  // An error common to the sensors may be as large as what they disagree by.
  doubt.offset_m = std::hypot(offset_m, disagreement_m);
  doubt.scale = std::hypot(scale, uncalibrated_belief(disagreement_m) * uncalibrated_scale);
  return doubt;
}

DepthUncertainty DepthUncertainty::weighed_given(double disagreement_m) const {
  DepthUncertainty weighed = *this;
  weighed.uncalibrated_from_m = weighed_uncalibrated_from_m;
  weighed.uncalibrated_steepness = weighed_uncalibrated_steepness;
  return weighed.given(disagreement_m);
}

}  // namespace roomcast::alignment
