// SPDX-License-Identifier: Apache-2.0
// Prepares a live depth picture for blending, in the grid of every uStep-th pixel: the same steps as
// roomcast/render/shaders/blend (fill_small, extend_edges, smooth, edge_distance, quality).
import { depthNoise } from './memory_shader';

/** Fills a pixel without a reading with the mean of its neighbours where these are on one surface. */
export const repairShader = /* glsl */ `
uniform sampler2D uDepth_m;  // every pixel
uniform int uStep;
out vec4 repaired_m;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy) * uStep;
  ivec2 last = textureSize(uDepth_m, 0) - 1;
  float z = texelFetch(uDepth_m, pixel, 0).r;
  if (z == 0.0) {
    float sum = 0.0, nearest = 1.0e9, farthest = 0.0, count = 0.0;
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        float near = texelFetch(uDepth_m, clamp(pixel + ivec2(x, y), ivec2(0), last), 0).r;
        if (near == 0.0) continue;
        sum += near;
        nearest = min(nearest, near);
        farthest = max(farthest, near);
        count += 1.0;
      }
    }
    float apart = farthest - nearest;
    bool inside = count >= 5.0 && apart < 0.03 + 0.02 * nearest;
    bool rim = count >= 2.0 && apart < 0.012 + 0.022 * nearest;
    if (inside || rim) z = sum / count;
  }
  repaired_m = vec4(z);
}
`;

/** Bilateral filter (Tomasi & Manduchi 1998): the mean over those of 5x5 cells that are on the same surface. */
export const smoothShader = /* glsl */ `
uniform sampler2D uDepth_m;  // in the grid
uniform sampler2D uCarved;   // in the grid, above 0 where another sensor looks through
out vec4 smoothed_m;
${depthNoise}
const float kSpatialSigma_px = 1.6;

void main() {
  ivec2 cell = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(uDepth_m, 0) - 1;
  float z = texelFetch(uDepth_m, cell, 0).r;
  if (texelFetch(uCarved, cell, 0).r > 0.0) z = 0.0;
  if (z > 0.0) {
    float range = 3.0 * depthSigma(z) + 0.004;
    float sum = 0.0, weights = 0.0;
    for (int y = -2; y <= 2; ++y) {
      for (int x = -2; x <= 2; ++x) {
        float near = texelFetch(uDepth_m, clamp(cell + ivec2(x, y), ivec2(0), last), 0).r;
        if (near == 0.0) continue;
        float off = (near - z) / range;
        float weight = exp(-0.5 * off * off - float(x * x + y * y) / (2.0 * kSpatialSigma_px * kSpatialSigma_px));
        sum += weight * near;
        weights += weight;
      }
    }
    z = sum / weights;
  }
  smoothed_m = vec4(z);
}
`;

/** Distance along the row to the next depth edge, 0 to kReach cells, as a share of kReach. */
export const edgeShader = /* glsl */ `
uniform sampler2D uDepth_m;  // in the grid
uniform int uStep;
out vec4 inRow;

const int kReach = 5;

bool isEdge(ivec2 cell, ivec2 last) {
  if (any(lessThan(cell, ivec2(1))) || any(greaterThanEqual(cell, last))) return true;
  float z = texelFetch(uDepth_m, cell, 0).r;
  if (z == 0.0) return true;
  float most = (0.02 + 0.025 * z) * sqrt(float(uStep));
  for (int i = 0; i < 4; ++i) {
    float near = texelFetch(uDepth_m, cell + ivec2(i < 2 ? 2 * i - 1 : 0, i < 2 ? 0 : 2 * i - 5), 0).r;
    if (near == 0.0 || abs(near - z) > most) return true;
  }
  return false;
}

void main() {
  ivec2 cell = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(uDepth_m, 0) - 1;
  int reach = max(1, kReach / uStep);
  int away = 0;
  while (away < reach && !isEdge(cell + ivec2(away, 0), last) && !isEdge(cell - ivec2(away, 0), last)) ++away;
  inRow = vec4(float(away) / float(kReach));
}
`;

/**
 * The weight of a cell in blending. It increases with closeness, with perpendicular viewing, and with the distance from
 * the next depth edge, where depth and colour mix both sides.
 */
export const qualityShader = /* glsl */ `
uniform sampler2D uDepth_m;  // in the grid
uniform sampler2D uInRow;
uniform sampler2D uRays;     // every pixel
uniform int uStep;
out vec4 quality;

const int kReach = 5;

float edgeDistance(ivec2 cell, ivec2 last) {
  int reach = max(1, kReach / uStep);
  float nearest = float(reach * reach);
  for (int y = -reach; y <= reach; ++y) {
    float across = float(kReach) * texelFetch(uInRow, clamp(cell + ivec2(0, y), ivec2(0), last), 0).r;
    nearest = min(nearest, across * across + float(y * y));
  }
  return sqrt(nearest) / float(reach);
}

vec3 pointAt(ivec2 cell, ivec2 last) {
  cell = clamp(cell, ivec2(0), last);
  float z = texelFetch(uDepth_m, cell, 0).r;
  return vec3(texelFetch(uRays, cell * uStep, 0).rg * z, z);
}

vec3 across(ivec2 cell, ivec2 step, ivec2 last) {
  vec3 a = pointAt(cell - step, last), b = pointAt(cell + step, last);
  return a.z > 0.0 && b.z > 0.0 ? b - a : vec3(0.0);
}

// Of the angle between the ray and the surface's normal; 1 where there is no normal to be had.
float facing(ivec2 cell, ivec2 last, vec3 point) {
  vec3 right = across(cell, ivec2(1, 0), last) + across(cell, ivec2(2, 0), last);
  vec3 down = across(cell, ivec2(0, 1), last) + across(cell, ivec2(0, 2), last);
  vec3 normal = cross(right, down);
  float size2 = dot(normal, normal);
  return size2 > 0.0 ? abs(dot(normal, normalize(point))) * inversesqrt(size2) : 1.0;
}

void main() {
  ivec2 cell = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(uDepth_m, 0) - 1;
  vec3 point = pointAt(cell, last);
  float counts = 0.0;
  if (point.z > 0.0) {
    float cosine = facing(cell, last, point);
    float inside = min(edgeDistance(cell, last) + 0.06, 1.0);
    counts = (0.05 + cosine * cosine) / (point.z * point.z) * inside;
  }
  quality = vec4(counts);
}
`;
