// Whom the picture is drawn for: one eye, or two side by side. Put in front of every vertex shader that draws something
// of the room; each instance of what it draws is for one eye. Locations as in eyes.cpp.

layout(location = 15) uniform int eyes;

out float gl_ClipDistance[2];  // to the left and the right border of the eye's part; nobody asks while there is one

int this_eye() { return gl_InstanceID; }

vec4 in_part_of_eye(vec4 clip) {
  gl_ClipDistance[0] = clip.w + clip.x;
  gl_ClipDistance[1] = clip.w - clip.x;
  if (eyes == 1) return clip;
  clip.x = 0.5 * (this_eye() == 0 ? clip.x - clip.w : clip.x + clip.w);
  return clip;
}
