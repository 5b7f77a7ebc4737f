// SPDX-License-Identifier: Apache-2.0
// A sensor's model of its static background: the same rules as roomcast/render/shaders/blend (update_background,
// background_depth, carve). `uReadings`: metres and readings of the background, metres and readings of a candidate
// behind it. Grid textures contain every uStep-th pixel.

export const depthNoise = /* glsl */ `
// How far readings of a time-of-flight camera scatter (Fankhauser et al. 2015, a wall that faces it), times 1.5. Metres.
float depthSigma(float z) { return 0.0015 * (1.5 - 0.5 * z + 0.3 * z * z); }

// Two readings of the same surface differ by less.
float sameSurfaceGate(float z) { return 4.0 * depthSigma(z) + 0.004; }
`;

/** Adds one new picture to the background model, and denoises the drawn depth of static surfaces. */
export const rememberShader = /* glsl */ `
uniform usampler2D uDepth;
uniform sampler2D uColor;
uniform sampler2D uReadings;
uniform sampler2D uMeanColor;  // rgb, readings
layout(location = 0) out vec4 readings;
layout(location = 1) out vec4 meanColor;
layout(location = 2) out vec4 shown_m;
${depthNoise}
const float kMaxReadings = 64.0;
const float kMaxColors = 32.0;
const float kReadingsOfFarther = 3.0;

vec4 withColor(ivec2 pixel, vec4 known) {
  vec4 seen = texelFetch(uColor, pixel, 0);
  if (seen.a < 0.5) return known;
  known.a = min(known.a + 1.0, kMaxColors);
  known.rgb += (seen.rgb - known.rgb) / known.a;
  return known;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float z = 0.001 * float(texelFetch(uDepth, pixel, 0).r);
  vec4 known = texelFetch(uReadings, pixel, 0);
  vec4 mean = texelFetch(uMeanColor, pixel, 0);
  float shown = z;
  if (z > 0.0) {
    float gate = sameSurfaceGate(z);
    if (known.x > 0.0 && abs(z - known.x) < gate) {
      known.y = min(known.y + 1.0, kMaxReadings);
      known.x += (z - known.x) / known.y;
      known.w = 0.0;
      shown = known.x;
      mean = withColor(pixel, mean);
    } else if (z > known.x) {
      bool agrees = known.w > 0.0 && abs(z - known.z) < gate;
      known.w = agrees ? known.w + 1.0 : 1.0;
      known.z = agrees ? known.z + (z - known.z) / known.w : z;
      if (known.x == 0.0 || known.w >= kReadingsOfFarther) {
        known = vec4(known.zw, 0.0, 0.0);
        mean = withColor(pixel, vec4(0.0));
      }
    }
  }
  readings = known;
  meanColor = mean;
  shown_m = vec4(shown);
}
`;

/**
 * The background as a drawable surface, in the grid: where there are enough readings, where the sensor has no reading
 * beyond it, and where no other sensor sees through it. Negative where the live surface coincides with it: triangles
 * with only negative corners are not drawn.
 */
export const backgroundShader = /* glsl */ `
uniform usampler2D uDepth;
uniform sampler2D uReadings;
uniform sampler2D uLive_m;    // in the grid
uniform sampler2D uCarved;    // in the grid, above 0 where another sensor looks through
uniform int uStep;
out vec4 background_m;
${depthNoise}
const float kEnoughReadings = 8.0;
const float kBeyond_m = 0.1;

void main() {
  ivec2 cell = ivec2(gl_FragCoord.xy);
  vec4 known = texelFetch(uReadings, cell * uStep, 0);
  float z = 0.001 * float(texelFetch(uDepth, cell * uStep, 0).r);
  bool holds = known.y >= kEnoughReadings && z <= known.x + kBeyond_m && texelFetch(uCarved, cell, 0).r == 0.0;
  float live = texelFetch(uLive_m, cell, 0).r;
  bool covered = live > 0.0 && abs(live - known.x) < sameSurfaceGate(known.x);
  background_m = vec4(!holds ? 0.0 : covered ? -known.x : known.x);
}
`;

/** 1 where another sensor now has a reading clearly beyond the remembered surface, all around it. Drawn with MAX. */
export const carveShader = /* glsl */ `
uniform sampler2D uReadings;
uniform sampler2D uRays;
uniform usampler2D uOtherDepth;
uniform mat4 uOtherFromDepth;
uniform vec4 uOtherFocalCenter;  // fx, fy, cx, cy
uniform vec3 uOtherRadial;       // Brown-Conrady, as geometry/camera_model.h
uniform vec2 uOtherTangential;
uniform int uStep;
out vec4 carved;

const float kBeyond_m = 0.06;
const float kBeyondPer_m = 0.02;
const float kNearest_m = 0.3;
const float kWidestSquared = 1.0;  // 45 degrees off the axis: no lens model folds back before

vec2 projected(vec3 point) {
  vec2 xy = point.xy / point.z;
  float r2 = dot(xy, xy);
  float radial = 1.0 + r2 * (uOtherRadial.x + r2 * (uOtherRadial.y + r2 * uOtherRadial.z));
  vec2 tangential = 2.0 * uOtherTangential * xy.x * xy.y + uOtherTangential.yx * (r2 + 2.0 * xy * xy);
  return uOtherFocalCenter.xy * (xy * radial + tangential) + uOtherFocalCenter.zw;
}

bool isLookedThrough(vec3 point) {
  if (point.z < kNearest_m || dot(point.xy, point.xy) > kWidestSquared * point.z * point.z) return false;
  ivec2 at = ivec2(round(projected(point)));
  if (any(lessThan(at, ivec2(1))) || any(greaterThan(at, textureSize(uOtherDepth, 0) - 2))) return false;
  float beyond_mm = 1000.0 * (point.z + kBeyond_m + kBeyondPer_m * point.z);
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      if (float(texelFetch(uOtherDepth, at + ivec2(x, y), 0).r) < beyond_mm) return false;
    }
  }
  return true;
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) * uStep;
  float z = texelFetch(uReadings, pixel, 0).x;
  vec3 point = vec3(texelFetch(uRays, pixel, 0).rg * z, z);
  carved = vec4(z > 0.0 && isLookedThrough((uOtherFromDepth * vec4(point, 1.0)).xyz) ? 1.0 : 0.0);
}
`;
