// Extracts the remembered background as a surface: pixels with enough readings, except where the sensor now reads
// something farther.

layout(local_size_x = 16, local_size_y = 8) in;
layout(rgba32f, binding = 0) readonly uniform image2D background;
layout(r32f, binding = 2) writeonly uniform image2D depth_out;

const float kEnoughReadings = 8.0;
const float kBeyond_m = 0.1;

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, textureSize(depth_mm, 0)))) return;
  vec4 known = imageLoad(background, pixel);
  bool holds = known.y >= kEnoughReadings && z_at(pixel) <= known.x + kBeyond_m;
  imageStore(depth_out, pixel, vec4(holds ? known.x : 0.0));
}
