// SPDX-License-Identifier: Apache-2.0
// The scripts of the AudioWorklet: one processor gathers the microphone's samples into blocks of 20 ms, one plays a
// speaker's packets. They exchange messages with the voice worker directly, past the page, which may be busy drawing.
// From the page comes that port, and null at the end: a processor that only loses its connections would run on.
import { JitterBuffer } from './jitter_buffer';
import { packetSamples, silence, type PcmPacket, type Silence } from './voice_packet';

const figuresEvery = 128; // quanta of 128 samples, a third of a second

export interface RecordedBlock {
  first: number; // number of its first sample
  samples: Float32Array<ArrayBuffer>;
}

class Microphone extends AudioWorkletProcessor {
  private block = new Float32Array(packetSamples);
  private filled = 0;
  private to: MessagePort | undefined;
  private isOver = false;

  constructor() {
    super();
    this.port.onmessage = ({ data }: MessageEvent<MessagePort | null>) => {
      this.isOver = data === null;
      if (data) this.to = data;
    };
  }

  process([input]: Float32Array[][]): boolean {
    const samples = input?.[0];
    if (this.isOver) return false;
    if (!samples || !this.to) return true;
    const space = packetSamples - this.filled;
    this.block.set(samples.subarray(0, space), this.filled);
    this.filled += Math.min(space, samples.length);
    if (this.filled < packetSamples) return true;
    const end = currentFrame + Math.min(space, samples.length);
    const block: RecordedBlock = { first: end - packetSamples, samples: this.block };
    this.to.postMessage(block, [this.block.buffer]);
    this.block = new Float32Array(packetSamples);
    this.block.set(samples.subarray(space));
    this.filled = Math.max(0, samples.length - space);
    return true;
  }
}

class Player extends AudioWorkletProcessor {
  private readonly buffer = new JitterBuffer();
  private quanta = 0;
  private isOver = false;

  constructor() {
    super();
    this.port.onmessage = ({ data: from }: MessageEvent<MessagePort | null>) => {
      this.isOver = from === null;
      if (!from) return;
      from.onmessage = ({ data }: MessageEvent<PcmPacket | Silence>) => {
        if (data === silence) this.buffer.silence();
        else this.buffer.push(data, 1000 * currentTime);
      };
    };
  }

  process(_: Float32Array[][], [output]: Float32Array[][]): boolean {
    const out = output?.[0];
    if (out) this.buffer.pull(out, 1000 * currentTime);
    if (++this.quanta % figuresEvery === 0) this.port.postMessage(this.buffer.figures);
    return !this.isOver;
  }
}

registerProcessor('roomcast-microphone', Microphone);
registerProcessor('roomcast-player', Player);
