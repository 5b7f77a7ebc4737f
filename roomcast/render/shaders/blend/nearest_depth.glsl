// The nearest surface is drawn set back by as much as others may lie behind it and still be mixed with it. Metres along
// the eye's axis.

layout(location = 6) uniform vec2 depth_from_z;  // ndc depth = x + y / z

const float kMix_m = 0.02;
const float kMixPer_m = 0.012;

float set_back(float away) { return away + kMix_m + kMixPer_m * away; }

// Of the surface, from what is in the depth buffer; 0 where that is still empty.
float surface_m(float depth) {
  if (depth >= 1.0) return 0.0;
  float away = depth_from_z.y / (2.0 * depth - 1.0 - depth_from_z.x);
  return (away - kMix_m) / (1.0 + kMixPer_m);
}
