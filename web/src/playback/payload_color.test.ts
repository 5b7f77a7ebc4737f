// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { colorIn } from './payload_color';

const section = (kind: number, codec: number, ...bytes: number[]) => [kind, codec, 0, 0, bytes.length, 0, 0, 0, ...bytes];

describe('the colour in a payload', () => {
  test('is found behind the depth, in an array that begins anywhere', () => {
    const bytes = Uint8Array.from([9, ...section(1, 2, 7, 7, 7), ...section(2, 1, 5, 6), ...section(3, 1, 1)]);
    expect([...colorIn(bytes.subarray(1))!]).toEqual([5, 6]);
  });

  test('is missing where there is none, of another kind, or cut off', () => {
    expect(colorIn(Uint8Array.from(section(1, 2, 7)))).toBeUndefined();
    expect(colorIn(Uint8Array.from(section(2, 9, 7)))).toBeUndefined();
    expect(colorIn(Uint8Array.from([2, 1, 0, 0, 200, 0, 0, 0, 1]))).toBeUndefined();
    expect(colorIn(new Uint8Array(3))).toBeUndefined();
    expect(colorIn(Uint8Array.from([...section(1, 2, 7), 2, 1]))).toBeUndefined();
  });
});
