// SPDX-License-Identifier: Apache-2.0
// The direction in which each pixel of a depth grid looks, (x/z, y/z) with the lens distortion taken out: a point is
// (x/z * depth, y/z * depth, depth). Brown-Conrady, inverted by Newton's method as in roomcast/geometry/camera_model.cpp.
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

/** Whether the radius still grows with the angle everywhere from the axis to here; beyond, a lens model means nothing. */
function beforeFold(lens: Lens, r2: number): boolean {
  const slope = (q: number) => 1 + q * (3 * lens.k1 + q * (5 * lens.k2 + q * 7 * lens.k3));
  const samples = 8;
  for (let i = 1; i <= samples; i++) {
    if (!(slope((r2 * i) / samples) > 0)) return false;
  }
  return true;
}

/** Undefined where no direction projects to this place. `guess` is a place to start from. */
export function undistort(lens: Lens, xd: number, yd: number, guess: [number, number]): [number, number] | undefined {
  let [x, y] = guess;
  for (let step = 0; step < maxNewtonSteps; step++) {
    const r2 = x * x + y * y;
    const radial = 1 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
    const radialByR2 = lens.k1 + r2 * (2 * lens.k2 + r2 * 3 * lens.k3);
    const [dx, dy] = distort(lens, x, y);
    const ex = dx - xd;
    const ey = dy - yd;
    const a = radial + 2 * x * x * radialByR2 + 2 * lens.p1 * y + 6 * lens.p2 * x;
    const b = 2 * x * y * radialByR2 + 2 * lens.p1 * x + 2 * lens.p2 * y;
    const d = radial + 2 * y * y * radialByR2 + 6 * lens.p1 * y + 2 * lens.p2 * x;
    const determinant = a * d - b * b;
    if (!(determinant > 0)) return undefined;
    if (Math.hypot(ex, ey) < tolerance) return beforeFold(lens, r2) ? [x, y] : undefined;
    x -= (d * ex - b * ey) / determinant;
    y -= (a * ey - b * ex) / determinant;
  }
  return undefined;
}

export interface RayTable {
  rays: Float32Array<ArrayBuffer>; // x/z, y/z per pixel, row by row; 0, 0 where blind
  blind: Uint32Array; // pixels that look nowhere: their depth has to be ignored
}

export function rayTable(lens: Lens, width: number, height: number): RayTable {
  const rays = new Float32Array(2 * width * height);
  const blind: number[] = [];
  for (let v = 0; v < height; v++) {
    let guess: [number, number] | undefined; // the neighbour's ray is a good start
    for (let u = 0; u < width; u++) {
      const xd = (u - lens.cx) / lens.fx;
      const yd = (v - lens.cy) / lens.fy;
      guess = (guess && undistort(lens, xd, yd, guess)) ?? undistort(lens, xd, yd, [xd, yd]);
      const pixel = v * width + u;
      if (guess) rays.set(guess, 2 * pixel);
      else blind.push(pixel);
    }
  }
  return { rays, blind: Uint32Array.from(blind) };
}
