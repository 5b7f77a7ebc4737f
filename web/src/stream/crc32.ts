// SPDX-License-Identifier: Apache-2.0
// CRC-32 as in PNG, zlib and roomcast/core/crc32.h (reflected polynomial 0xEDB88320), eight bytes at a time
// (Kounavis and Berry 2005, "slicing by 8").

const slices = makeSlices();

function makeSlices(): Uint32Array[] {
  const tables = Array.from({ length: 8 }, () => new Uint32Array(256));
  for (let byte = 0; byte < 256; byte++) {
    let crc = byte;
    for (let bit = 0; bit < 8; bit++) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
    tables[0]![byte] = crc;
  }
  for (let k = 1; k < 8; k++) {
    for (let byte = 0; byte < 256; byte++) {
      const before = tables[k - 1]![byte]!;
      tables[k]![byte] = (before >>> 8) ^ tables[0]![before & 255]!;
    }
  }
  return tables;
}

export function crc32(bytes: Uint8Array): number {
  const [t0, t1, t2, t3, t4, t5, t6, t7] = slices as [
    Uint32Array,
    Uint32Array,
    Uint32Array,
    Uint32Array,
    Uint32Array,
    Uint32Array,
    Uint32Array,
    Uint32Array,
  ];
  let crc = 0xffffffff;
  let at = 0;
  for (; at + 8 <= bytes.length; at += 8) {
    crc =
      t7[(bytes[at]! ^ crc) & 255]! ^
      t6[(bytes[at + 1]! ^ (crc >>> 8)) & 255]! ^
      t5[(bytes[at + 2]! ^ (crc >>> 16)) & 255]! ^
      t4[(bytes[at + 3]! ^ (crc >>> 24)) & 255]! ^
      t3[bytes[at + 4]!]! ^
      t2[bytes[at + 5]!]! ^
      t1[bytes[at + 6]!]! ^
      t0[bytes[at + 7]!]!;
  }
  for (; at < bytes.length; at++) crc = t0[(bytes[at]! ^ crc) & 255]! ^ (crc >>> 8);
  return ~crc >>> 0;
}
