// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import { frameHeaderBytes, framePayload, MessageType, messageType, parseFrameHeader } from './frame_header';
import { maxFrameBytes } from './limits';
import { WireError, type WireFault } from './wire_error';

/** A legal key frame of three payload bytes; `edit` then breaks it. */
function frame(edit: (view: DataView) => void = () => {}, length = frameHeaderBytes + 3): DataView {
  const view = new DataView(new ArrayBuffer(length));
  view.setUint16(0, 0x4352, true);
  view.setUint8(2, 1);
  view.setUint8(3, MessageType.Frame);
  view.setUint16(4, 48, true);
  view.setUint16(6, 1, true);
  view.setUint32(12, 7, true);
  view.setUint32(36, 7, true);
  view.setUint32(40, length - 48, true);
  edit(view);
  return view;
}

function faultOf(run: () => unknown): WireFault | 'none' {
  try {
    run();
    return 'none';
  } catch (error) {
    if (error instanceof WireError) return error.fault;
    throw error;
  }
}

describe('a message', () => {
  test('of fewer than four bytes is refused', () => {
    for (const length of [0, 1, 3]) {
      expect(faultOf(() => messageType(new DataView(new ArrayBuffer(length))))).toBe('malformed');
    }
  });
  test('with another magic is refused', () => {
    expect(faultOf(() => messageType(frame((v) => v.setUint8(0, 0x58))))).toBe('malformed');
  });
  test('of another version is refused as unsupported and both versions are named', () => {
    const other = frame((v) => v.setUint8(2, 2));
    expect(faultOf(() => messageType(other))).toBe('unsupported');
    expect(() => messageType(other)).toThrow(/version 2 .* only version 1/);
  });
  test('of an unknown type is refused as unsupported', () => {
    for (const type of [0, 4, 255]) {
      expect(faultOf(() => messageType(frame((v) => v.setUint8(3, type))))).toBe('unsupported');
    }
  });
});

describe('a frame header', () => {
  test('is read', () => {
    const header = parseFrameHeader(frame());
    expect(header).toMatchObject({ key: true, last: false, seq: 7, baseSeq: 7, payloadLength: 3, headerLength: 48 });
  });
  test('that is cut is refused at every length', () => {
    const whole = frame();
    for (let length = 0; length < whole.byteLength; length++) {
      expect(faultOf(() => parseFrameHeader(new DataView(whole.buffer, 0, length)))).toBe('malformed');
    }
  });
  test('of a control message is refused', () => {
    expect(faultOf(() => parseFrameHeader(frame((v) => v.setUint8(3, MessageType.Control))))).toBe('malformed');
  });
  test('shorter than 48 bytes is refused', () => {
    expect(faultOf(() => parseFrameHeader(frame((v) => v.setUint16(4, 47, true))))).toBe('malformed');
  });
  test('with a too small or too large payload length is refused', () => {
    for (const length of [0, 2, 4, 0xffffffff]) {
      expect(faultOf(() => parseFrameHeader(frame((v) => v.setUint32(40, length, true))))).toBe('malformed');
    }
  });
  test('of a layer above 7 is refused, 7 is not', () => {
    expect(faultOf(() => parseFrameHeader(frame((v) => v.setUint8(10, 7))))).toBe('none');
    expect(faultOf(() => parseFrameHeader(frame((v) => v.setUint8(10, 8))))).toBe('malformed');
  });
  test('of a key frame that needs another frame is refused', () => {
    expect(faultOf(() => parseFrameHeader(frame((v) => v.setUint32(36, 6, true))))).toBe('malformed');
  });
  test('of a frame of 2 MiB is read, one byte more is refused', () => {
    expect(faultOf(() => parseFrameHeader(frame(undefined, maxFrameBytes)))).toBe('none');
    expect(faultOf(() => parseFrameHeader(frame(undefined, maxFrameBytes + 1)))).toBe('too-large');
  });
  test('of a later version may be longer, and its unknown part is skipped', () => {
    const longer = frame((v) => {
      v.setUint16(4, 50, true);
      v.setUint32(40, 1, true);
      v.setUint8(50, 99);
    });
    const header = parseFrameHeader(longer);
    expect([...framePayload(new Uint8Array(longer.buffer), header)]).toEqual([99]);
  });
  test('with unknown flags is read', () => {
    expect(parseFrameHeader(frame((v) => v.setUint16(6, 0xffff, true)))).toMatchObject({ key: true, last: true });
  });
});
