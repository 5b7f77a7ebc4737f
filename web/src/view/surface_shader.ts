// SPDX-License-Identifier: Apache-2.0
// Shaders that draw a sensor's depth grid, as triangles or as points. Vertices are pulled: gl_VertexID selects the grid
// cell, the depth texture gives its position. A triangle whose corners differ in depth by more than a surface would is
// dropped: the bound has a fixed part, for noise, and one that grows with distance. Colour comes from the registered
// picture where the colour camera saw the surface, else the surface is a neutral grey.

const shared = /* glsl */ `
precision highp float;
precision highp int;
precision highp usampler2D;
precision highp sampler2D;
`;

const vertexInputs = /* glsl */ `
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform usampler2D uDepth;   // millimetres, 0 = no reading
uniform sampler2D uRays;     // x/z, y/z
uniform ivec2 uCells;        // of the grid that is drawn: every uStep-th pixel
uniform int uStep;
uniform float uNoise;        // metres at 1 m; grows with the square of the distance
uniform sampler2D uColor;
uniform float uUnseen_m;     // how far a surface without colour, or of a sensor that is gone, yields to others
uniform float uLive;         // 1; 0 for the last picture of a sensor that is gone
out vec2 vPixel;
out vec3 vView;

float depthAt(ivec2 pixel) { return float(texelFetch(uDepth, pixel, 0).r) * 0.001; }

// In the depth test only, a surface is pushed back by what speaks against it: distance from its sensor, no colour, age.
// So where several sensors see the same wall, the one that knows it best is drawn.
void place(ivec2 pixel, float z) {
  vec2 ray = texelFetch(uRays, pixel, 0).rg;
  vec4 view = modelViewMatrix * vec4(ray * z, z, 1.0);
  gl_Position = projectionMatrix * view;
  float yield_m = uNoise * z * z + uUnseen_m * (2.0 - uLive - texelFetch(uColor, pixel, 0).a);
  vec4 behind = projectionMatrix * vec4(view.xyz * (1.0 + yield_m / max(length(view.xyz), 0.1)), 1.0);
  gl_Position.z = behind.z / behind.w * gl_Position.w;
  vPixel = vec2(pixel);
  vView = view.xyz;
}

const vec4 nowhere = vec4(0.0, 0.0, 2.0, 1.0);
`;

export const meshVertexShader = /* glsl */ `${shared}${vertexInputs}
uniform float uEdge_m;       // a surface may rise by this from one corner to the next,
uniform float uEdgeSlope;    // and by this for every metre of distance, times the root of the step

const ivec2 corners[6] = ivec2[6](ivec2(0, 0), ivec2(0, 1), ivec2(1, 0), ivec2(1, 0), ivec2(0, 1), ivec2(1, 1));

void main() {
  int cell = gl_VertexID / 6;
  int corner = gl_VertexID % 6;
  int first = corner < 3 ? 0 : 3;
  ivec2 origin = ivec2(cell % uCells.x, cell / uCells.x) * uStep;
  float a = depthAt(origin + corners[first] * uStep);
  float b = depthAt(origin + corners[first + 1] * uStep);
  float c = depthAt(origin + corners[first + 2] * uStep);
  float nearest = min(a, min(b, c));
  float rise = max(a, max(b, c)) - nearest;
  if (nearest <= 0.0 || rise > uEdge_m + uEdgeSlope * nearest * sqrt(float(uStep))) {
    gl_Position = nowhere;
    return;
  }
  float z = corner == first ? a : (corner == first + 1 ? b : c);
  place(origin + corners[corner] * uStep, z);
}
`;

export const pointVertexShader = /* glsl */ `${shared}${vertexInputs}
uniform float uPixelsPerUnit;  // screen pixels that a metre takes up at a distance of a metre
uniform float uFocal;          // of the depth camera, pixels
uniform vec2 uSize;            // of the grid, pixels

const float largestPoint = 32.0;

// The next pixel across or down; where it has no reading the surface is taken to face the sensor.
vec3 neighbour(ivec2 pixel, float z) {
  ivec2 inside = min(pixel, ivec2(uSize) - 1);
  float there = depthAt(inside);
  return vec3(texelFetch(uRays, inside, 0).rg, 1.0) * (there > 0.0 ? there : z);
}

// Like the back of a triangle, the back of what a sensor saw is not drawn.
bool seenFromBehind(ivec2 pixel, float z) {
  vec3 point = vec3(texelFetch(uRays, pixel, 0).rg, 1.0) * z;
  vec3 normal = cross(neighbour(pixel + ivec2(0, uStep), z) - point, neighbour(pixel + ivec2(uStep, 0), z) - point);
  return dot(mat3(modelViewMatrix) * normal, vView) > 0.0;
}

void main() {
  ivec2 pixel = ivec2(gl_VertexID % uCells.x, gl_VertexID / uCells.x) * uStep;
  float z = depthAt(pixel);
  gl_PointSize = 1.0;
  gl_Position = nowhere;
  if (z <= 0.0) return;
  place(pixel, z);
  if (seenFromBehind(pixel, z)) gl_Position = nowhere;
  float spacing_m = z * float(uStep) / uFocal;
  gl_PointSize = clamp(1.2 * spacing_m * uPixelsPerUnit / max(-vView.z, 0.05), 1.0, largestPoint);
}
`;

export const fragmentShader = /* glsl */ `${shared}
uniform sampler2D uColor;    // alpha: 1 where the colour camera saw the surface
uniform vec2 uSize;          // of the grid, pixels
uniform float uLive;         // 1; 0 for the last picture of a sensor that is gone
uniform float uId;           // > 0: draw this number and the distance instead of the picture
in vec2 vPixel;
in vec3 vView;
out vec4 outColor;

void main() {
  if (uId > 0.0) {
    float mm = clamp(round(1000.0 / gl_FragCoord.w), 0.0, 65535.0); // along the viewing direction
    outColor = vec4(uId, floor(mm / 256.0), mod(mm, 256.0), 255.0) / 255.0;
    return;
  }
  vec4 seen = texture(uColor, (vPixel + 0.5) / uSize);
  vec3 normal = cross(dFdx(vView), dFdy(vView));
  float facing = abs(dot(normal, vView)) / max(length(normal) * length(vView), 1e-9);
  vec3 grey = vec3(0.30, 0.32, 0.35) * (0.55 + 0.6 * facing);
  vec3 color = mix(grey, seen.rgb, smoothstep(0.1, 0.4, seen.a));
  float luma = dot(color, vec3(0.2126, 0.7152, 0.0722));
  outColor = vec4(mix(vec3(luma) * 0.45, color, uLive), 1.0);
}
`;
