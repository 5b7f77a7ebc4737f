// SPDX-License-Identifier: Apache-2.0
import { Vector3 } from 'three';
import { expect, test } from 'vitest';
import { Stroke } from './stroke';

test('a hand that stays adds nothing, and a dot is no line', () => {
  const stroke = new Stroke();
  expect(stroke.add(new Vector3(1, 0, 0))).toBe(true);
  expect(stroke.add(new Vector3(1.002, 0, 0))).toBe(false);
  expect(stroke.sketches).toEqual([]);
  expect(stroke.add(new Vector3(1.02, 0, 0))).toBe(true);
  expect(stroke.sketches).toEqual([[1, 0, 0, 1.02, 0, 0]]);
});

test('over the edge of a surface a new line begins', () => {
  const stroke = new Stroke();
  for (const z of [0, 0.02, -3, -3.02]) stroke.add(new Vector3(0, 0, z));
  expect(stroke.sketches).toEqual([
    [0, 0, 0, 0, 0, 0.02],
    [0, 0, -3, 0, 0, -3.02],
  ]);
});

test('of a line of a million points none is lost', () => {
  const stroke = new Stroke();
  const points = 100_000;
  for (let i = 0; i < points; i++) stroke.add(new Vector3(i / 50, 0, 0));
  expect(stroke.sketches.every(({ length }) => length >= 6 && length <= 3 * 512)).toBe(true);
  const seen = new Set(stroke.sketches.flatMap((line) => line.filter((_, i) => i % 3 === 0)));
  expect(seen.size).toBe(points);
});
