// SPDX-License-Identifier: Apache-2.0
// What a page's microphone gives and what it plays, and the chirps in it. On a busy machine seconds pass between two looks
// at a page, so that the page keeps the last four, and a look takes all since the one before: no chirp is missed.
import { setTimeout as delay } from 'node:timers/promises';
import { findChirpIn, period_s, rate_hz, stride } from './chirp.mjs';

const clear = 0.5; // likeness of a chirp that was heard
const pause_ms = 150;
const patience_ms = 60_000;

/** Runs before the page's own scripts: keeps what the microphone gives and what is played. */
export function listenIn() {
  const stretches = 9; // of 0.68 s, the longest that an analyser keeps
  const step_s = 0.45; // from one to the next; both have a chirp of 0.2 s at their border whole
  const slack_s = 0.1; // a busy machine may take so long from one to the next
  const stride = 4; // of chirp.mjs

  const inBase64 = (samples) => {
    const kept = Float32Array.from({ length: samples.length / stride }, (_, i) => samples[stride * i]);
    const bytes = new Uint8Array(kept.buffer);
    let text = '';
    for (let at = 0; at < bytes.length; at += 8192) text += String.fromCharCode(...bytes.subarray(at, at + 8192));
    return btoa(text);
  };

  /** Returns a function that gives the last stretch, or all of them since an instant of the context's clock. */
  const tap = (context, source) => {
    const ears = Array.from({ length: stretches }, (_, number) => {
      const late_s = number * step_s;
      const analyser = new AnalyserNode(context, { fftSize: 32768 });
      const later = late_s > 0 && new DelayNode(context, { maxDelayTime: late_s, delayTime: late_s });
      if (later) connect.call(later, analyser);
      connect.call(source, later || analyser);
      return { analyser, late_s };
    });
    const samples = new Float32Array(ears[0].analyser.fftSize);
    return (since_s) => {
      const now_s = context.currentTime;
      const count = since_s === undefined ? 1 : Math.ceil((now_s + slack_s - since_s) / step_s);
      const heard = ears.slice(0, Math.max(1, count)).map(({ analyser, late_s }) => {
        analyser.getFloatTimeDomainData(samples);
        const end_ms = performance.timeOrigin + performance.now() - 1000 * late_s;
        return { samples: inBase64(samples), end_ms };
      });
      return { heard, now_s, out_s: context.outputLatency };
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

function samplesOf(base64) {
  const bytes = Buffer.from(base64, 'base64');
  return Float32Array.from({ length: bytes.length / 4 }, (_, i) => bytes.readFloatLE(4 * i));
}

/** How loud the loudest sample is that the page has played in the last 0.7 s. */
export async function loudnessOf(page) {
  const last = await page.evaluate(() => window.ear?.().heard[0].samples);
  return last === undefined ? 0 : samplesOf(last).reduce((most, value) => Math.max(most, Math.abs(value)), 0);
}

/** Whether no chirp is played for longer than it takes from one to the next. Begins with the last 0.7 s. */
export async function isSilent(page) {
  const times = await chirpTimes(page, 'ear', 1, delay(1250 * period_s));
  return times.length === 0;
}

/**
 * Page times, ms, at which chirps begin in what the page's `organ` ("mouth" or "ear") gives from now on, for as long as it
 * takes to find `count`; or until the promise `over` is settled.
 */
export async function chirpTimes(page, organ, count, over = undefined) {
  const times = [];
  const deadline = Date.now() + patience_ms;
  let isOver = false;
  const end = () => (isOver = true);
  void over?.then(end, end);
  let since_s;
  const listen = async () => {
    const look = await page.evaluate(([name, since]) => window[name]?.(since), [organ, since_s]);
    since_s = look?.now_s ?? since_s;
    for (const { samples, end_ms } of look?.heard.reverse() ?? []) {
      const kept = samplesOf(samples);
      const { at, likeness } = findChirpIn(kept);
      const time_ms = end_ms - (1000 * stride * (kept.length - at)) / rate_hz;
      const isNew = times.every((other) => Math.abs(other.time_ms - time_ms) > 500 * period_s);
      if (likeness > clear && isNew) times.push({ time_ms, likeness, out_ms: 1000 * look.out_s });
    }
  };
  while (times.length < count && !isOver && Date.now() < deadline) {
    await listen();
    await delay(pause_ms);
  }
  if (isOver) await listen(); // to the end
  return times.slice(0, count);
}
