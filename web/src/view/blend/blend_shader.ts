// SPDX-License-Identifier: Apache-2.0
// Blends the surfaces of several sensors: those within about 2 cm + 1.2 % of the nearest, weighted by the quality of
// the measurement and by the similarity of the sensor's and the eye's directions (Buehler et al. 2001, unstructured
// lumigraph rendering). The same rules as roomcast/render/shaders/blend (nearest, mix, shrink, grow, resolve).
import { passPrecision } from './full_screen_pass';

// Surfaces this close to the nearest one are blended with it.
const mixRange = /* glsl */ `
const float kMix_m = 0.02;
const float kMixPer_m = 0.012;
`;

// A smaller sum means a surface without known colour. Each layer adds kUncolored; there are at most 64 layers.
const colorKnown = /* glsl */ `
const float kUncolored = 1.0e-4;
const float kMinColored = 2.0e-2;
bool hasColor(vec4 sum) { return sum.a > 0.7 * kMinColored; }
`;

// Depths of the room's model, beyond those of all that sensors show in a room: it only fills what they leave empty.
export const modelDepth = /* glsl */ `
const float kModelFrom = 0.999;
const float kModelFar_m = 50.0;
float depthOfModel(float away_m) { return kModelFrom + (0.99999 - kModelFrom) * min(away_m / kModelFar_m, 1.0); }
float awayOfModel(float depth) { return (depth - kModelFrom) / (0.99999 - kModelFrom) * kModelFar_m; }
`;

const layerVertex = /* glsl */ `${passPrecision}
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform sampler2D uDepth_m;  // in the grid; 0: nothing, negative: the live surface lies on it
uniform sampler2D uBehind_m;  // in the grid, above 0 where the surface is before its background (motion_shader.ts)
uniform bool uForegroundOnly;
uniform sampler2D uRays;     // every pixel: x/z, y/z
uniform int uStep;
uniform float uEdge_m;       // a surface may rise by this from one corner to the next,
uniform float uEdgeSlope;    // and by this for every metre of distance, times the root of the step
uniform float uSetback_m;    // along the eye's ray
uniform sampler2D uMotion;   // in the grid; after red: metres per second
uniform float uAhead_s;      // draws what moves where it is after this time; 0: where it was seen

const vec4 nowhere = vec4(0.0, 0.0, 2.0, 1.0);
const ivec2 corners[6] = ivec2[6](ivec2(0, 0), ivec2(0, 1), ivec2(1, 0), ivec2(1, 0), ivec2(0, 1), ivec2(1, 1));

bool isForeground(ivec2 corner) { return texelFetch(uBehind_m, corner, 0).r > 0.0; }

// The grid's cell that this vertex stands on and its depth; 0 where its triangle is not to be drawn.
ivec2 cell;
float pulledDepth() {
  int columns = textureSize(uDepth_m, 0).x - 1;
  int square = gl_VertexID / 6;
  int corner = gl_VertexID % 6;
  int first = corner < 3 ? 0 : 3;
  ivec2 origin = ivec2(square % columns, square / columns);
  float a = texelFetch(uDepth_m, origin + corners[first], 0).r;
  float b = texelFetch(uDepth_m, origin + corners[first + 1], 0).r;
  float c = texelFetch(uDepth_m, origin + corners[first + 2], 0).r;
  bool isLeftOut = max(a, max(b, c)) < 0.0;
  vec3 z = abs(vec3(a, b, c));
  float nearest = min(z.x, min(z.y, z.z));
  float rise = max(z.x, max(z.y, z.z)) - nearest;
  cell = origin + corners[corner];
  if (uForegroundOnly) {
    isLeftOut = !(isForeground(origin + corners[first]) && isForeground(origin + corners[first + 1]) &&
      isForeground(origin + corners[first + 2]));
  }
  if (isLeftOut || nearest <= 0.0 || rise > uEdge_m + uEdgeSlope * nearest * sqrt(float(uStep))) return 0.0;
  return z[corner - first];
}

vec3 pointInView(float z) {
  vec3 seenAt = vec3(texelFetch(uRays, cell * uStep, 0).rg * z, z);
  // Not a branch, of which a driver in software runs both sides.
  for (int i = 0; i < (uAhead_s != 0.0 ? 1 : 0); ++i) seenAt += uAhead_s * texelFetch(uMotion, cell, 0).gba;
  vec3 point = (modelViewMatrix * vec4(seenAt, 1.0)).xyz;
  return point * (1.0 + uSetback_m / max(-point.z, 1.0e-3));
}
`;

/** The nearest surface, set back by the distance within which other surfaces are blended with it. */
export const nearestVertexShader = /* glsl */ `${layerVertex}${mixRange}
void main() {
  float z = pulledDepth();
  gl_Position = nowhere;
  if (z == 0.0) return;
  vec3 point = pointInView(z);
  float away = max(-point.z, 1.0e-3);
  gl_Position = projectionMatrix * vec4(point * (1.0 + (kMix_m + kMixPer_m * away) / away), 1.0);
}
`;

export const nearestFragmentShader = /* glsl */ `${passPrecision}
out vec4 nothing;
void main() { nothing = vec4(0.0); }
`;

