// SPDX-License-Identifier: Apache-2.0
// The viewing direction of each pixel of a depth grid, (x/z, y/z) without lens distortion: a point is (x/z * depth, y/z
// * depth, depth). Brown-Conrady, inverted by Newton's method as in roomcast/geometry/camera_model.cpp.
import type { Intrinsics } from '../gen/control_pb';

export type Lens = Pick<Intrinsics, 'fx' | 'fy' | 'cx' | 'cy' | 'k1' | 'k2' | 'k3' | 'p1' | 'p2'>;

const maxNewtonSteps = 20;
const tolerance = 1e-9; // normalised; a pixel is about 3e-3

/** Applies the distortion to normalised coordinates. */
export function distort(lens: Lens, x: number, y: number): [number, number] {
  const r2 = x * x + y * y;
  const radial = 1 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
  return [
    x * radial + 2 * lens.p1 * x * y + lens.p2 * (r2 + 2 * x * x),
    y * radial + lens.p1 * (r2 + 2 * y * y) + 2 * lens.p2 * x * y,
  ];
}

const furthestR2 = 16; // 76 degrees off the axis, more than any depth camera's field of view
const foldSamples = 1600;

/** The squared radius at which the radial part stops growing; beyond it the lens model is invalid. */
function foldR2(lens: Lens): number {
  for (let i = 1; i <= foldSamples; i++) {
    const q = (i * furthestR2) / foldSamples;
    if (!(1 + q * (3 * lens.k1 + q * (5 * lens.k2 + q * 7 * lens.k3)) > 0)) return q;
  }
  return furthestR2;
}

/** Refines `xy` from its initial value to the direction that projects to (xd, yd); false where there is none. */
function undistort(lens: Lens, fold: number, xd: number, yd: number, xy: Float64Array): boolean {
  const { k1, k2, k3, p1, p2 } = lens;
  let x = xy[0]!;
  let y = xy[1]!;
  for (let step = 0; step < maxNewtonSteps; step++) {
    const r2 = x * x + y * y;
    const radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3));
    const radialByR2 = k1 + r2 * (2 * k2 + r2 * 3 * k3);
    const ex = x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x) - xd;
    const ey = y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y - yd;
    if (ex * ex + ey * ey < tolerance * tolerance) {
      xy[0] = x;
      xy[1] = y;
      return r2 < fold;
    }
    const a = radial + 2 * x * x * radialByR2 + 2 * p1 * y + 6 * p2 * x;
    const b = 2 * x * y * radialByR2 + 2 * p1 * x + 2 * p2 * y;
    const d = radial + 2 * y * y * radialByR2 + 6 * p1 * y + 2 * p2 * x;
    const determinant = a * d - b * b;
    if (!(determinant > 0)) return false;
    x -= (d * ex - b * ey) / determinant;
    y -= (a * ey - b * ex) / determinant;
  }
  return false;
}

export interface RayTable {
  rays: Float32Array<ArrayBuffer>; // x/z, y/z per pixel, row by row; 0, 0 where blind
  blind: Uint32Array; // pixels without a direction: their depth must be ignored
}

export function rayTable(lens: Lens, width: number, height: number): RayTable {
  const rays = new Float32Array(2 * width * height);
  const blind: number[] = [];
  const fold = foldR2(lens);
  const xy = new Float64Array(2);
  for (let v = 0; v < height; v++) {
    const yd = (v - lens.cy) / lens.fy;
    let found = false;
    for (let u = 0; u < width; u++) {
      const xd = (u - lens.cx) / lens.fx;
      found = found && undistort(lens, fold, xd, yd, xy); // the neighbour's ray is a good initial value
      if (!found) {
        xy[0] = xd;
        xy[1] = yd;
        found = undistort(lens, fold, xd, yd, xy);
      }
      const pixel = v * width + u;
      if (found) rays.set(xy, 2 * pixel);
      else blind.push(pixel);
    }
  }
  return { rays, blind: Uint32Array.from(blind) };
}
