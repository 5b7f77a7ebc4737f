// SPDX-License-Identifier: Apache-2.0
// Checks names of rooms, sensors and viewers: docs/spec/wire.md §4. (The Protobuf reader checks that a name is UTF-8.)
import { maxNameBytes } from './limits';
import { malformed, tooLarge } from './wire_error';

// C0, DEL and C1.
const controlCharacter = /[\u0000-\u001f\u007f-\u009f]/;

export function checkText(text: string, maxBytes: number, what: string): void {
  if (new TextEncoder().encode(text).length > maxBytes) throw tooLarge(`${what} is longer than ${maxBytes} bytes`);
  if (controlCharacter.test(text)) throw malformed(`${what} has control characters`);
}

export function checkName(name: string, what: string): void {
  checkText(name, maxNameBytes, `the ${what}'s name`);
}

/** The longest prefix of the user's input that is legal and has at most `maxBytes`. */
export function asText(typed: string, maxBytes: number): string {
  let text = '';
  let bytes = 0;
  for (const character of typed.trim()) {
    bytes += new TextEncoder().encode(character).length;
    if (bytes > maxBytes) break;
    if (!controlCharacter.test(character)) text += character;
  }
  return text;
}

/** The longest prefix of the user's input that is a legal name. */
export function asName(typed: string): string {
  return asText(typed, maxNameBytes);
}
