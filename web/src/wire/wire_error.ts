// SPDX-License-Identifier: Apache-2.0
// The error for bytes from the hub that violate docs/spec/wire.md: a kind for the program, a sentence for the user.

export type WireFault = 'malformed' | 'too-large' | 'unsupported';

export class WireError extends Error {
  constructor(
    readonly fault: WireFault,
    sentence: string,
  ) {
    super(sentence);
    this.name = 'WireError';
  }
}

export function malformed(sentence: string): WireError {
  return new WireError('malformed', sentence);
}

export function tooLarge(sentence: string): WireError {
  return new WireError('too-large', sentence);
}

export function unsupported(sentence: string): WireError {
  return new WireError('unsupported', sentence);
}
