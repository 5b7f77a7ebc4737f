// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { aheadOf_s, shownInstant_ms } from './shown_instant';

test('the instant is in the middle between the newest pictures', () => {
  expect(shownInstant_ms([1000, 1030, 1010])).toBe(1015);
  expect(shownInstant_ms([1000])).toBe(1000);
  expect(shownInstant_ms([])).toBeUndefined();
});

test('a sensor that is far behind does not count', () => {
  expect(shownInstant_ms([1000, 1020, 859])).toBe(1010);
  expect(shownInstant_ms([1000, 1020, 880])).toBe(950);
});

test('surfaces are moved for a short time only', () => {
  expect(aheadOf_s(1000, 1020)).toBeCloseTo(0.02);
  expect(aheadOf_s(1020, 1000)).toBeCloseTo(-0.02);
  expect(aheadOf_s(1000, 9000)).toBeCloseTo(0.07);
  expect(aheadOf_s(1000, 0)).toBeCloseTo(-0.07);
});

test('without a time nothing is moved', () => {
  expect(aheadOf_s(undefined, 1000)).toBe(0);
  expect(aheadOf_s(1000, undefined)).toBe(0);
});
