// SPDX-License-Identifier: Apache-2.0
// Reads the hub's answer to a request for the room's model: docs/spec/model.md. Pure.

export interface ModelPiece {
  key: string; // names its cube
  draco: Uint8Array; // empty: there is no piece there any more
}

export interface ModelMessage {
  isWhole: boolean; // pieces received before are forgotten
  version: bigint;
  pieces: ModelPiece[];
}

const headerBytes = 20;
const pieceHeaderBytes = 16;

function refuse(): never {
  throw new Error('this is not the model of a room');
}

/** Throws an Error for anything else. */
export function readModelMessage(bytes: ArrayBuffer): ModelMessage {
  if (bytes.byteLength < headerBytes) refuse();
  const view = new DataView(bytes);
  const magic = String.fromCharCode(view.getUint8(0), view.getUint8(1), view.getUint8(2));
  if (magic !== 'RCM') refuse();
  if (view.getUint8(3) !== 1) throw new Error('this model is of another version of roomcast');
  const count = view.getUint32(16, true);
  const pieces: ModelPiece[] = [];
  let at = headerBytes;
  for (let i = 0; i < count; ++i) {
    if (bytes.byteLength - at < pieceHeaderBytes) refuse();
    const [x, y, z] = [0, 4, 8].map((offset) => view.getInt32(at + offset, true));
    const length = view.getUint32(at + 12, true);
    at += pieceHeaderBytes;
    if (bytes.byteLength - at < length) refuse();
    pieces.push({ key: `${x},${y},${z}`, draco: new Uint8Array(bytes, at, length) });
    at += length;
  }
  if (at !== bytes.byteLength) refuse();
  return { isWhole: (view.getUint32(4, true) & 1) !== 0, version: view.getBigUint64(8, true), pieces };
}
