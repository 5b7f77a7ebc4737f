// SPDX-License-Identifier: Apache-2.0
// The golden payloads of the codec, decoded by roomcast_codec.wasm through the page's own code.
import { existsSync, readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { crc32 } from '../stream/crc32';
import { CodecModule, PayloadDecoder, PayloadError } from './codec_module';

interface GoldenPayload {
  file: string;
  width: number;
  height: number;
  key: boolean;
  depth_crc32: number;
  mask_crc32?: number;
  color_offset?: number;
  color_length?: number;
}

const golden = new URL('../../../tests/golden/', import.meta.url);
const wasm = new URL('../../../build/wasm/roomcast_codec.wasm', import.meta.url);
const built = existsSync(wasm);
const reason = built ? '' : ' (skipped: build/wasm/roomcast_codec.wasm is not built)';
const entries = JSON.parse(readFileSync(new URL('frames.json', golden), 'utf8')) as GoldenPayload[];

const read = (name: string) => new Uint8Array(readFileSync(new URL(name, golden)));
const loadCodec = () => CodecModule.load(readFileSync(wasm));

describe.skipIf(!built)(`golden payloads${reason}`, () => {
  // A stream's frames depend on each other: one decoder from each key frame to the next.
  let decoder: PayloadDecoder;
  for (const entry of entries) {
    test(`${entry.file} decodes to the depth, mask and colour of the index`, async () => {
      const payload = read(entry.file);
      if (entry.key) decoder = new PayloadDecoder(await loadCodec(), entry.width, entry.height);
      const { depth_mm, color } = decoder.decode(payload);
      expect(crc32(new Uint8Array(depth_mm.slice().buffer))).toBe(entry.depth_crc32);
      expect(color === undefined).toBe(entry.mask_crc32 === undefined);
      if (!color) return;
      expect(crc32(color.seen)).toBe(entry.mask_crc32);
      expect(color.key).toBe(entry.key);
      expect(color.vp9.byteOffset).toBe(payload.byteOffset + entry.color_offset!);
      expect(color.vp9.length).toBe(entry.color_length);
    });
  }

  test('a payload that is cut is refused with a sentence, and the decoder goes on', async () => {
    const { file, width, height, depth_crc32 } = entries.find((entry) => entry.mask_crc32 !== undefined)!;
    const decoder = new PayloadDecoder(await loadCodec(), width, height);
    const payload = read(file);
    for (let length = 0; length < payload.length; length += 97) {
      expect(() => decoder.decode(payload.subarray(0, length))).toThrow(PayloadError);
    }
    expect(crc32(new Uint8Array(decoder.decode(payload).depth_mm.slice().buffer))).toBe(depth_crc32);
    decoder.destroy();
  });

  test('a payload longer than any frame of its size is refused', async () => {
    const decoder = new PayloadDecoder(await loadCodec(), 16, 16);
    expect(() => decoder.decode(new Uint8Array(3 * 16 * 16 + 65536 + 1))).toThrow(/longer than any/);
  });

  test('a depth grid of an illegal size is refused', async () => {
    const codec = await loadCodec();
    expect(() => new PayloadDecoder(codec, 15, 16)).toThrow(/15x16/);
    expect(() => new PayloadDecoder(codec, 16, 4097)).toThrow(/16x4097/);
  });
});
