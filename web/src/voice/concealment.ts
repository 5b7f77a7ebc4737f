// SPDX-License-Identifier: Apache-2.0
// Conceals gaps in speech: the last pitch period goes on, for a while, and fades. Also lengthens and shortens a packet by
// a pitch period. Source: ITU-T G.711 Appendix I (waveform substitution), and time-scale modification by overlap-add.
// 48 kHz, one channel; nothing is allocated but the results of lengthened() and shortened().

const shortestPeriod = 120; // 2.5 ms, 400 Hz
const longestPeriod = 720; // 15 ms, 67 Hz
const compared = 480; // samples of the end of the history
const stride = 4; // of the comparison: voice has its pitch below 6 kHz
const fullFor = 960; // samples at full loudness, then down to nothing at
const silentAfter = 2880; // 60 ms
export const historySamples = longestPeriod + compared;

/** The lag at which the last samples resemble the earlier ones most (normalised cross-correlation). */
export function pitchPeriod(history: Float32Array): number {
  const end = history.length;
  let best = longestPeriod;
  let bestLikeness = -Infinity;
  for (let lag = shortestPeriod; lag <= longestPeriod; lag += stride) {
    let product = 0;
    let energy = 1e-9;
    for (let i = end - compared; i < end; i += stride) {
      const before = history[i - lag]!;
      product += history[i]! * before;
      energy += before * before;
    }
    const likeness = product / Math.sqrt(energy);
    if (likeness <= bestLikeness) continue;
    bestLikeness = likeness;
    best = lag;
  }
  return best;
}

/** What was heard last, and what to play where nothing has come. */
export class Concealment {
  private readonly history = new Float32Array(historySamples);
  private period = longestPeriod;
  private made = 0; // samples since the gap began; 0: there is none

  get isOn(): boolean {
    return this.made > 0;
  }

  /** Samples of the speaker that are being played. */
  heard(samples: Float32Array): void {
    this.made = 0;
    const kept = Math.min(samples.length, historySamples);
    this.history.copyWithin(0, kept);
    this.history.set(samples.subarray(samples.length - kept), historySamples - kept);
  }

  /** Fills `out` with the continuation. */
  fill(out: Float32Array): void {
    if (this.made === 0) this.period = pitchPeriod(this.history);
    const begin = historySamples - this.period;
    for (let i = 0; i < out.length; i++, this.made++) {
      const fading = (this.made - fullFor) / (silentAfter - fullFor);
      const loudness = Math.min(1, Math.max(0, 1 - fading));
      out[i] = loudness * this.history[begin + (this.made % this.period)]!;
    }
  }

  forget(): void {
    this.history.fill(0);
    this.made = 0;
  }
}

/** Fades from `before` to the samples over the length of `before`, in place. */
export function fadeInto(samples: Float32Array, before: Float32Array): void {
  for (let i = 0; i < before.length; i++) {
    const share = (i + 1) / (before.length + 1);
    samples[i] = share * samples[i]! + (1 - share) * before[i]!;
  }
}

/** The packet without one of its periods. */
export function shortened(samples: Float32Array): Float32Array {
  const period = periodOf(samples);
  const out = new Float32Array(samples.length - period);
  for (let i = 0; i < out.length; i++) {
    const share = Math.min(1, i / period);
    out[i] = (1 - share) * samples[i]! + share * samples[i + period]!;
  }
  return out;
}

/** The packet with one of its periods twice. */
export function lengthened(samples: Float32Array): Float32Array {
  const period = periodOf(samples);
  const out = new Float32Array(samples.length + period);
  out.set(samples.subarray(0, period));
  for (let i = period; i < out.length; i++) {
    const share = Math.min(1, (i - period) / period);
    const ahead = i < samples.length ? samples[i]! : 0;
    out[i] = (1 - share) * ahead + share * samples[i - period]!;
  }
  return out;
}

/** Not longer than half a packet. */
function periodOf(samples: Float32Array): number {
  const history = new Float32Array(historySamples);
  history.set(samples, historySamples - samples.length);
  return Math.min(pitchPeriod(history), samples.length >> 1);
}
