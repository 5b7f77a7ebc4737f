// Bilateral filter of depth (Tomasi & Manduchi 1998): a mean over those of 5x5 pixels that are on the same surface.

layout(local_size_x = 16, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D depth_in;
layout(r32f, binding = 0) writeonly uniform image2D depth_out;

const float kSpatialSigma_px = 1.6;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = imageSize(depth_out);
  if (any(greaterThanEqual(pixel, size))) return;
  float z = texelFetch(depth_in, pixel, 0).r;
  if (z > 0.0) {
    float range = 3.0 * depth_sigma(z) + 0.004;
    float sum = 0.0, weights = 0.0;
    for (int y = max(pixel.y - 2, 0); y <= min(pixel.y + 2, size.y - 1); ++y) {
      for (int x = max(pixel.x - 2, 0); x <= min(pixel.x + 2, size.x - 1); ++x) {
        float near = texelFetch(depth_in, ivec2(x, y), 0).r;
        if (near == 0.0) continue;
        vec2 away = vec2(x - pixel.x, y - pixel.y);
        float off = (near - z) / range;
        float weight = exp(-0.5 * off * off - dot(away, away) / (2.0 * kSpatialSigma_px * kSpatialSigma_px));
        sum += weight * near;
        weights += weight;
      }
    }
    z = sum / weights;
  }
  imageStore(depth_out, pixel, vec4(z));
}
