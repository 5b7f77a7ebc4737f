// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { distort, rayTable, type Lens } from './ray_table';

const straight: Lens = { fx: 365, fy: 360, cx: 254, cy: 210, k1: 0, k2: 0, k3: 0, p1: 0, p2: 0 };
const kinect: Lens = { ...straight, k1: 0.0868, k2: -0.2606, k3: 0.1, p1: -0.0001, p2: 0.0001 };

describe('a ray table', () => {
  test('of a straight lens is the pinhole', () => {
    const { rays, blind } = rayTable(straight, 512, 424);
    expect(blind.length).toBe(0);
    const at = 2 * (100 * 512 + 300);
    expect(rays[at]).toBeCloseTo((300 - 254) / 365, 6);
    expect(rays[at + 1]).toBeCloseTo((100 - 210) / 360, 6);
  });

  test('of a real lens projects back to each pixel within a thousandth of a pixel', () => {
    const { rays, blind } = rayTable(kinect, 512, 424);
    expect(blind.length).toBe(0);
    for (let pixel = 0; pixel < 512 * 424; pixel += 997) {
      const [x, y] = distort(kinect, rays[2 * pixel]!, rays[2 * pixel + 1]!);
      expect(Math.abs(x * kinect.fx + kinect.cx - (pixel % 512))).toBeLessThan(1e-3);
      expect(Math.abs(y * kinect.fy + kinect.cy - Math.floor(pixel / 512))).toBeLessThan(1e-3);
    }
  });

  test('marks pixels without a ray, beyond the fold of a strong distortion', () => {
    const { rays, blind } = rayTable({ ...straight, k1: -0.9 }, 512, 424);
    expect(blind.length).toBeGreaterThan(0);
    expect(blind.includes(210 * 512 + 254)).toBe(false);
    expect(blind).toContain(0);
    expect(rays.every(Number.isFinite)).toBe(true);
  });
});
