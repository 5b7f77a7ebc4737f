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

export const stride = 4; // every fourth sample is enough to know it
const shape = everyFourth(chirp);
const energyOfShape = shape.reduce((sum, value) => sum + value * value, 0);
const silence = 1e-9; // energy

export function everyFourth(samples) {
  return Float32Array.from({ length: Math.ceil(samples.length / stride) }, (_, i) => samples[stride * i]);
}

/** Where the chirp begins in the samples, and how well it fits: 1 is perfectly. */
export function findChirp(samples) {
  const { at, likeness } = findChirpIn(everyFourth(samples));
  return { at: stride * at, likeness };
}

/** The same in what everyFourth gives. */
export function findChirpIn(samples) {
  const energyUntil = new Float64Array(samples.length + 1);
  samples.forEach((value, i) => (energyUntil[i + 1] = energyUntil[i] + value * value));
  let best = { at: 0, likeness: 0 };
  for (let at = 0; at + shape.length <= samples.length; at++) {
    const energy = energyUntil[at + shape.length] - energyUntil[at];
    if (energy < silence) continue;
    let product = 0;
    for (let i = 0; i < shape.length; i++) product += samples[at + i] * shape[i];
    const likeness = Math.abs(product) / Math.sqrt(energy * energyOfShape);
    if (likeness > best.likeness) best = { at, likeness };
  }
  return best;
}
