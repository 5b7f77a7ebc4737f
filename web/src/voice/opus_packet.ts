// SPDX-License-Identifier: Apache-2.0
// The length of an Opus packet in time, from its first two bytes (RFC 6716 §3.1 and §3.2). Packets of strangers may hold
// up to 120 ms; a decoder is given only what a speaker may send.

const frame_ms = [
  ...[10, 20, 40, 60], // SILK, narrowband
  ...[10, 20, 40, 60], // SILK, medium band
  ...[10, 20, 40, 60], // SILK, wideband
  ...[10, 20], // hybrid, super-wideband
  ...[10, 20], // hybrid, fullband
  ...[2.5, 5, 10, 20], // CELT, narrowband
  ...[2.5, 5, 10, 20], // CELT, wideband
  ...[2.5, 5, 10, 20], // CELT, super-wideband
  ...[2.5, 5, 10, 20], // CELT, fullband
];

/** 0: this is no Opus packet. */
export function opusDuration_ms(packet: Uint8Array): number {
  const toc = packet[0];
  if (toc === undefined) return 0;
  return frame_ms[toc >> 3]! * frameCount(toc & 3, packet);
}

function frameCount(code: number, packet: Uint8Array): number {
  if (code === 0) return 1;
  if (code < 3) return 2;
  return (packet[1] ?? 0) & 63;
}
