// SPDX-License-Identifier: Apache-2.0
// Sound files that stand for microphones.
import { writeFileSync } from 'node:fs';

const header_bytes = 44;

/** One channel of 16 bits; `samples`: -32768 to 32767, are rounded. */
export function writeWav(path, samples, rate_hz) {
  const wav = Buffer.alloc(header_bytes + 2 * samples.length);
  wav.write('RIFF', 0);
  wav.writeUInt32LE(wav.length - 8, 4);
  wav.write('WAVEfmt ', 8);
  wav.writeUInt32LE(16, 16);
  wav.writeUInt16LE(1, 20); // PCM
  wav.writeUInt16LE(1, 22); // channels
  wav.writeUInt32LE(rate_hz, 24);
  wav.writeUInt32LE(2 * rate_hz, 28);
  wav.writeUInt16LE(2, 32);
  wav.writeUInt16LE(16, 34);
  wav.write('data', 36);
  wav.writeUInt32LE(2 * samples.length, 40);
  samples.forEach((value, i) => wav.writeInt16LE(Math.round(value), header_bytes + 2 * i));
  writeFileSync(path, wav);
}
