// SPDX-License-Identifier: Apache-2.0
// YCbCr 4:2:0 to RGBA: BT.709, limited range, 8 bits, as docs/spec/codec.md §3.1 says. Alpha is the colour mask.
// Fixed point with 16 fractional bits; chroma samples are repeated over their 2x2 pixels.

/** Three planes in one buffer. NV12 has Cb and Cr interleaved: chromaStep 2, and `cr` one byte after `cb`. */
export interface YcbcrPlanes {
  bytes: Uint8Array;
  y: { offset: number; stride: number };
  cb: { offset: number; stride: number };
  cr: { offset: number; stride: number };
  chromaStep: 1 | 2;
}

const one = 1 << 16;
const half = one >> 1;
const lumaGain = Math.round((255 / 219) * one);
const redOfCr = Math.round((1.5748 * 255 * one) / 224);
const blueOfCb = Math.round((1.8556 * 255 * one) / 224);
const greenOfCr = Math.round((1.5748 * (0.2126 / 0.7152) * 255 * one) / 224);
const greenOfCb = Math.round((1.8556 * (0.0722 / 0.7152) * 255 * one) / 224);

function clampedByte(fixed: number): number {
  const value = fixed >> 16;
  return value < 0 ? 0 : value > 255 ? 255 : value;
}

/** `seen` and `rgba` hold width*height pixels; `rgba` is written whole. */
export function rgbaFromYcbcr(
  planes: YcbcrPlanes,
  seen: Uint8Array,
  width: number,
  height: number,
  rgba: Uint8ClampedArray | Uint8Array,
): void {
  const { bytes, chromaStep } = planes;
  for (let row = 0; row < height; row++) {
    const yRow = planes.y.offset + row * planes.y.stride;
    const cbRow = planes.cb.offset + (row >> 1) * planes.cb.stride;
    const crRow = planes.cr.offset + (row >> 1) * planes.cr.stride;
    for (let column = 0; column < width; column++) {
      const luma = (bytes[yRow + column]! - 16) * lumaGain + half;
      const chromaAt = (column >> 1) * chromaStep;
      const cb = bytes[cbRow + chromaAt]! - 128;
      const cr = bytes[crRow + chromaAt]! - 128;
      const pixel = row * width + column;
      rgba[4 * pixel] = clampedByte(luma + redOfCr * cr);
      rgba[4 * pixel + 1] = clampedByte(luma - greenOfCb * cb - greenOfCr * cr);
      rgba[4 * pixel + 2] = clampedByte(luma + blueOfCb * cb);
      rgba[4 * pixel + 3] = seen[pixel]!;
    }
  }
}
