// Weighs a surface by how well its sensor saw it and by how alike the sensor's and the eye's directions are
// (Buehler et al. 2001, unstructured lumigraph rendering).

layout(location = 6) uniform float weight;  // of this surface beside others

out vec3 at;  // in the depth grid, 0..1: to be divided by its last, for large triangles
out float counts;

// As much as surfaces may lie behind the nearest and still be mixed with it they are drawn in front of themselves: metres
// along the eye's axis, and for each metre.
const float kMix_m = 0.02;
const float kMixPer_m = 0.012;
const float kMinAgreement = 0.05;
const float kScale = 256.0;  // half floats are finer there

// 1: the same; 0.5: at right angles. Its fourth power is the weight: higher is sharper, lower hides seams.
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
