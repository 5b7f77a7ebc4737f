// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { rayTable } from '../view/ray_table';
import { pairGap, type DepthPicture } from './pair_gap';

const lens = { width: 120, height: 90, fx: 100, fy: 100, cx: 59.5, cy: 44.5, k1: 0.02, k2: 0, k3: 0, p1: 0, p2: 0 };
const { rays } = rayTable(lens, lens.width, lens.height);

/** A sensor at `x` (metres) that looks at a wall 2 m ahead, along z. */
function sensorAt(x: number, wall_mm = 2000): DepthPicture {
  const depth_mm = new Uint16Array(lens.width * lens.height).fill(wall_mm);
  return { lens, rays, depth_mm, worldFromDepth: [1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] };
}

describe('the gap of a pair', () => {
  test('is zero where both agree on a wall', () => {
    const gap = pairGap(sensorAt(0), sensorAt(0.3))!;
    expect(gap.gap_mm).toBeLessThan(0.01);
    expect(gap.points).toBeGreaterThan(100);
  });

  test('equals their difference', () => {
    expect(pairGap(sensorAt(0), sensorAt(0.3, 2015))!.gap_mm).toBeCloseTo(15);
  });

  test('ignores surfaces that only one of them sees', () => {
    const halfHidden = sensorAt(0);
    halfHidden.depth_mm.fill(1000, 0, halfHidden.depth_mm.length / 2);
    expect(pairGap(sensorAt(0), halfHidden)!.gap_mm).toBeLessThan(0.01);
  });

  test('is unknown where they share nothing', () => {
    expect(pairGap(sensorAt(0), sensorAt(10))).toBeUndefined();
    expect(pairGap(sensorAt(0), sensorAt(0, 0))).toBeUndefined();
  });

  test('is found between sensors that look at it from two sides', () => {
    const turned = sensorAt(0);
    turned.worldFromDepth = [0, 0, -1, 2, 0, 1, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1]; // at (2, 0, 2), looking along -x
    const diagonal = sensorAt(0);
    for (let pixel = 0; pixel < diagonal.depth_mm.length; pixel++) {
      diagonal.depth_mm[pixel] = 2000 / (1 + rays[2 * pixel]!); // the plane x + z = 2
      turned.depth_mm[pixel] = 2000 / (1 - rays[2 * pixel]!); // the same plane: here x' = z - 2, z' = 2 - x
    }
    const gap = pairGap(diagonal, turned);
    expect(gap!.gap_mm).toBeLessThan(25); // depth is read at the nearest pixel of a slanted plane
  });
});
