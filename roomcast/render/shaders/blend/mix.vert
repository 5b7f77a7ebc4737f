// Weighs a surface by its quality and by the agreement between the sensor's and the eye's viewing directions (Buehler
// et al. 2001, unstructured lumigraph rendering).

layout(location = 6) uniform float weight;  // of this surface relative to others

out vec3 at;  // (u, v, 1) * z, u and v from 0 to 1 in the depth grid; correct across large triangles
out float counts;

// Surfaces are moved towards the eye by this much, so that those within it behind the nearest surface pass the depth
// test and are mixed: metres along the eye's axis, and metres per metre of distance.
const float kMix_m = 0.02;
const float kMixPer_m = 0.012;
const float kMinAgreement = 0.05;
const float kScale = 256.0;  // keeps small weights precise in half floats

// 1: same direction; 0.5: right angle. The weight is its fourth power: a higher power is sharper, a lower hides seams.
float agreement(vec3 a, vec3 b) { return 0.5 + 0.5 * dot(a, b) * inversesqrt(dot(a, a) * dot(b, b)); }

void main() {
  ivec2 pixel = pixel_of(gl_VertexID);
  vec3 point = point_in_view(pixel);
  float alike = max(agreement(point, point - view_from_depth[this_eye()][3].xyz), kMinAgreement);
  counts = kScale * weight * alike * alike * alike * alike;
  float away = max(-point.z, 1.0e-3);
  float forward = max((away - kMix_m) / (1.0 + kMixPer_m), 0.5 * away);  // never behind the eye
  gl_Position = in_part_of_eye(clip_from(point * (forward / away)));
  at = vec3((vec2(pixel) + 0.5) / vec2(textureSize(depth_m, 0)), 1.0) * z_at(pixel);
}
