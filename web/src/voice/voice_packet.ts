// SPDX-License-Identifier: Apache-2.0
// Voice in the page: 20 ms of one channel at 48 kHz, as PCM or as one packet of Opus.

export const sampleRate_hz = 48_000;
export const packet_ms = 20;
export const packetSamples = 960;

/** Decoded voice on its way to the ear. */
export interface PcmPacket {
  seq: number; // of the speaker, modulo 2^32
  capture_ms: number; // of the first sample, by any clock that runs evenly
  ends: boolean; // the speaker pauses after it
  samples: Float32Array; // packetSamples of them
}

/** An encoded packet that the hub has forwarded. */
export interface HeardPacket {
  speaker: number;
  seq: number;
  capture_ms: number; // room time
  ends: boolean;
  payload: Uint8Array;
}

/** In place of packets: what was said before is not to be heard any more, because others follow from another time. */
export const silence = 'silence';
export type Silence = typeof silence;

/** An encoded packet on its way to the hub. */
export interface SpokenPacket {
  capture_ms: number; // page time (stream/protocol.ts)
  ends: boolean;
  payload: Uint8Array<ArrayBuffer>;
}

/** How far sequence number `to` is after `from`, modulo 2^32: -2^31 to 2^31 - 1. */
export function seqDistance(from: number, to: number): number {
  return (to - from) | 0;
}
