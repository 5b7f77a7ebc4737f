// SPDX-License-Identifier: Apache-2.0
// Checks names of rooms, sensors and viewers: docs/spec/wire.md §4. (The Protobuf reader checks that a name is UTF-8.)
import { maxNameBytes } from './limits';
import { malformed, tooLarge } from './wire_error';

// C0, DEL and C1.
const controlCharacter = /[\u0000-\u001f\u007f-\u009f]/;

export function checkName(name: string, what: string): void {
  if (new TextEncoder().encode(name).length > maxNameBytes) {
    throw tooLarge(`the ${what}'s name is longer than ${maxNameBytes} bytes`);
  }
  if (controlCharacter.test(name)) throw malformed(`the ${what}'s name has control characters`);
}

/** The longest prefix of the user's input that is a legal name. */
export function asName(typed: string): string {
  let name = '';
  let bytes = 0;
  for (const character of typed.trim()) {
    bytes += new TextEncoder().encode(character).length;
    if (bytes > maxNameBytes) break;
    if (!controlCharacter.test(character)) name += character;
  }
  return name;
}
