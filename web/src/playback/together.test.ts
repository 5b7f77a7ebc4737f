// SPDX-License-Identifier: Apache-2.0
import { describe, expect, test } from 'vitest';
import type { PlaybackCommand, PlaybackState } from '../stream/protocol';
import { Together, type PartyAnswer } from './together';

const playing: PlaybackState = {
  name: 'r', began_at: 0, length_s: 60, position_s: 10, paused: false, speed: 1, loops: false,
  isWaiting: false, isDamaged: false, voices: false, seeks: 1, moment: [],
};
const alone: PartyAnswer = { people: [], change: 0, by: '', own: false, playing: { position_s: 0, paused: false, speed: 1 } };

function party() {
  const said: { wants?: object }[] = [];
  const done: PlaybackCommand[] = [];
  const lines: PlaybackCommand[] = []; // to the others
  const seen: string[][] = [];
  const now = { answer: alone, ms: 100_000, fails: false };
  const together = new Together(
    (body) => {
      said.push(body as { wants?: object });
      return now.fails ? Promise.reject(new Error('away')) : Promise.resolve(now.answer);
    },
    {
      self: () => ({ name: 'Ada', viewer: 7, head: { x: 1, y: 2, z: 3, qx: 0, qy: 0, qz: 0, qw: 1 } }),
      people: (viewers) => seen.push(viewers.map(({ name }) => name)),
      control: (command) => (command.isTogether === undefined ? done : lines).push(command),
    },
    () => now.ms,
  );
  together.show(playing);
  return { together, said, done, lines, seen, now };
}

describe('playing together', () => {
  test('says where one stands, and once what one wants', async () => {
    const { together, said } = party();
    together.wanted({ paused: true });
    together.wanted({ seek_s: 30 });
    await together.visit();
    await together.visit();
    expect(said[0]).toMatchObject({ name: 'Ada', viewer: 7, head: [1, 2, 3, 0, 0, 0, 1], wants: { position_s: 30, paused: true, speed: 1 } });
    expect(said[1]!.wants).toBeUndefined();
  });

  test('says again what the hub has not heard', async () => {
    const { together, said, now } = party();
    now.fails = true;
    together.wanted({ speed: 2 });
    await together.visit();
    now.fails = false;
    await together.visit();
    expect(said[1]!.wants).toEqual({ position_s: 10, paused: false, speed: 2 });
  });

  test('follows what others want, once', async () => {
    const { together, done, now } = party();
    now.answer = { ...alone, change: 3, playing: { position_s: 42, paused: true, speed: 0.5 } };
    await together.visit();
    together.show({ ...playing, position_s: 42, paused: true, speed: 0.5 });
    await together.visit();
    expect(done).toEqual([{ seek_s: 42, paused: true, speed: 0.5 }]);
  });

  test('does not follow itself, nor before it has told what its person wants', async () => {
    const { together, done, now } = party();
    now.answer = { ...alone, change: 1, own: true, playing: { position_s: 42, paused: false, speed: 1 } };
    await together.visit();
    expect(done).toEqual([]);
  });

  test('catches up when it is far behind, and not all the time', async () => {
    const { together, done, now } = party();
    now.answer = { ...alone, change: 1, playing: { position_s: 10.1, paused: false, speed: 1 } };
    await together.visit();
    now.answer = { ...now.answer, playing: { position_s: 20, paused: false, speed: 1 } };
    await together.visit();
    await together.visit();
    expect(done).toEqual([{ seek_s: 20 }]);
    now.ms += 11_000;
    await together.visit();
    expect(done.length).toBe(2);
  });

  test('leaves somebody alone who wants that', async () => {
    const { together, said, done, lines, seen, now } = party();
    now.answer = { ...alone, people: [{ id: 4, name: 'Bob', head: [0, 1, 0, 0, 0, 0, 1] }], change: 2, playing: { position_s: 50, paused: true, speed: 1 } };
    together.setOn(false);
    await together.visit();
    expect(said).toMatchObject([{ leaves: true }]);
    expect(done).toEqual([]);
    expect(seen).toEqual([[]]);
    together.setOn(true);
    await together.visit();
    expect(done).toEqual([{ seek_s: 50, paused: true, speed: 1 }]);
    expect(lines).toEqual([{ isTogether: false }, { isTogether: true }]);
  });

  test('shows the others, and nobody while the hub is away', async () => {
    const { together, seen, now } = party();
    now.answer = { ...alone, people: [{ id: 4, name: 'Bob', head: [0, 1, 0, 0, 0, 0, 1] }] };
    await together.visit();
    expect(together.names).toEqual(['Bob']);
    now.fails = true;
    await together.visit();
    expect(seen).toEqual([['Bob (with you)'], []]);
  });
});
