// Draws for one eye, or for two side by side. Comes before every vertex shader of the room; each instance is drawn for
// one eye.

layout(location = 15) uniform int eyes;

out float gl_ClipDistance[2];  // distances to the left and right border of the eye's part; unused for one eye

int this_eye() { return gl_InstanceID; }

vec4 in_part_of_eye(vec4 clip) {
  gl_ClipDistance[0] = clip.w + clip.x;
  gl_ClipDistance[1] = clip.w - clip.x;
  if (eyes == 1) return clip;
  clip.x = 0.5 * (this_eye() == 0 ? clip.x - clip.w : clip.x + clip.w);
  return clip;
}
