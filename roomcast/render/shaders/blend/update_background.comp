// Updates the background model: per pixel the farthest surface the sensor has seen, as the running mean of agreeing
// readings, and that surface's colour. A farther surface replaces a nearer one after several readings; nearer surfaces
// change nothing. Also writes the depth to draw: a reading of the remembered surface is replaced by the mean, which
// removes noise from static surfaces.

layout(local_size_x = 16, local_size_y = 8) in;
layout(rgba32f, binding = 0) uniform image2D background;        // metres, readings; metres, readings of a candidate
layout(rgba16f, binding = 1) uniform image2D background_color;  // rgb, readings
layout(r32f, binding = 2) uniform image2D depth_out;            // metres; the last frame's until written
layout(r16f, binding = 3) uniform image2D steadiness;           // 1: always a reading

const float kMaxReadings = 64.0;
const float kMaxColors = 32.0;
const float kReadingsOfFarther = 3.0;
const float kSteadinessStep = 1.0 / 16.0;

void update_colors(ivec2 pixel, bool is_new) {
  int shift = color_is_fine() ? 1 : 0;
  for (int i = 0; i < 1 << (2 * shift); ++i) {
    ivec2 at = (pixel << shift) + ivec2(i & 1, i >> 1);
    vec4 known = is_new ? vec4(0.0) : imageLoad(background_color, at);
    if (color_is_seen(pixel)) {
      known.a = min(known.a + 1.0, kMaxColors);
      known.rgb += (texelFetch(color, at, 0).rgb - known.rgb) / known.a;
    }
    imageStore(background_color, at, known);
  }
}

// Tracks how often a reading drops out. Only the start of a gap counts: an object in front of the surface can make a
// gap of any length.
void update_steadiness(ivec2 pixel, bool is_read) {
  bool was_read = imageLoad(depth_out, pixel).r > 0.0;
  if (!is_read && !was_read) return;
  float known = imageLoad(steadiness, pixel).r;
  imageStore(steadiness, pixel, vec4(mix(known, is_read ? 1.0 : 0.0, kSteadinessStep)));
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, textureSize(depth_mm, 0)))) return;
  float z = z_at(pixel);
  vec4 known = imageLoad(background, pixel);
  float shown = z;
  update_steadiness(pixel, z > 0.0);
  if (z > 0.0) {
    float gate = same_surface_gate(z);
    if (known.x > 0.0 && abs(z - known.x) < gate) {
      known.y = min(known.y + 1.0, kMaxReadings);
      known.x += (z - known.x) / known.y;
      known.w = 0.0;
      shown = known.x;
      update_colors(pixel, false);
    } else if (z > known.x) {
      bool agrees = known.w > 0.0 && abs(z - known.z) < gate;
      known.w = agrees ? known.w + 1.0 : 1.0;
      known.z = agrees ? known.z + (z - known.z) / known.w : z;
      if (known.x == 0.0 || known.w >= kReadingsOfFarther) {
        known = vec4(known.zw, 0.0, 0.0);
        update_colors(pixel, true);
      }
    }
    imageStore(background, pixel, known);
  }
  imageStore(depth_out, pixel, vec4(shown));
}
