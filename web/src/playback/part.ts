// SPDX-License-Identifier: Apache-2.0
// A part of a recording as a hub serves it: docs/spec/playback.md. Its bytes are untrusted. Throws WireError.
import { malformed, unsupported } from '../wire/wire_error';

const magic = 0x54504352; // "RCPT"
const version = 1;
const headerBytes = 32;
const recordHeaderBytes = 16;
const noPart = 0xffffffff;

export interface PartRecord {
  isPast: boolean; // from the time before the moment
  time_s: number; // since the start of the recording
  message: Uint8Array; // of docs/spec/wire.md
}

export interface Part {
  from_s: number;
  until_s: number;
  next: number | undefined; // undefined: the recording ends here
  isDamaged: boolean;
  records: PartRecord[];
}

function seconds(view: DataView, at: number): number {
  return Number(view.getBigUint64(at, true)) / 1e6;
}

export function readPart(bytes: ArrayBuffer): Part {
  const view = new DataView(bytes);
  if (view.byteLength < headerBytes || view.getUint32(0, true) !== magic) throw malformed('this is no part of a recording');
  if (view.getUint16(4, true) !== version) throw unsupported('the hub serves recordings in a later version');
  const headerLength = view.getUint16(6, true);
  if (headerLength < headerBytes || headerLength > view.byteLength) throw malformed('the header of a part has a wrong length');
  const next = view.getUint32(24, true);
  return {
    from_s: seconds(view, 8),
    until_s: seconds(view, 16),
    next: next === noPart ? undefined : next,
    isDamaged: (view.getUint32(28, true) & 1) !== 0,
    records: readRecords(view, headerLength),
  };
}

function readRecords(view: DataView, begin: number): PartRecord[] {
  const records: PartRecord[] = [];
  for (let at = begin; at < view.byteLength; ) {
    const left = view.byteLength - at - recordHeaderBytes;
    const length = left < 0 ? Infinity : view.getUint32(at, true);
    if (length > left) throw malformed('a part of the recording ends too early');
    records.push({
      isPast: (view.getUint32(at + 4, true) & 1) !== 0,
      time_s: seconds(view, at + 8),
      message: new Uint8Array(view.buffer as ArrayBuffer, at + recordHeaderBytes, length),
    });
    at += recordHeaderBytes + length;
  }
  return records;
}
