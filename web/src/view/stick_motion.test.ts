// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { pushOf } from './stick_motion';

test('up is forward, sideways is sideways, and the rim is full speed', () => {
  expect(pushOf(0, -50, 50)).toEqual({ forward: 1, right: 0 });
  expect(pushOf(500, 0, 50)).toEqual({ forward: 0, right: 1 });
  const { forward, right } = pushOf(-300, 400, 50);
  expect([forward, right].map((part) => part.toFixed(6))).toEqual(['-0.800000', '-0.600000']);
  expect(pushOf(0, 25, 50).forward).toBeGreaterThan(-0.5);
});

test('a resting thumb does not walk, nor does what is not a number', () => {
  for (const dx of [0, 5, NaN]) expect(pushOf(dx, 0, 50)).toEqual({ forward: 0, right: 0 });
});
