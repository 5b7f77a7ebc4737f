// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { Concealment, fadeInto, historySamples, lengthened, pitchPeriod, shortened } from './concealment';
import { packetSamples, sampleRate_hz } from './voice_packet';

function tone(hz: number, length: number, from = 0): Float32Array {
  return Float32Array.from({ length }, (_, i) => Math.sin((2 * Math.PI * hz * (from + i)) / sampleRate_hz));
}

function largestStep(samples: Float32Array): number {
  let largest = 0;
  for (let i = 1; i < samples.length; i++) largest = Math.max(largest, Math.abs(samples[i]! - samples[i - 1]!));
  return largest;
}

/** Of a tone of this frequency. */
const step = (hz: number) => (2 * Math.PI * hz) / sampleRate_hz;

describe('concealment', () => {
  test('finds the pitch', () => {
    for (const hz of [80, 100, 150, 200, 240]) {
      const period = pitchPeriod(tone(hz, historySamples));
      const whole = sampleRate_hz / hz;
      expect(Math.abs(period / whole - Math.round(period / whole))).toBeLessThan(0.02);
    }
  });

  test('continues a tone without a click, as loud for 20 ms and silent after 60', () => {
    const concealment = new Concealment();
    const said = tone(200, 4 * packetSamples);
    concealment.heard(said);
    const out = new Float32Array(4 * packetSamples);
    concealment.fill(out);
    const whole = new Float32Array(said.length + out.length);
    whole.set(said);
    whole.set(out, said.length);
    expect(largestStep(whole)).toBeLessThan(3 * step(200));
    expect(Math.max(...out.subarray(0, packetSamples))).toBeGreaterThan(0.99);
    expect(out.subarray(3 * packetSamples).every((value) => Math.abs(value) === 0)).toBe(true);
  });

  test('of silence is silence', () => {
    const out = new Float32Array(packetSamples).fill(1);
    new Concealment().fill(out);
    expect(out.every((value) => value === 0)).toBe(true);
  });

  test('fades into the next packet', () => {
    const samples = new Float32Array(10).fill(1);
    fadeInto(samples, new Float32Array(4).fill(0));
    expect([...samples.subarray(0, 4)]).toEqual([0.2, 0.4, 0.6, 0.8].map((value) => Math.fround(value)));
    expect(samples[4]).toBe(1);
  });
});

describe('a packet', () => {
  test('becomes shorter and longer by a period without a click', () => {
    for (const hz of [100, 150, 200, 240]) {
      const said = tone(hz, packetSamples);
      for (const changed of [shortened(said), lengthened(said)]) {
        const periods = Math.abs(changed.length - said.length) / (sampleRate_hz / hz);
        expect(Math.abs(periods - Math.round(periods))).toBeLessThan(0.05);
        expect(periods).toBeGreaterThan(0.5);
        expect(largestStep(changed)).toBeLessThan(3 * step(hz));
      }
      expect(shortened(said)[0]).toBe(said[0]);
      expect(shortened(said).at(-1)).toBe(said.at(-1));
      expect(lengthened(said)[0]).toBe(said[0]);
      expect(lengthened(said).at(-1)).toBeCloseTo(said.at(-1)!, 5);
    }
  });
});
