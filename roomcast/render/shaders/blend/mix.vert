// Weighs a surface by how well its sensor saw it and by how alike the sensor's and the eye's directions are
// (Buehler et al. 2001, unstructured lumigraph rendering).

layout(location = 4) uniform float weight;    // of this surface beside others
layout(location = 5) uniform float exponent;  // how much directions count

out vec3 at;            // in the depth grid, 0..1: to be divided by its last, for large triangles
out float counts;

const float kLeastAgreement = 0.05;
const float kScale = 256.0;  // half floats are finer there

void main() {
  ivec2 pixel = pixel_of(gl_VertexID);
  vec3 point = point_in_view(pixel);
  vec3 from_sensor = point - view_from_depth[3].xyz;
  float agreement = 0.5 + 0.5 * dot(normalize(point), normalize(from_sensor));
  at = vec3((vec2(pixel) + 0.5) / vec2(textureSize(depth_m, 0)), 1.0) * z_at(pixel);
  counts = kScale * weight * pow(max(agreement, kLeastAgreement), exponent);
  gl_Position = clip_from_view * vec4(point, 1.0);
}
