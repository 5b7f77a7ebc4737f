// Transforms of a sensor's surface to the view. Comes before vertex shaders, after eyes.glsl.

layout(location = 0) uniform mat4 clip_from_view[2];   // of each eye
layout(location = 2) uniform mat4 view_from_depth[2];
layout(location = 4) uniform int sensor;  // used by fragment shaders

vec3 in_view(vec3 in_depth) { return (view_from_depth[this_eye()] * vec4(in_depth, 1.0)).xyz; }

vec4 clip_from(vec3 in_view) { return clip_from_view[this_eye()] * vec4(in_view, 1.0); }
