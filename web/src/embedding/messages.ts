// SPDX-License-Identifier: Apache-2.0
// What the page says to a page of another site that shows it in a frame, and is told by it (docs/guides/web.md).
// The frame begins: it posts `readyMessage` to its parent, and the parent answers with a MessagePort, over which all
// else goes. None of these messages holds a token.

export const readyMessage = 'roomcast-view ready';
export const portMessage = 'roomcast-view port';

export interface EmbedState {
  phase: 'connecting' | 'joined' | 'waiting' | 'broken';
  sentence: string; // what is wrong, or empty
  needsToken: boolean;
  room: string;
  people: number;
  sensors: number; // online
  places: string[]; // that somebody has named for everybody
  muted: boolean; // nobody is heard here
}

export type ToRoom =
  | { kind: 'mute'; muted: boolean }
  | { kind: 'place'; name: string }
  | { kind: 'look'; at: [number, number, number]; look: [number, number, number] }
  | { kind: 'mode'; mode: string };

export type FromRoom = { kind: 'state'; state: EmbedState };

type Fields = Record<string, unknown>;

/** Undefined for anything else. */
export function toRoom(data: unknown): ToRoom | undefined {
  const { kind, muted, name, at, look, mode } = (typeof data === 'object' && data !== null ? data : {}) as Fields;
  if (kind === 'mute' && typeof muted === 'boolean') return { kind, muted };
  if (kind === 'place' && typeof name === 'string') return { kind, name };
  if (kind === 'mode' && typeof mode === 'string') return { kind, mode };
  if (kind === 'look' && isPoint(at) && isPoint(look)) return { kind, at, look };
  return undefined;
}

function isPoint(value: unknown): value is [number, number, number] {
  return Array.isArray(value) && value.length === 3 && value.every((part) => Number.isFinite(part));
}
