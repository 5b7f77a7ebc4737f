// Transforms a sensor's newest picture to the view, for points and meshes. Comes before their vertex shaders, after
// eyes.glsl, surface_view.glsl and sensor_surface.glsl.

// A surface without a colour is moved back by this share of its distance, so that another sensor that saw the colour of
// the same surface wins although its depth is as noisy.
const float kUnseenSetback = 0.02;

vec3 point_in_view(ivec2 pixel, float z) { return in_view(vec3(texelFetch(rays, pixel, 0).xy * z, z)); }

// Adding a constant to clip.z moves a point back by a share of its distance, to first order: with ndc.z = -A - B/z,
// d(ndc.z)/dz = B/z^2, and a step of s*z changes clip.z = ndc.z * -z by -s*B.
vec4 clip_position(ivec2 pixel, vec3 point) {
  vec4 clip = clip_from(point);
  if (!color_is_seen(pixel)) clip.z -= kUnseenSetback * clip_from_view[this_eye()][3][2];
  return in_part_of_eye(clip);
}
