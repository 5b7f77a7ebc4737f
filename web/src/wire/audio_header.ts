// SPDX-License-Identifier: Apache-2.0
// An audio packet, 20 ms of a person's voice: a 28-byte header and one Opus packet. docs/spec/wire.md §6. Little-endian.
// Throws WireError.
import { magic, MessageType, messageType, version } from './frame_header';
import { maxAudioBytes, maxAudioPayloadBytes } from './limits';
import { malformed, tooLarge } from './wire_error';

export const audioHeaderBytes = 28;
export const audioCodecOpus = 1;

const flagEnds = 1;

export interface AudioHeader {
  ends: boolean; // the speaker pauses after this packet
  speaker: number; // viewer ID, written by the hub; 0 from the speaker
  seq: number; // counts the speaker's packets, modulo 2^32
  capture_ns: bigint; // room time of the first sample
  codec: number;
  payloadLength: number;
  headerLength: number;
}

function readHeader(message: DataView): AudioHeader {
  return {
    ends: (message.getUint16(6, true) & flagEnds) !== 0,
    speaker: message.getUint32(8, true),
    seq: message.getUint32(12, true),
    capture_ns: message.getBigInt64(16, true),
    codec: message.getUint8(26),
    payloadLength: message.getUint16(24, true),
    headerLength: message.getUint16(4, true),
  };
}

export function parseAudioHeader(message: DataView): AudioHeader {
  if (messageType(message) !== MessageType.Audio) throw malformed('this message is not an audio packet');
  if (message.byteLength > maxAudioBytes) throw tooLarge(`an audio packet is at most ${maxAudioBytes} bytes, header included`);
  if (message.byteLength < audioHeaderBytes) throw malformed('an audio packet ends inside its header');
  const header = readHeader(message);
  const { headerLength, payloadLength } = header;
  if (headerLength < audioHeaderBytes) throw malformed('the header of an audio packet is at least 28 bytes long');
  if (headerLength + payloadLength !== message.byteLength) {
    throw malformed("an audio packet's header and payload lengths do not add up to its message's length");
  }
  if (payloadLength > maxAudioPayloadBytes) throw tooLarge(`the payload of an audio packet is at most ${maxAudioPayloadBytes} bytes`);
  if (payloadLength === 0) throw malformed('an audio packet needs a payload');
  return header;
}

export function audioPayload(message: Uint8Array, { headerLength }: AudioHeader): Uint8Array {
  return message.subarray(headerLength);
}

/** The whole message of one Opus packet; the hub writes the speaker. */
export function encodeAudio(
  { ends, seq, capture_ns }: Pick<AudioHeader, 'ends' | 'seq' | 'capture_ns'>,
  payload: Uint8Array,
): Uint8Array<ArrayBuffer> {
  if (payload.length === 0 || payload.length > maxAudioPayloadBytes) throw tooLarge('this is no payload of an audio packet');
  const message = new Uint8Array(audioHeaderBytes + payload.length);
  const view = new DataView(message.buffer);
  view.setUint16(0, magic, true);
  view.setUint8(2, version);
  view.setUint8(3, MessageType.Audio);
  view.setUint16(4, audioHeaderBytes, true);
  view.setUint16(6, ends ? flagEnds : 0, true);
  view.setUint32(12, seq, true);
  view.setBigInt64(16, capture_ns, true);
  view.setUint16(24, payload.length, true);
  view.setUint8(26, audioCodecOpus);
  message.set(payload, audioHeaderBytes);
  return message;
}
