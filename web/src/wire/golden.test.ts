// SPDX-License-Identifier: Apache-2.0
// Reads the golden messages that the C++ tests write and read.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { toJson } from '@bufbuild/protobuf';
import { describe, expect, test } from 'vitest';
import { ControlSchema } from '../gen/control_pb';
import { audioPayload, parseAudioHeader } from './audio_header';
import { decodeControl } from './control';
import { framePayload, MessageType, messageType, parseFrameHeader } from './frame_header';
import { WireError } from './wire_error';

interface GoldenEntry {
  file: string;
  frame?: Record<string, unknown>;
  control?: Record<string, unknown>;
  audio?: Record<string, unknown>;
  refused?: string;
}

const folder = fileURLToPath(new URL('../../../tests/golden/', import.meta.url));
const entries = JSON.parse(readFileSync(`${folder}wire.json`, 'utf8')) as GoldenEntry[];

function read(entry: GoldenEntry): Uint8Array {
  return new Uint8Array(readFileSync(folder + entry.file));
}

function viewOf(bytes: Uint8Array): DataView {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}

/** The fields of the frame, named as in wire.json. */
function meaningOfFrame(bytes: Uint8Array): Record<string, unknown> {
  const h = parseFrameHeader(viewOf(bytes));
  expect(framePayload(bytes, h).length).toBe(h.payloadLength);
  return {
    base_seq: h.baseSeq,
    capture_ns: h.capture_ns.toString(),
    clock_error_us: h.clockError_us,
    codec: h.codec,
    header_length: h.headerLength,
    key: h.key,
    last: h.last,
    layer: h.layer,
    payload_length: h.payloadLength,
    sensor: h.sensor,
    seq: h.seq,
    set_id: h.setId.toString(),
    small: h.small,
  };
}

/** The fields of the audio packet, named as in wire.json. */
function meaningOfAudio(bytes: Uint8Array): Record<string, unknown> {
  const h = parseAudioHeader(viewOf(bytes));
  expect(audioPayload(bytes, h).length).toBe(h.payloadLength);
  return {
    capture_ns: h.capture_ns.toString(),
    codec: h.codec,
    ends: h.ends,
    header_length: h.headerLength,
    payload_length: h.payloadLength,
    seq: h.seq,
    speaker: h.speaker,
  };
}

function accept(bytes: Uint8Array): void {
  const type = messageType(viewOf(bytes));
  if (type === MessageType.Frame) parseFrameHeader(viewOf(bytes));
  else if (type === MessageType.Audio) parseAudioHeader(viewOf(bytes));
  else decodeControl(bytes);
}

describe('golden messages', () => {
  test('there are frames, audio packets, control messages and refusals', () => {
    for (const kind of ['frame', 'audio', 'control', 'refused'] as const) {
      expect(entries.some((entry) => entry[kind] !== undefined)).toBe(true);
    }
  });

  for (const entry of entries) {
    const bytes = read(entry);
    if (entry.frame) {
      test(`${entry.file} reads as the header of the index`, () => {
        expect(meaningOfFrame(bytes)).toEqual(entry.frame);
      });
    } else if (entry.audio) {
      test(`${entry.file} reads as the audio packet of the index`, () => {
        expect(meaningOfAudio(bytes)).toEqual(entry.audio);
      });
    } else if (entry.control) {
      test(`${entry.file} reads as the message of the index`, () => {
        expect(toJson(ControlSchema, decodeControl(bytes))).toEqual(entry.control);
      });
    } else {
      test(`${entry.file} is refused (${entry.refused})`, () => {
        expect(() => accept(bytes)).toThrow(WireError);
      });
    }
  }
});
