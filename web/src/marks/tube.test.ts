// SPDX-License-Identifier: Apache-2.0
import { Vector3 } from 'three';
import { expect, test } from 'vitest';
import { tube } from './tube';

test('every corner of a tube is its radius away from the line, and its faces look outwards', () => {
  const points = [new Vector3(0, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 2, 0)];
  const geometry = tube(points, 0.1);
  const at = geometry.getAttribute('position');
  expect(at.count).toBe(3 * 6);
  const corners = Array.from({ length: at.count }, (_, i) => new Vector3().fromBufferAttribute(at, i));
  for (const { x, z } of corners) expect(Math.hypot(x, z)).toBeCloseTo(0.1);
  const index = [...geometry.getIndex()!.array];
  expect(index).toHaveLength(2 * 6 * 6);
  for (let i = 0; i < index.length; i += 3) {
    const [a, b, c] = index.slice(i, i + 3).map((corner) => corners[corner]!) as [Vector3, Vector3, Vector3];
    const face = b.clone().sub(a).cross(c.clone().sub(a));
    const middle = a.clone().add(b).add(c).setY(0);
    expect(face.dot(middle)).toBeGreaterThan(0);
  }
});

test('a way that turns back, stays or is short makes no broken numbers', () => {
  const ways = [
    [new Vector3(), new Vector3(1, 0, 0), new Vector3()],
    [new Vector3(1, 1, 1), new Vector3(1, 1, 1)],
    [new Vector3(), new Vector3(0, 1, 0), new Vector3(1, 1, 0), new Vector3(1, 1, -1)],
  ];
  for (const way of ways) {
    expect([...tube(way, 0.01).getAttribute('position').array].every(Number.isFinite)).toBe(true);
  }
});
