// A ball of rings and sectors, generated from gl_VertexID; the matrix shapes it into a head, a hand or a beam.

layout(location = 0) uniform mat4 clip_from_world[2];  // of each eye
layout(location = 2) uniform mat4 world_from_ball;
layout(location = 3) uniform mat3 world_from_normal;

const int sectors = 32;
const int rings = 16;
const ivec2 corners[6] = ivec2[6](ivec2(0, 0), ivec2(0, 1), ivec2(1, 0), ivec2(1, 0), ivec2(0, 1), ivec2(1, 1));
const float pi = 3.14159265;

out vec3 world_normal;

void main() {
  int cell = gl_VertexID / 6;
  ivec2 corner = ivec2(cell % sectors, cell / sectors) + corners[gl_VertexID % 6];
  float longitude = 2.0 * pi * float(corner.x) / float(sectors);
  float latitude = pi * (float(corner.y) / float(rings) - 0.5);
  vec3 ball = vec3(cos(latitude) * cos(longitude), sin(latitude), cos(latitude) * sin(longitude));
  world_normal = world_from_normal * ball;
  gl_Position = in_part_of_eye(clip_from_world[this_eye()] * world_from_ball * vec4(ball, 1.0));
}
