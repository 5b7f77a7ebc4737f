// SPDX-License-Identifier: Apache-2.0
import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { decodeControl, encodeControl } from './control';
import { maxControlFromHubBytes } from './limits';
import { WireError } from './wire_error';

const golden = new URL('../../../tests/golden/', import.meta.url);

describe('a control message', () => {
  test('is written as C++ writes it', () => {
    const bytes = encodeControl({
      case: 'join',
      value: { room: 'lab', name: 'Émilie', role: { case: 'viewer', value: {} } },
    });
    expect(Buffer.from(bytes)).toEqual(readFileSync(new URL('wire_control_join_viewer.bin', golden)));
  });
  test('that was written reads back', () => {
    const bytes = encodeControl({ case: 'clockPing', value: { clientNs: 123_456_789_012_345n } });
    expect(decodeControl(bytes).message).toMatchObject({
      case: 'clockPing',
      value: { clientNs: 123_456_789_012_345n },
    });
  });
  test('of a kind that a later version added reads as one without content', () => {
    const later = new Uint8Array([0x52, 0x43, 1, 2, 0xa2, 0x06, 0]); // field 100, length 0
    expect(decodeControl(later).message.case).toBeUndefined();
  });
  test('that is too long to send is refused before it is sent', () => {
    expect(() => encodeControl({ case: 'join', value: { name: 'x'.repeat(20_000) } })).toThrow(/16 KiB/);
  });
  test('that is too long to read is refused before it is parsed', () => {
    const bytes = new Uint8Array(maxControlFromHubBytes + 1);
    bytes.set([0x52, 0x43, 1, 2]);
    expect(() => decodeControl(bytes)).toThrow(/256 KiB/);
  });
  test('of random bytes is refused with a WireError or read, and never throws anything else', () => {
    let state = 1;
    const random = () => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) >>> 24;
    for (let round = 0; round < 2000; round++) {
      const bytes = Uint8Array.from({ length: 4 + (random() % 40) }, random);
      bytes.set([0x52, 0x43, 1, 2]);
      try {
        decodeControl(bytes);
      } catch (error) {
        expect(error).toBeInstanceOf(WireError);
      }
    }
  });
});
