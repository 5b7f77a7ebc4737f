// SPDX-License-Identifier: Apache-2.0
// Viewers of one room at several hubs see each other, whether the hubs form a chain or a star, until they leave or
// their hub stops.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { startHub } from '../cli/program.mjs';
import { writeViewerPose } from './messages.mjs';
import { natsIsMissing, startNode } from './nats.mjs';
import { RoomClient } from './room_client.mjs';

const alone = (t, ...options) => startHub(t, '--no-align', ...options);

/** Three hubs in a chain, beginning with the one that owns the room. */
async function inARow(t) {
  const origin = await alone(t);
  const middle = await alone(t, '--upstream', origin.url);
  return [origin, middle, await alone(t, '--upstream', middle.url)];
}

/** Two hubs behind the same one, which has no viewers of its own. */
async function behindOne(t) {
  const origin = await alone(t);
  return [await alone(t, '--upstream', origin.url), await alone(t, '--upstream', origin.url)];
}

async function sideBySide(t) {
  const node = await startNode(t);
  return Promise.all([0, 1, 2].map(() => alone(t, '--nats', node.url)));
}

/**
 * A viewer at each hub: "p0" at the first, at [0, 1.5, 0], "p1" at [1, 1.5, 0] and so on. Waits until each sees all
 * others.
 */
async function oneAtEach(t, hubs) {
  const people = await Promise.all(hubs.map((hub, i) => RoomClient.join(t, hub.url, { name: `p${i}` })));
  people.forEach((person, i) => person.send(writeViewerPose([i, 1.5, 0])));
  for (const [i, person] of people.entries()) {
    for (const other of people.keys()) {
      if (other === i) continue;
      const at = await person.until(`p${other} at p${i}'s hub`, () => person.placeOf(`p${other}`));
      assert.deepEqual(at, [other, 1.5, 0]);
    }
    const names = person.rosters.at(-1).people.map(({ name }) => name).filter((name) => name !== 'hub').sort();
    assert.deepEqual(names, people.map((_, n) => `p${n}`), 'each of them once');
  }
  return people;
}

for (const [what, start, skip] of [
  ['in_a_row', inARow, false],
  ['behind_the_same_one', behindOne, false],
  ['side_by_side', sideBySide, natsIsMissing],
]) {
  test(`people_at_hubs_${what}_see_each_other_until_they_leave`, { skip }, async (t) => {
    const hubs = await start(t);
    const people = await oneAtEach(t, hubs);
    people[1].send(writeViewerPose([0, 1.5, -7]));
    await people[0].until('p1 has moved', () => people[0].placeOf('p1')[2] === -7);
    const late = await RoomClient.join(t, hubs[0].url, { name: 'late' });
    await late.until('who stands still', () => late.placeOf('p1')?.[2] === -7);
    await people[1].until('who came late', () => people[1].person('late'));
    people[0].socket.terminate();
    await Promise.all(people.slice(1).map((person) => person.until('p0 has left', () => !person.person('p0'))));
  });

  test(`people_at_a_hub_${what}_are_gone_when_it_is_killed`, { skip }, async (t) => {
    const hubs = await start(t);
    const people = await oneAtEach(t, hubs);
    hubs.at(-1).program.child.kill('SIGKILL');
    const gone = `p${hubs.length - 1}`;
    await people[0].until('they are gone', () => !people[0].person(gone));
    assert.equal(people[0].person('p0')?.hubsAway, 0);
  });
}
