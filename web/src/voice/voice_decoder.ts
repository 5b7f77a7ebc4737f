// SPDX-License-Identifier: Apache-2.0
// One speaker's Opus packets to samples (WebCodecs). Broken packets are left out; a decoder that has failed is replaced,
// not more often than once in a while.
import { opusDuration_ms } from './opus_packet';
import { packet_ms, packetSamples, sampleRate_hz, type HeardPacket, type PcmPacket } from './voice_packet';

const mostUnfinished = 25; // packets in the decoder
const restWhenBroken_ms = 500;

export const decoderConfig: AudioDecoderConfig = { codec: 'opus', sampleRate: sampleRate_hz, numberOfChannels: 1 };

type Inside = Pick<HeardPacket, 'seq' | 'capture_ms' | 'ends'>;

export class VoiceDecoder {
  private decoder: AudioDecoder | undefined;
  private inside: Inside[] = []; // of packets in the decoder, in order
  private failedAt_ms = -Infinity;

  constructor(private readonly decoded: (packet: PcmPacket) => void) {}

  take({ seq, capture_ms, ends, payload }: HeardPacket): void {
    if (opusDuration_ms(payload) !== packet_ms) return;
    if (this.decoder?.state !== 'configured' && !this.open()) return;
    if (this.decoder!.decodeQueueSize > mostUnfinished) return;
    this.inside.push({ seq, capture_ms, ends });
    this.decoder!.decode(new EncodedAudioChunk({ type: 'key', timestamp: 1000 * packet_ms * seq, data: payload }));
  }

  /** Drops what is being decoded. */
  restart(): void {
    this.close();
    this.decoder = undefined;
  }

  close(): void {
    if (this.decoder?.state === 'configured') this.decoder.close();
  }

  private open(): boolean {
    if (performance.now() - this.failedAt_ms < restWhenBroken_ms) return false;
    const inside: Inside[] = (this.inside = []);
    this.decoder = new AudioDecoder({
      output: (data) => this.came(data, inside.shift()),
      error: () => (this.failedAt_ms = performance.now()),
    });
    this.decoder.configure(decoderConfig);
    return true;
  }

  private came(data: AudioData, packet: Inside | undefined): void {
    // The first packet of a decoder may come out shorter: Opus has 6.5 ms to skip.
    const samples = new Float32Array(packetSamples);
    const count = Math.min(packetSamples, data.numberOfFrames);
    const into = samples.subarray(packetSamples - count);
    data.copyTo(into, { planeIndex: 0, format: 'f32-planar', frameCount: count });
    data.close();
    if (packet) this.decoded({ ...packet, samples });
  }
}
