// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { opusDuration_ms } from './opus_packet';

/** A packet of RFC 6716's configuration number, with the code for the count of its frames. */
const packet = (config: number, code: number, count = 0) => Uint8Array.of((config << 3) | code, count);

describe('the length of an Opus packet', () => {
  test('is that of its frames', () => {
    expect(opusDuration_ms(packet(1, 0))).toBe(20); // SILK
    expect(opusDuration_ms(packet(15, 0))).toBe(20); // hybrid
    expect(opusDuration_ms(packet(31, 0))).toBe(20); // CELT
    expect(opusDuration_ms(packet(28, 0))).toBe(2.5);
    expect(opusDuration_ms(packet(3, 0))).toBe(60);
    expect(opusDuration_ms(packet(30, 1))).toBe(20);
    expect(opusDuration_ms(packet(30, 2))).toBe(20);
    expect(opusDuration_ms(packet(31, 3, 6))).toBe(120);
    expect(opusDuration_ms(packet(31, 3, 0xc1))).toBe(20); // with padding and variable sizes
  });
  test('is 0 without bytes or without frames', () => {
    expect(opusDuration_ms(new Uint8Array())).toBe(0);
    expect(opusDuration_ms(Uint8Array.of((31 << 3) | 3))).toBe(0);
  });
});
