// SPDX-License-Identifier: Apache-2.0
// Decides which blocks of 20 ms are sent: those with a voice, or those while a key is held. A voice is what is clearly
// louder than the room's own noise, which is the least loudness of the last seconds.

export type TalkMode = 'voice' | 'push';

const quietest = 10 ** (-55 / 20); // of full scale; below it nothing counts as a voice
const aboveNoise = 3; // 10 dB
const hang_blocks = 20; // 400 ms, so that words are not cut off
const noiseWindow_blocks = 150; // 3 s

export class TalkGate {
  mode: TalkMode = 'voice';
  isPushed = false;
  private hang = 0;
  private noise = quietest;
  private least = Infinity;
  private blocks = 0;

  /** Whether the block is sent. */
  isOpen(samples: Float32Array): boolean {
    const loudness = loudnessOf(samples);
    this.learnNoise(loudness);
    if (this.mode === 'push') return this.isPushed;
    if (loudness > Math.max(quietest, aboveNoise * this.noise)) this.hang = hang_blocks;
    else if (this.hang > 0) this.hang--;
    return this.hang > 0;
  }

  private learnNoise(loudness: number): void {
    this.least = Math.min(this.least, loudness);
    this.noise = Math.min(this.noise, Math.max(loudness, quietest / aboveNoise));
    if (++this.blocks % noiseWindow_blocks !== 0) return;
    this.noise = this.least;
    this.least = Infinity;
  }
}

/** Root of the mean square; 1 is full scale. */
export function loudnessOf(samples: Float32Array): number {
  let sum = 0;
  for (const sample of samples) sum += sample * sample;
  return Math.sqrt(sum / samples.length);
}
