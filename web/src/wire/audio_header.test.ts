// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { audioCodecOpus, audioHeaderBytes, audioPayload, encodeAudio, parseAudioHeader } from './audio_header';
import { maxAudioBytes, maxAudioPayloadBytes } from './limits';
import { WireError } from './wire_error';

const packet = { ends: true, seq: 0xfffffffe, capture_ns: -5n };
const payload = Uint8Array.of(0x78, 1, 2, 3);

function viewOf(bytes: Uint8Array): DataView {
  return new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
}

describe('an audio packet', () => {
  test('reads as it was written', () => {
    const message = encodeAudio(packet, payload);
    const header = parseAudioHeader(viewOf(message));
    expect(header).toEqual({ ...packet, speaker: 0, codec: audioCodecOpus, payloadLength: 4, headerLength: audioHeaderBytes });
    expect(audioPayload(message, header)).toEqual(payload);
  });
  test('that is cut is refused at every length', () => {
    const message = encodeAudio(packet, payload);
    for (let length = 0; length < message.length; length++) {
      expect(() => parseAudioHeader(viewOf(message.subarray(0, length)))).toThrow(WireError);
    }
  });
  test('with a longer header of a later version is read', () => {
    const message = new Uint8Array(audioHeaderBytes + 8 + 1);
    message.set(encodeAudio(packet, Uint8Array.of(1)).subarray(0, audioHeaderBytes));
    message[4] = audioHeaderBytes + 8;
    message[message.length - 1] = 0x78;
    expect(audioPayload(message, parseAudioHeader(viewOf(message)))).toEqual(Uint8Array.of(0x78));
  });
  test('with a header that is too short is refused', () => {
    const message = encodeAudio(packet, payload);
    message[4] = audioHeaderBytes - 1;
    expect(() => parseAudioHeader(viewOf(message))).toThrow(WireError);
  });
  test('that is too large is refused', () => {
    const message = new Uint8Array(maxAudioBytes + 1);
    message.set(encodeAudio(packet, payload));
    expect(() => parseAudioHeader(viewOf(message))).toThrow(/at most 1400 bytes/);
  });
  test('without payload, or with too much, is not written', () => {
    expect(() => encodeAudio(packet, new Uint8Array())).toThrow(WireError);
    expect(() => encodeAudio(packet, new Uint8Array(maxAudioPayloadBytes + 1))).toThrow(WireError);
    expect(encodeAudio(packet, new Uint8Array(maxAudioPayloadBytes)).length).toBe(audioHeaderBytes + maxAudioPayloadBytes);
  });
});