export const mixVertexShader = /* glsl */ `${layerVertex}
uniform sampler2D uQuality;  // in the grid
uniform bool uIsBackground;
uniform float uExponent;     // how much directions count
out vec2 vPixel;
out float vWeight;

const float kMinAgreement = 0.05;
const float kBackgroundWeight = 0.02;
const float kScale = 256.0;  // half floats are finer there

float qualityAt(float z) {
  return uIsBackground ? kBackgroundWeight / (z * z) : texelFetch(uQuality, cell, 0).r;
}

void main() {
  float z = pulledDepth();
  gl_Position = nowhere;
  if (z == 0.0) return;
  vec3 point = pointInView(z);
  vec3 fromSensor = point - modelViewMatrix[3].xyz;
  float agreement = 0.5 + 0.5 * dot(normalize(point), normalize(fromSensor));
  vPixel = vec2(cell * uStep);
  vWeight = kScale * qualityAt(z) * pow(max(agreement, kMinAgreement), uExponent);
  gl_Position = projectionMatrix * vec4(point, 1.0);
}
`;

export const mixFragmentShader = /* glsl */ `${passPrecision}${colorKnown}
uniform sampler2D uColor;    // every pixel; alpha above 0: seen
uniform vec2 uSize;
uniform float uLive;         // 1; 0 for the last picture of a sensor that is gone
in vec2 vPixel;
in float vWeight;
out vec4 colorSum;           // rgb times weight, weight

void main() {
  vec4 seen = texture(uColor, (vPixel + 0.5) / uSize);
  float known = smoothstep(0.1, 0.4, seen.a);
  float luma = dot(seen.rgb, vec3(0.2126, 0.7152, 0.0722));
  vec3 color = mix(vec3(luma) * 0.45, seen.rgb, uLive);
  colorSum = vec4(color, 1.0) * max(vWeight * known, kMinColored);
  if (known == 0.0) colorSum = vec4(0.0, 0.0, 0.0, kUncolored);
}
`;

/**
 * Halves the size: sums of colours with their weights (push-pull, Gortler et al. 1996). Distant surfaces have more
 * weight, because the gap next to a person is part of the wall behind.
 */
export const shrinkShader = /* glsl */ `${colorKnown}
uniform sampler2D uFiner;
uniform sampler2D uDepth;    // of the picture
uniform bool uFromPicture;
uniform vec2 uMetresFromDepth;  // metres = y / (x - depth)
out vec4 coarser;

const float kFar_m = 4.0;

vec4 weighted(ivec2 pixel) {
  if (any(greaterThanEqual(pixel, textureSize(uFiner, 0)))) return vec4(0.0);
  vec4 sum = texelFetch(uFiner, pixel, 0);
  if (!uFromPicture) return sum;
  if (!hasColor(sum)) return vec4(0.0);
  float away = uMetresFromDepth.y / (uMetresFromDepth.x - texelFetch(uDepth, pixel, 0).r);
  float far = min(away / kFar_m, 1.0);
  return vec4(sum.rgb / sum.a, 1.0) * (far * far * far + 0.001);
}

void main() {
  ivec2 pixel = 2 * ivec2(gl_FragCoord.xy);
  coarser = 0.25 * (weighted(pixel) + weighted(pixel + ivec2(1, 0)) + weighted(pixel + ivec2(0, 1)) + weighted(pixel + ivec2(1, 1)));
}
`;

/** Fills gaps in a level from the next coarser level. */
export const growShader = /* glsl */ `
uniform sampler2D uLevel;
uniform sampler2D uCoarser;
out vec4 grown;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  grown = texelFetch(uLevel, pixel, 0);
  if (grown.a <= 0.0) grown = texture(uCoarser, (vec2(pixel) + 0.5) / vec2(2 * textureSize(uCoarser, 0)));
}
`;

/**
 * The blended picture with its depth. Optionally fills pixels that no sensor sees with the colour of their
 * surroundings.
 */
export const resolveFragmentShader = /* glsl */ `${passPrecision}${mixRange}${colorKnown}${modelDepth}
uniform sampler2D uColorSum;
uniform sampler2D uDepth;
uniform sampler2D uSurroundings;  // half the size
uniform bool uFill;
uniform vec2 uMetresFromDepth;    // metres = y / (x - depth)
out vec4 outColor;

const vec4 kGrey = vec4(0.5, 0.5, 0.5, 1.0);

// The nearest surface was drawn set back: where it really is.
float trueDepth(float depth) {
  if (depth > kModelFrom) return uMetresFromDepth.x - uMetresFromDepth.y / max(awayOfModel(depth), 1.0e-3);
  float away = uMetresFromDepth.y / (uMetresFromDepth.x - depth);
  return uMetresFromDepth.x - uMetresFromDepth.y * (1.0 + kMixPer_m) / max(away - kMix_m, 1.0e-3);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 sum = texelFetch(uColorSum, pixel, 0);
  bool isSurface = sum.a > 0.0;
  if (!isSurface && !uFill) discard;
  if (!hasColor(sum)) sum = uFill ? texture(uSurroundings, gl_FragCoord.xy / vec2(2 * textureSize(uSurroundings, 0))) : kGrey;
  if (sum.a <= 0.0) discard;
  outColor = vec4(sum.rgb / sum.a, 1.0);
  gl_FragDepth = isSurface ? trueDepth(texelFetch(uDepth, pixel, 0).r) : 1.0;
}
`;
