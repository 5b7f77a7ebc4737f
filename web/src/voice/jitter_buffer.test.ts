// SPDX-License-Identifier: Apache-2.0
// The buffer against simulated lines: what is played is compared with what was said.
import { describe, expect, test } from 'vitest';
import { JitterBuffer } from './jitter_buffer';
import { packet_ms, packetSamples, sampleRate_hz } from './voice_packet';

const quantum = 128; // samples that an AudioWorklet asks for

/** Reproducible random numbers, 0 to 1 (mulberry32). */
function randomFrom(seed: number): () => number {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** A voiced sound: 140 Hz with overtones, never silent for longer than a period. */
const second = Float32Array.from({ length: sampleRate_hz }, (_, sample) => {
  const t = sample / sampleRate_hz;
  return [1, 2, 3, 4, 5].reduce((sum, n) => sum + Math.sin(2 * Math.PI * 140 * n * t) / n / 4, 0);
});
const voiced = (sample: number) => second[sample % sampleRate_hz]!;

interface Line {
  seconds: number;
  jitter_ms?: number; // uniform
  loss?: number;
  delay_ms?: (said_ms: number) => number; // in addition
  rate?: number; // of the speaker's clock
  seed?: number;
  endsAt?: number; // this packet and no other ends
}

interface Heard {
  samples: Float32Array;
  buffer: JitterBuffer;
}

interface Arrival {
  seq: number;
  at_ms: number;
}

/** In-order delivery, as by a WebSocket: a late packet holds up those behind it. */
function listen({ seconds, jitter_ms = 0, loss = 0, delay_ms = () => 0, rate = 1, seed = 1, endsAt }: Line): Heard {
  const random = randomFrom(seed);
  const count = Math.round((1000 * seconds) / packet_ms);
  const arrivals: Arrival[] = [];
  let before_ms = 0;
  for (let seq = 0; seq < count; seq++) {
    const said_ms = (seq + 1) * packet_ms * rate; // it is complete
    before_ms = Math.max(before_ms, said_ms + 30 + jitter_ms * random() + delay_ms(said_ms));
    if (random() >= loss) arrivals.push({ seq, at_ms: before_ms });
  }
  return play(arrivals, seconds, rate, endsAt);
}

/** Several people on one line, whose packets hold up each other's. */
function listenToMany(people: number, { seconds, jitter_ms = 0, loss = 0, seed = 1 }: Line): Heard[] {
  const random = randomFrom(seed);
  const said = Array.from({ length: Math.round((1000 * seconds) / packet_ms) }, (_, seq) =>
    Array.from({ length: people }, (_, person) => ({ seq, person, said_ms: (seq + 1 + person / people) * packet_ms })));
  const arrivals = Array.from({ length: people }, (): Arrival[] => []);
  let before_ms = 0;
  for (const { seq, person, said_ms } of said.flat()) {
    before_ms = Math.max(before_ms, said_ms + 30 + jitter_ms * random());
    if (random() >= loss) arrivals[person]!.push({ seq, at_ms: before_ms });
  }
  return arrivals.map((each) => play(each, seconds, 1, undefined));
}

function play(arrivals: readonly Arrival[], seconds: number, rate: number, endsAt: number | undefined): Heard {
  const buffer = new JitterBuffer();
  const samples = new Float32Array(Math.round(((seconds + 0.5) * sampleRate_hz) / quantum) * quantum);
  for (let at = 0, i = 0; at < samples.length; at += quantum) {
    const now_ms = (1000 * at) / sampleRate_hz;
    for (; i < arrivals.length && arrivals[i]!.at_ms <= now_ms; i++) {
      const { seq } = arrivals[i]!;
      const said = Float32Array.from({ length: packetSamples }, (_, n) => voiced(seq * packetSamples + n));
      buffer.push({ seq, capture_ms: seq * packet_ms * rate, ends: seq === endsAt, samples: said }, arrivals[i]!.at_ms);
    }
    buffer.pull(samples.subarray(at, at + quantum), now_ms);
  }
  return { samples, buffer };
}

/** The longest silence, ms, between the first and the last sound. */
function longestGap_ms({ samples }: Heard, until_s = Infinity): number {
  const loud = (i: number) => Math.abs(samples[i]!) > 0.02;
  let last: number | undefined;
  let longest = 0;
  for (let i = 0; i < Math.min(samples.length, until_s * sampleRate_hz); i++) {
    if (!loud(i)) continue;
    if (last !== undefined) longest = Math.max(longest, i - last);
    last = i;
  }
  return (1000 * longest) / sampleRate_hz;
}

const period_ms = 1000 / 140;

describe('a jitter buffer', () => {
  test('on a steady line plays every packet once, unchanged', () => {
    const { samples, buffer } = listen({ seconds: 4 });
    expect(buffer.figures).toMatchObject({ played: 200, concealed: expect.any(Number), skipped: 0 });
    const begin = samples.findIndex((value) => value !== 0) - 1; // voiced(0) is 0
    expect(begin).toBeGreaterThan(0);
    expect(longestGap_ms({ samples, buffer }, 4)).toBeLessThan(period_ms);
  });

  test('with 50 ms of jitter and 2 % loss leaves no gap above 60 ms', () => {
    for (let seed = 1; seed <= 4; seed++) {
      const heard = listen({ seconds: 60, jitter_ms: 50, loss: 0.02, seed });
      expect(longestGap_ms(heard, 60)).toBeLessThanOrEqual(60);
      const { concealed, played, skipped } = heard.buffer.figures;
      expect(played + skipped).toBeGreaterThan(2850);
      expect(concealed / played).toBeLessThan(0.05);
    }
  });

  test('and so it is for each of eight people on the same line', () => {
    const all = listenToMany(8, { seconds: 30, jitter_ms: 50, loss: 0.02 });
    const gaps_ms = all.map((heard) => longestGap_ms(heard, 30));
    expect(Math.max(...gaps_ms)).toBeLessThanOrEqual(60);
    for (const { buffer } of all) {
      const { concealed, played, skipped } = buffer.figures;
      expect(played + skipped).toBeGreaterThan(1425);
      expect(concealed / played).toBeLessThan(0.05);
    }
  });

  test('waits as long as the jitter asks, and not longer', () => {
    expect(listen({ seconds: 30, jitter_ms: 3 }).buffer.delay.target_ms).toBeLessThan(25);
    const rough = listen({ seconds: 30, jitter_ms: 50 }).buffer.delay.target_ms;
    expect(rough).toBeGreaterThan(35);
    expect(rough).toBeLessThan(75);
  });

  test('comes down again after a rough time', () => {
    const rough = (said_ms: number) => (said_ms < 5000 ? (said_ms / packet_ms) % 3 === 0 ? 60 : 0 : 0);
    const { buffer } = listen({ seconds: 30, delay_ms: rough });
    expect(buffer.delay.target_ms).toBeLessThan(30);
  });

  test('after a stall of the line goes on, and catches up', () => {
    const stall = (said_ms: number) => (said_ms > 5000 && said_ms < 5600 ? 5600 - said_ms : 0);
    const heard = listen({ seconds: 20, delay_ms: stall });
    const { played, skipped } = heard.buffer.figures;
    expect(played + skipped).toBe(1000);
    expect(skipped).toBeLessThan(32);
    expect(heard.buffer.delay.target_ms).toBeLessThan(200);
  });

  test('follows a clock that is 0.1 % fast or slow without gaps', () => {
    for (const rate of [0.999, 1.001]) {
      const heard = listen({ seconds: 60, rate });
      expect(longestGap_ms(heard, 59)).toBeLessThanOrEqual(20);
    }
  });

  test('is silent without concealment after a packet that ends', () => {
    const { buffer } = listen({ seconds: 1, endsAt: 49 });
    expect(buffer.isSilent).toBe(true);
    expect(buffer.figures.concealed).toBeLessThan(1.5);
  });

  test('fades to silence within 60 ms when the speaker is cut off', () => {
    const { buffer, samples } = listen({ seconds: 1 });
    expect(buffer.isSilent).toBe(true);
    expect(buffer.figures.concealed).toBeLessThanOrEqual(3 + 1.5);
    expect(samples.subarray(Math.round(1.3 * sampleRate_hz)).every((value) => value === 0)).toBe(true);
  });

  test('takes a jump of the numbers as a new beginning', () => {
    const buffer = new JitterBuffer();
    const out = new Float32Array(packetSamples);
    const samples = new Float32Array(packetSamples).fill(0.5);
    let now_ms = 0;
    const said = (seq: number) => {
      buffer.push({ seq, capture_ms: now_ms, ends: false, samples: samples.slice() }, now_ms);
      buffer.pull(out, (now_ms += packet_ms));
    };
    for (const seq of [0, 1, 2, 3, 4000, 4001, 4002, 4003, 4004, 4005, 7, 8, 9, 10, 11]) said(seq);
    expect(out.some((value) => value !== 0)).toBe(true);
  });

  test('goes on where the numbers begin again at 0', () => {
    const buffer = new JitterBuffer();
    const out = new Float32Array(packetSamples);
    for (let i = 0; i < 100; i++) {
      const seq = (0xffffffd0 + i) >>> 0;
      const samples = new Float32Array(packetSamples).fill(0.5);
      buffer.push({ seq, capture_ms: i * packet_ms, ends: false, samples }, i * packet_ms);
      buffer.pull(out, (i + 1) * packet_ms);
    }
    expect(buffer.figures.played).toBeGreaterThan(90);
    expect(buffer.figures.skipped).toBe(0);
  });

  test('keeps a bounded number of packets, whatever comes', () => {
    const buffer = new JitterBuffer();
    for (let seq = 0; seq < 100_000; seq++) {
      buffer.push({ seq, capture_ms: 1e9, ends: false, samples: new Float32Array(packetSamples) }, 0);
    }
    expect(buffer.figures.skipped).toBeGreaterThanOrEqual(100_000 - 51);
  });

  test('that is silenced fades at once, and then plays what is of an earlier time', () => {
    const buffer = new JitterBuffer();
    const out = new Float32Array(quantum);
    const heard: number[] = [];
    let now_ms = 0;
    const say = (seq: number, capture_ms: number) => {
      const samples = Float32Array.from({ length: packetSamples }, (_, n) => voiced(seq * packetSamples + n));
      buffer.push({ seq, capture_ms, ends: false, samples }, now_ms);
    };
    const listenFor = (quanta: number) => {
      for (let i = 0; i < quanta; i++, now_ms += (1000 * quantum) / sampleRate_hz) {
        buffer.pull(out, now_ms);
        heard.push(Math.max(...out.map(Math.abs)));
      }
    };
    for (let seq = 100; seq < 120; seq++) {
      say(seq, 60_000 + seq * packet_ms);
      listenFor(7); // 18.7 ms
    }
    expect(Math.max(...heard.slice(-7))).toBeGreaterThan(0.3);
    buffer.silence();
    listenFor(3);
    listenFor(40);
    expect(Math.max(...heard.slice(-40))).toBe(0);
    for (let seq = 95; seq < 115; seq++) {
      say(seq, seq * packet_ms);
      listenFor(7);
    }
    expect(Math.max(...heard.slice(-7))).toBeGreaterThan(0.3);
  });
});
