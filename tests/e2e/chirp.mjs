// SPDX-License-Identifier: Apache-2.0
// A chirp as the sound of a fake microphone, and where it is in recorded samples.
import { writeWav } from '../wav_file.mjs';

export const rate_hz = 48_000;
const from_hz = 400;
const to_hz = 3000;
const length = 0.2 * rate_hz;
const loudness = 0.6;
export const period_s = 2; // of the file, which the browser plays again and again
const begin = 0.8 * rate_hz;

/** Rises from 400 to 3000 Hz within 0.2 s, with soft ends. */
const chirp = Float32Array.from({ length }, (_, i) => {
  const t = i / rate_hz;
  const phase = 2 * Math.PI * (from_hz * t + ((to_hz - from_hz) * t * t) / (2 * (length / rate_hz)));
  return Math.sin(phase) * Math.sin((Math.PI * i) / length) ** 0.5;
});

/** A WAV file, 16 bits, one channel: silence but for one chirp. */
export function writeChirp(path) {
  const samples = new Float32Array(period_s * rate_hz);
  samples.set(chirp.map((value) => loudness * 32767 * value), begin);
  writeWav(path, samples, rate_hz);
}

const stride = 4;

/** Where the chirp begins in the samples, and how well it fits: 1 is perfectly. */
export function findChirp(samples) {
  let best = { at: 0, likeness: 0 };
  const fine = (at, step) => {
    let product = 0;
    let energy = 1e-9;
    let own = 0;
    for (let i = 0; i < length; i += step) {
      product += samples[at + i] * chirp[i];
      energy += samples[at + i] ** 2;
      own += chirp[i] ** 2;
    }
    return Math.abs(product) / Math.sqrt(energy * own);
  };
  for (let at = 0; at + length <= samples.length; at += stride) {
    const likeness = fine(at, stride);
    if (likeness > best.likeness) best = { at, likeness };
  }
  return best;
}
