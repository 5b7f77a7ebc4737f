// Weighs a surface by how well its sensor saw it and by how alike the sensor's and the eye's directions are
// (Buehler et al. 2001, unstructured lumigraph rendering).

layout(location = 4) uniform float weight;    // of this surface beside others
layout(location = 5) uniform float exponent;  // how much directions count

out vec4 weighted_color;  // rgb times weight, weight
out vec2 weighted_depth;  // metres along the eye's axis times weight, weight

const float kLeastAgreement = 0.05;
const float kScale = 256.0;  // half floats are finer there

void main() {
  ivec2 pixel = pixel_of(gl_VertexID);
  vec3 point = point_in_view(pixel);
  vec3 from_sensor = point - view_from_depth[3].xyz;
  float agreement = 0.5 + 0.5 * dot(normalize(point), normalize(from_sensor));
  vec2 counts = texelFetch(quality, pixel, 0).rg * (kScale * weight * pow(max(agreement, kLeastAgreement), exponent));
  weighted_color = vec4(texelFetch(color, pixel, 0).rgb, 1.0) * counts.g;
  weighted_depth = vec2(-point.z, 1.0) * counts.r;
  gl_Position = clip_from_view * vec4(point, 1.0);
}
