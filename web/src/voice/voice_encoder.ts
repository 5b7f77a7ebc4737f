// SPDX-License-Identifier: Apache-2.0
// The microphone's blocks to Opus packets (WebCodecs), while the gate lets them through. The last packet before a pause
// says so.
import type { RecordedBlock } from './worklet';
import { SampleClock } from './sample_clock';
import { TalkGate } from './talk_gate';
import { packet_ms, sampleRate_hz, type SpokenPacket } from './voice_packet';

const bitrate = 32_000;
const mostUnfinished = 10; // packets in the encoder

export const encoderConfig = {
  codec: 'opus',
  sampleRate: sampleRate_hz,
  numberOfChannels: 1,
  bitrate,
  opus: { frameDuration: 1000 * packet_ms, application: 'voip', signal: 'voice' },
} as AudioEncoderConfig;

export interface VoiceEncoderEvents {
  packet(packet: SpokenPacket): void;
  fault(sentence: string): void;
}

export class VoiceEncoder {
  readonly gate = new TalkGate();
  isOn = false;
  private encoder: AudioEncoder | undefined;
  private clock = new SampleClock();
  private readonly inside: { capture_ms: number; ends: boolean }[] = []; // of blocks in the encoder, in order
  private wasOpen = false;

  constructor(private readonly events: VoiceEncoderEvents) {}

  /** Another microphone, or the same one again: its sample count begins anew. */
  restart(): void {
    this.clock = new SampleClock();
    this.wasOpen = false;
  }

  /** Whether the block is sent. */
  take({ first, samples }: RecordedBlock, now_ms: number): boolean {
    const capture_ms = this.clock.timeOf(first, samples.length, now_ms);
    const isOpen = this.gate.isOpen(samples) && this.isOn;
    if (isOpen || this.wasOpen) this.encode(samples, capture_ms, !isOpen);
    this.wasOpen = isOpen;
    return isOpen;
  }

  private encode(samples: Float32Array<ArrayBuffer>, capture_ms: number, ends: boolean): void {
    if (this.encoder?.state !== 'configured') this.open();
    if (this.encoder!.encodeQueueSize > mostUnfinished) return;
    this.inside.push({ capture_ms, ends });
    const data = new AudioData({
      format: 'f32-planar',
      sampleRate: sampleRate_hz,
      numberOfChannels: 1,
      numberOfFrames: samples.length,
      timestamp: Math.round(1000 * capture_ms),
      data: samples,
    });
    this.encoder!.encode(data);
    data.close();
  }

  private open(): void {
    this.inside.length = 0;
    this.encoder = new AudioEncoder({
      output: (chunk) => this.encoded(chunk),
      error: (error) => this.events.fault(error.message),
    });
    this.encoder.configure(encoderConfig);
  }

  private encoded(chunk: EncodedAudioChunk): void {
    const block = this.inside.shift();
    if (!block || chunk.byteLength === 0) return;
    const payload = new Uint8Array(chunk.byteLength);
    chunk.copyTo(payload);
    this.events.packet({ ...block, payload });
  }
}
