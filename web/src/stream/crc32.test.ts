// SPDX-License-Identifier: Apache-2.0
import { expect, test } from 'vitest';
import { crc32 } from './crc32';

const bytesOf = (text: string) => new TextEncoder().encode(text);

test('crc32 of the check string is the published value', () => {
  expect(crc32(bytesOf('123456789'))).toBe(0xcbf43926);
  expect(crc32(bytesOf(''))).toBe(0);
});

test('crc32 is the same eight bytes at a time as one at a time', () => {
  const data = Uint8Array.from({ length: 1003 }, (_, i) => (i * 7919) >> 3);
  let plain = 0xffffffff;
  for (const byte of data) {
    plain ^= byte;
    for (let bit = 0; bit < 8; bit++) plain = plain & 1 ? (plain >>> 1) ^ 0xedb88320 : plain >>> 1;
  }
  expect(crc32(data)).toBe(~plain >>> 0);
});
