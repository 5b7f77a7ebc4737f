// SPDX-License-Identifier: Apache-2.0
// YCbCr 4:2:0 to RGBA: BT.709, limited range, 8 bits, per docs/spec/codec.md §3.1. Alpha is the colour mask. Fixed
// point with 16 fractional bits; chroma samples are repeated over their 2x2 pixels.

/** Three planes in one buffer. NV12 has Cb and Cr interleaved: chromaStep 2, and `cr` one byte after `cb`. */
export interface YcbcrPlanes {
  bytes: Uint8Array;
  y: { offset: number; stride: number };
  cb: { offset: number; stride: number };
  cr: { offset: number; stride: number };
  chromaStep: 1 | 2;
  /** Luma samples per depth pixel in each direction: 1, or 2, where each depth pixel has a chroma sample of its own. */
  scale: 1 | 2;
}

const one = 1 << 16;
const half = one >> 1;
const lumaGain = Math.round((255 / 219) * one);
const redOfCr = Math.round((1.5748 * 255 * one) / 224);
const blueOfCb = Math.round((1.8556 * 255 * one) / 224);
const greenOfCr = Math.round((1.5748 * (0.2126 / 0.7152) * 255 * one) / 224);
const greenOfCb = Math.round((1.8556 * (0.0722 / 0.7152) * 255 * one) / 224);

/** Clamps a fixed-point value to 0..255. */
const clamp = new Uint8Array(1024).map((_, i) => Math.min(255, Math.max(0, i - 384)));
const offset = (384 << 16) + half;

/**
 * For planes twice as fine as `width` x `height`: each pixel has one chroma sample and the mean of its four luma
 * samples.
 */
function rgbaFromFineYcbcr(planes: YcbcrPlanes, seen: Uint8Array, width: number, height: number, pixels: Uint32Array): void {
  const { bytes, chromaStep } = planes;
  for (let row = 0; row < height; row++) {
    let yAt = planes.y.offset + 2 * row * planes.y.stride;
    let cbAt = planes.cb.offset + row * planes.cb.stride;
    let crAt = planes.cr.offset + row * planes.cr.stride;
    const end = (row + 1) * width;
    for (let pixel = row * width; pixel < end; pixel++) {
      const below = yAt + planes.y.stride;
      const four = bytes[yAt]! + bytes[yAt + 1]! + bytes[below]! + bytes[below + 1]!;
      const luma = Math.imul(four - 64, lumaGain) >> 2;
      const cb = bytes[cbAt]! - 128;
      const cr = bytes[crAt]! - 128;
      const red = clamp[(luma + offset + redOfCr * cr) >> 16]!;
      const green = clamp[(luma + offset - greenOfCb * cb - greenOfCr * cr) >> 16]!;
      const blue = clamp[(luma + offset + blueOfCb * cb) >> 16]!;
      pixels[pixel] = red | (green << 8) | (blue << 16) | (seen[pixel]! << 24);
      yAt += 2;
      cbAt += chromaStep;
      crAt += chromaStep;
    }
  }
}

/**
 * `seen` and `rgba` have width*height pixels; `rgba` begins at a multiple of four bytes and is written completely. Each
 * pixel is written as one number (all machines that run browsers are little-endian), in pairs that share their chroma.
 */
export function rgbaFromYcbcr(
  planes: YcbcrPlanes,
  seen: Uint8Array,
  width: number,
  height: number,
  rgba: Uint8ClampedArray | Uint8Array,
): void {
  const { bytes, chromaStep } = planes;
  const pixels = new Uint32Array(rgba.buffer, rgba.byteOffset, width * height);
  if (planes.scale === 2) return rgbaFromFineYcbcr(planes, seen, width, height, pixels);
  for (let row = 0; row < height; row++) {
    let yAt = planes.y.offset + row * planes.y.stride;
    let cbAt = planes.cb.offset + (row >> 1) * planes.cb.stride;
    let crAt = planes.cr.offset + (row >> 1) * planes.cr.stride;
    const end = (row + 1) * width;
    for (let pixel = row * width; pixel < end; pixel += 2) {
      const cb = bytes[cbAt]! - 128;
      const cr = bytes[crAt]! - 128;
      cbAt += chromaStep;
      crAt += chromaStep;
      const red = (offset + redOfCr * cr) | 0;
      const green = (offset - greenOfCb * cb - greenOfCr * cr) | 0;
      const blue = (offset + blueOfCb * cb) | 0;
      const luma = Math.imul(bytes[yAt++]! - 16, lumaGain);
      const rgb =
        clamp[(luma + red) >> 16]! | (clamp[(luma + green) >> 16]! << 8) | (clamp[(luma + blue) >> 16]! << 16);
      pixels[pixel] = rgb | (seen[pixel]! << 24);
      if (pixel + 1 === end) break; // odd width: the last block is cut off
      const next = Math.imul(bytes[yAt++]! - 16, lumaGain);
      const beside =
        clamp[(next + red) >> 16]! | (clamp[(next + green) >> 16]! << 8) | (clamp[(next + blue) >> 16]! << 16);
      pixels[pixel + 1] = beside | (seen[pixel + 1]! << 24);
    }
  }
}
