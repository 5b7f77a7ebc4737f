// SPDX-License-Identifier: Apache-2.0
// How each point of a sensor's cleaned surface moves, in the grid, so that drawing it takes one lookup. The same rules as
// roomcast/render/shaders/blend (interpolate_flow.comp, moves in adaptive_mesh.comp).
import { flowCell_px } from '../../codec/scene_flow';

/**
 * Red: as the background's grid, and above 0 also where something moves before an unknown background. The others: metres
 * per second in the sensor's frame. A driver in software runs both sides of a branch, but ends a loop that has no turns.
 */
export const motionShader = /* glsl */ `
uniform sampler2D uFlow;     // codec/scene_flow.ts
uniform sampler2D uLive_m;   // in the grid
uniform sampler2D uBehind_m; // in the grid: the background
uniform int uStep;
out vec4 motion;

const float kMoves = 0.25;  // m/s; slower could be noise

// Between the four cells around the pixel, of those whose surface this is.
vec3 velocityAt(ivec2 pixel, float z) {
  bool mayMove = z > 0.0 && texelFetch(uFlow, pixel / ${flowCell_px}, 0).w != 0.0;
  vec2 at = (vec2(pixel) + 0.5) / ${flowCell_px}.0 - 0.5;
  ivec2 first = ivec2(floor(at));
  ivec2 last = textureSize(uFlow, 0) - 1;
  vec2 part = at - vec2(first);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < (mayMove ? 4 : 0); ++i) {
    ivec2 beside = ivec2(i & 1, i >> 1);
    vec4 flow = texelFetch(uFlow, clamp(first + beside, ivec2(0), last), 0);
    vec2 share = mix(1.0 - part, part, vec2(beside));
    if (z < flow.w) sum += vec4(flow.xyz, 1.0) * share.x * share.y;
  }
  return sum.a > 0.0 ? sum.xyz / sum.a : vec3(0.0);
}

void main() {
  ivec2 cell = ivec2(gl_FragCoord.xy);
  vec3 velocity = velocityAt(cell * uStep, texelFetch(uLive_m, cell, 0).r);
  float behind = texelFetch(uBehind_m, cell, 0).r;
  if (behind == 0.0 && length(velocity) > kMoves) behind = 1.0;
  motion = vec4(behind, velocity);
}
`;
