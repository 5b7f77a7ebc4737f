// SPDX-License-Identifier: Apache-2.0
// What a page's microphone gives and what it plays, and the chirps in it.
import { setTimeout as delay } from 'node:timers/promises';
import { findChirp, period_s, rate_hz } from './chirp.mjs';

export const clear = 0.5; // likeness of a chirp that was heard

/** Runs before the page's own scripts: keeps the last 0.7 s of what the microphone gives and of what is played. */
export function listenIn() {
  const tap = (context, source) => {
    const analyser = new AnalyserNode(context, { fftSize: 32768 });
    connect.call(source, analyser);
    return () => {
      const samples = new Float32Array(analyser.fftSize);
      analyser.getFloatTimeDomainData(samples);
      return { samples: [...samples], end_ms: performance.timeOrigin + performance.now(), out_s: context.outputLatency };
    };
  };
  const { connect } = AudioNode.prototype;
  const { createMediaStreamSource } = AudioContext.prototype;
  AudioContext.prototype.createMediaStreamSource = function (stream) {
    const source = createMediaStreamSource.call(this, stream);
    window.mouth = tap(this, source);
    return source;
  };
  AudioNode.prototype.connect = function (to, ...more) {
    if (to instanceof AudioDestinationNode) window.ear = tap(this.context, this);
    return connect.call(this, to, ...more);
  };
}

/**
 * Page times, ms, at which chirps begin in what `ask` returns, for as long as it takes to find `count`; or until the
 * promise `over` is settled.
 */
export async function chirpTimes(ask, count, over = undefined) {
  const times = [];
  const deadline = Date.now() + 60_000;
  let isOver = false;
  const end = () => (isOver = true);
  void over?.then(end, end);
  while (times.length < count && !isOver && Date.now() < deadline) {
    const { samples, end_ms, out_s } = await ask();
    const { at, likeness } = findChirp(samples);
    const time_ms = end_ms - (1000 * (samples.length - at)) / rate_hz;
    const isNew = times.every((other) => Math.abs(other.time_ms - time_ms) > 500 * period_s);
    if (likeness > clear && isNew) times.push({ time_ms, likeness, out_ms: 1000 * out_s });
    await delay(150);
  }
  return times;
}
