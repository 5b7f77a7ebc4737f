// SPDX-License-Identifier: Apache-2.0
import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { decodeControl } from '../wire/control';
import { readPart } from './part';

/** Header and records as docs/spec/playback.md has them. */
function partOf(records: { flags: number; time_us: number; message: number[] }[], next = 7, headerLength = 32): ArrayBuffer {
  const length = records.reduce((sum, { message }) => sum + 16 + message.length, headerLength);
  const view = new DataView(new ArrayBuffer(length));
  view.setUint32(0, 0x54504352, true);
  view.setUint16(4, 1, true);
  view.setUint16(6, headerLength, true);
  view.setBigUint64(8, 1_500_000n, true);
  view.setBigUint64(16, 2_500_000n, true);
  view.setUint32(24, next, true);
  let at = headerLength;
  for (const { flags, time_us, message } of records) {
    view.setUint32(at, message.length, true);
    view.setUint32(at + 4, flags, true);
    view.setBigUint64(at + 8, BigInt(time_us), true);
    new Uint8Array(view.buffer, at + 16).set(message);
    at += 16 + message.length;
  }
  return view.buffer as ArrayBuffer;
}

const two = [
  { flags: 1, time_us: 1_000_000, message: [1, 2, 3] },
  { flags: 0, time_us: 2_000_000, message: [] },
];

describe('a part of a recording', () => {
  test('has its times, its records and the number of the next part', () => {
    const part = readPart(partOf(two));
    expect(part).toMatchObject({ from_s: 1.5, until_s: 2.5, next: 7, isDamaged: false });
    expect(part.records.map(({ isPast, time_s, message }) => [isPast, time_s, [...message]])).toEqual([
      [true, 1, [1, 2, 3]],
      [false, 2, []],
    ]);
    expect(readPart(partOf([], 0xffffffff)).next).toBeUndefined();
  });

  test('may have a longer header in a later version', () => {
    expect(readPart(partOf(two, 7, 40)).records.length).toBe(2);
  });

  test('is read as the C++ implementation wrote it', () => {
    const file = readFileSync(new URL('../../../tests/golden/recording_part.bin', import.meta.url));
    const part = readPart(new Uint8Array(file).buffer);
    expect(part).toMatchObject({ from_s: 2.5, next: undefined, isDamaged: false });
    const past = part.records.filter(({ isPast }) => isPast).map(({ message }) => decodeControl(message).message);
    expect(past.map((message) => message.case)).toEqual(['roster', 'marks', 'viewerPoses']);
    expect(past[1]!.value).toMatchObject({ all: true, marks: [{ id: 2, text: 'note' }, { id: 3 }] });
    expect(part.records.filter(({ isPast }) => !isPast).map(({ time_s }) => time_s)).toEqual([3]);
  });

  test('is refused where lengths are wrong, and in a later version', () => {
    const whole = partOf(two);
    for (let length = 0; length < whole.byteLength; length++) {
      if (length === 32 || length === 51) continue; // a whole number of records
      expect(() => readPart(whole.slice(0, length)), `${length} bytes`).toThrow();
    }
    const longer = partOf(two);
    new DataView(longer).setUint32(32, 0xfffffff0, true);
    expect(() => readPart(longer)).toThrow(/too early/);
    const later = partOf(two);
    new DataView(later).setUint16(4, 2, true);
    expect(() => readPart(later)).toThrow(/later version/);
    const odd = partOf(two);
    new DataView(odd).setUint16(6, 9999, true);
    expect(() => readPart(odd)).toThrow(/header/);
  });
});
