// SPDX-License-Identifier: Apache-2.0
// Finds the VP9 frame in a frame's payload, for pictures that need no depth: docs/spec/codec.md §1. Its bytes are
// untrusted. Pure.

const headerBytes = 8; // of a section
const colorKind = 2;
const vp9 = 1;

/** Undefined where there is no colour, or none that this page knows. */
export function colorIn(payload: Uint8Array): Uint8Array | undefined {
  const view = new DataView(payload.buffer, payload.byteOffset, payload.byteLength);
  for (let at = 0; at + headerBytes <= payload.length; ) {
    const begin = at + headerBytes;
    const length = view.getUint32(at + 4, true);
    if (begin + length > payload.length) return undefined;
    if (payload[at] === colorKind) return payload[at + 1] === vp9 ? payload.subarray(begin, begin + length) : undefined;
    at = begin + length;
  }
  return undefined;
}
