// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { rgbaFromYcbcr, type YcbcrPlanes } from './color_conversion';

type Rgb = [number, number, number];

/** docs/spec/codec.md §3.1, in floating point. */
function ycbcrOf([r, g, b]: Rgb): Rgb {
  const y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
  return [
    Math.round(16 + (219 * y) / 255),
    Math.round(128 + (224 * (b - y)) / (1.8556 * 255)),
    Math.round(128 + (224 * (r - y)) / (1.5748 * 255)),
  ];
}

/** A picture of one colour, 3x3: odd sides, so the last chroma sample covers fewer pixels. */
function planesOf(rgb: Rgb, interleaved: boolean): YcbcrPlanes {
  const [y, cb, cr] = ycbcrOf(rgb);
  const bytes = new Uint8Array(12 + 8);
  bytes.fill(y, 0, 12);
  for (let i = 0; i < 8; i++) bytes[12 + i] = (interleaved ? i % 2 === 0 : i < 4) ? cb : cr;
  return interleaved
    ? {
        bytes,
        y: { offset: 0, stride: 4 },
        cb: { offset: 12, stride: 4 },
        cr: { offset: 13, stride: 4 },
        chromaStep: 2,
        scale: 1,
      }
    : {
        bytes,
        y: { offset: 0, stride: 4 },
        cb: { offset: 12, stride: 2 },
        cr: { offset: 16, stride: 2 },
        chromaStep: 1,
        scale: 1,
      };
}

const seen = Uint8Array.from([255, 0, 255, 0, 255, 0, 255, 0, 255]);
const colors: Rgb[] = [
  [0, 0, 0],
  [255, 255, 255],
  [255, 0, 0],
  [0, 255, 0],
  [0, 0, 255],
  [120, 80, 40],
  [13, 200, 77],
];

describe('colour conversion', () => {
  test('a picture twice as fine gives each pixel the mean of its four', () => {
    // 2x1 pixels of 4x2: luma 16, 116, 66, 66 on the left; 235 on the right; no colour.
    const bytes = Uint8Array.from([16, 116, 235, 235, 66, 66, 235, 235, 128, 128, 128, 128]);
    const planes: YcbcrPlanes = {
      bytes,
      y: { offset: 0, stride: 4 },
      cb: { offset: 8, stride: 2 },
      cr: { offset: 10, stride: 2 },
      chromaStep: 1,
      scale: 2,
    };
    const rgba = new Uint8Array(8);
    rgbaFromYcbcr(planes, Uint8Array.from([255, 0]), 2, 1, rgba);
    const grey = Math.round(((66 - 16) * 255) / 219);
    expect([...rgba]).toEqual([grey, grey, grey, 255, 255, 255, 255, 0]);
  });

  for (const interleaved of [false, true]) {
    for (const rgb of colors) {
      test(`gives ${rgb.join(',')} back within rounding (${interleaved ? 'NV12' : 'I420'})`, () => {
        const rgba = new Uint8Array(36);
        rgbaFromYcbcr(planesOf(rgb, interleaved), seen, 3, 3, rgba);
        for (let pixel = 0; pixel < 9; pixel++) {
          for (let c = 0; c < 3; c++) expect(Math.abs(rgba[4 * pixel + c]! - rgb[c]!)).toBeLessThanOrEqual(2);
          expect(rgba[4 * pixel + 3]).toBe(seen[pixel]);
        }
      });
    }
  }

  test('takes each pixel its own luma and its block its own chroma', () => {
    const bytes = Uint8Array.from([16, 235, 16, 235, 128, 200, 128, 90]); // 4x1: y y y y, cb cb, cr cr
    const rgba = new Uint8Array(16);
    const planes: YcbcrPlanes = {
      bytes,
      y: { offset: 0, stride: 4 },
      cb: { offset: 4, stride: 2 },
      cr: { offset: 6, stride: 2 },
      chromaStep: 1,
      scale: 1,
    };
    rgbaFromYcbcr(planes, new Uint8Array(4).fill(255), 4, 1, rgba);
    expect([...rgba.slice(0, 8)]).toEqual([0, 0, 0, 255, 255, 255, 255, 255]);
    expect(rgba[8]).toBe(0);
    expect(rgba[10]).toBeGreaterThan(rgba[9]!);
  });
});
