// SPDX-License-Identifier: Apache-2.0
// The first bytes of every message and the 48-byte header of a frame: docs/spec/wire.md §1 and §2. Little-endian.
// Throws WireError; nothing is allocated before all checks have passed.
import { maxFrameBytes, maxLayer } from './limits';
import { malformed, tooLarge, unsupported } from './wire_error';

export const magic = 0x4352;
export const version = 1;
export const preambleBytes = 4;
export const frameHeaderBytes = 48;
export const unknownClockError_us = 0xffffffff;

const flagKey = 1;
const flagLast = 2;
const flagSmall = 4;

export enum MessageType {
  Frame = 1,
  Control = 2,
  Audio = 3,
}

export interface FrameHeader {
  key: boolean; // decodable without other frames
  last: boolean; // the last frame of its set on this connection
  small: boolean; // of the sensor's small rendition, which is numbered by itself
  sensor: number;
  layer: number; // 0: later frames may depend on it
  codec: number;
  seq: number; // modulo 2^32
  setId: bigint;
  capture_ns: bigint; // room time
  clockError_us: number; // unknownClockError_us: unknown
  baseSeq: number; // the layer-0 frame that this frame depends on
  payloadLength: number;
  headerLength: number;
}

export function messageType(message: DataView): MessageType {
  if (message.byteLength < preambleBytes || message.getUint16(0, true) !== magic) {
    throw malformed('this is not a roomcast message');
  }
  const found = message.getUint8(2);
  if (found !== version) throw unsupported(`roomcast version ${found} is not supported, only version ${version}`);
  const type = message.getUint8(3);
  if (!(type in MessageType)) throw unsupported(`message type ${type} is unknown`);
  return type;
}

function readHeader(message: DataView): FrameHeader {
  const flags = message.getUint16(6, true);
  return {
    key: (flags & flagKey) !== 0,
    last: (flags & flagLast) !== 0,
    small: (flags & flagSmall) !== 0,
    sensor: message.getUint16(8, true),
    layer: message.getUint8(10),
    codec: message.getUint8(11),
    seq: message.getUint32(12, true),
    setId: message.getBigUint64(16, true),
    capture_ns: message.getBigInt64(24, true),
    clockError_us: message.getUint32(32, true),
    baseSeq: message.getUint32(36, true),
    payloadLength: message.getUint32(40, true),
    headerLength: message.getUint16(4, true),
  };
}

export function parseFrameHeader(message: DataView): FrameHeader {
  if (messageType(message) !== MessageType.Frame) throw malformed('this message is not a frame');
  if (message.byteLength > maxFrameBytes) throw tooLarge('a frame is at most 2 MiB, header included');
  if (message.byteLength < frameHeaderBytes) throw malformed('a frame message ends inside its header');
  const header = readHeader(message);
  if (header.headerLength < frameHeaderBytes) throw malformed('a frame header is at least 48 bytes long');
  if (header.headerLength + header.payloadLength !== message.byteLength) {
    throw malformed("a frame's header and payload lengths do not add up to its message's length");
  }
  if (header.layer > maxLayer) throw malformed("a frame's temporal layer is at most 7");
  if (header.key && header.baseSeq !== header.seq) {
    throw malformed('a key frame needs no other frame: its base_seq equals its seq');
  }
  return header;
}

export function framePayload(message: Uint8Array, header: FrameHeader): Uint8Array {
  return message.subarray(header.headerLength, header.headerLength + header.payloadLength);
}
