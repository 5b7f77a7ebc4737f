// SPDX-License-Identifier: Apache-2.0
// Current distance between the surfaces measured by two sensors where their views overlap: points of one sensor are
// projected into the other's picture and compared with the depth there. Includes the sensors' noise and motion; it is a
// check, not a calibration. Pure.
import type { Intrinsics } from '../gen/control_pb';
import { distort, type Lens } from '../view/ray_table';

export interface DepthPicture {
  lens: Pick<Intrinsics, 'width' | 'height'> & Lens;
  depth_mm: Uint16Array;
  rays: Float32Array; // x/z, y/z per pixel
  worldFromDepth: readonly number[]; // row-major 4x4
}

export interface PairGap {
  points: number; // seen by both sensors
  gap_mm: number; // median absolute difference
}

const every_px = 6;
const sameSurface_mm = 120; // a larger difference means another surface, hidden from one of the sensors
const fewestPoints = 60;

/** Row-major 4x4 b_from_a of two rigid poses in the world. */
function relative(b: readonly number[], a: readonly number[]): number[] {
  const out: number[] = [];
  for (let row = 0; row < 3; row++) {
    for (let column = 0; column < 4; column++) {
      let sum = 0;
      for (let k = 0; k < 3; k++) sum += b[4 * k + row]! * (a[4 * k + column]! - (column === 3 ? b[4 * k + 3]! : 0));
      out.push(sum);
    }
  }
  return out;
}

/** Undefined when the sensors share too few points. */
export function pairGap(a: DepthPicture, b: DepthPicture): PairGap | undefined {
  const m = relative(b.worldFromDepth, a.worldFromDepth);
  const differences: number[] = [];
  for (let v = 0; v < a.lens.height; v += every_px) {
    for (let u = 0; u < a.lens.width; u += every_px) {
      const difference = differenceAt(a, b, m, v * a.lens.width + u);
      if (difference !== undefined) differences.push(difference);
    }
  }
  if (differences.length < fewestPoints) return undefined;
  differences.sort((x, y) => x - y);
  return { points: differences.length, gap_mm: differences[differences.length >> 1]! };
}

function differenceAt(a: DepthPicture, b: DepthPicture, m: number[], pixel: number): number | undefined {
  const z = a.depth_mm[pixel]!;
  if (z === 0) return undefined;
  const x = a.rays[2 * pixel]! * z;
  const y = a.rays[2 * pixel + 1]! * z;
  const at = (row: number) => m[4 * row]! * x + m[4 * row + 1]! * y + m[4 * row + 2]! * z + 1000 * m[4 * row + 3]!;
  const depth = at(2);
  if (depth < 300) return undefined;
  const [xd, yd] = distort(b.lens, at(0) / depth, at(1) / depth);
  const u = Math.round(b.lens.fx * xd + b.lens.cx);
  const v = Math.round(b.lens.fy * yd + b.lens.cy);
  if (u < 0 || v < 0 || u >= b.lens.width || v >= b.lens.height) return undefined;
  const read = b.depth_mm[v * b.lens.width + u]!;
  const difference = Math.abs(read - depth);
  return read === 0 || difference > sameSurface_mm ? undefined : difference;
}
