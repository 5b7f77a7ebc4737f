// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { clockError, duration, megabytes, milliseconds, perSecond } from './format';

test('numbers are short enough to read at a glance', () => {
  expect(perSecond(29.97)).toBe('30.0');
  expect(perSecond(120.4)).toBe('120');
  expect(megabytes(2_345_678)).toBe('2.35');
  expect(milliseconds(undefined)).toBe('–');
  expect(milliseconds(83.4)).toBe('83 ms');
  expect(milliseconds(12_345)).toBe('12 s');
  expect(clockError(0.14)).toBe('±0.1');
  expect(clockError(42.3)).toBe('±42');
  expect(clockError(undefined)).toBe('');
  expect(duration(59.9)).toBe('0:59');
  expect(duration(3605)).toBe('60:05');
});
