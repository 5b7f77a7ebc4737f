// SPDX-License-Identifier: Apache-2.0
// Viewers that stop reading: the others receive everything, the hub does not grow, and a viewer that reads again gets
// current frames.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import { startHub } from '../cli/program.mjs';
import { RoomClient, SendingSensor } from './room_client.mjs';
import { assertMissedNothing, longestPause_ms } from './rooms.mjs';

const stalledCount = 5;
const payloadBytes = 150_000;
const fps = 20;
const setsWhileStalled = 100;
/** Of the hub: two complete sets per viewer and one on its way, and the allocator's reserve. */
const mostGrowth_bytes = stalledCount * 3 * 2 * payloadBytes + 8e6;
const longestStop_ms = 2_000;

function residentBytes({ child }) {
  const [, kib] = /VmRSS:\s+(\d+) kB/.exec(readFileSync(`/proc/${child.pid}/status`, 'utf8'));
  return Number(kib) * 1024;
}

const sensorsOf = (frames) => frames.map(({ sensor }) => sensor).sort();

test('viewers_that_stop_reading_lose_only_their_own_frames', async (t) => {
  const hub = await startHub(t);
  const sensors = [];
  for (const name of ['left', 'right']) {
    sensors.push(await SendingSensor.start(t, hub.url, { name, fps, payloadBytes }));
  }
  const ids = sensors.map(({ client }) => client.welcome.sensorId);
  const stalled = [];
  for (let i = 0; i < stalledCount; ++i) stalled.push(await RoomClient.join(t, hub.url, { name: `stalled ${i}` }));
  const witness = await RoomClient.join(t, hub.url, { name: 'witness' });
  await witness.moreSets(10);
  const before = residentBytes(hub.program);

  stalled.forEach(({ socket }) => socket.pause());
  await witness.moreSets(setsWhileStalled);
  const grown = residentBytes(hub.program) - before;
  t.diagnostic(`the hub grew by ${(grown / 1e6).toFixed(1)} MB while ${stalledCount} viewers did not read`);
  assert.ok(grown < mostGrowth_bytes, `${grown} bytes`);
  assertMissedNothing(witness, ids);
  assert.ok(longestPause_ms(witness) < longestStop_ms, `${longestPause_ms(witness)} ms without a set`);

  stalled.forEach(({ socket }) => socket.resume());
  const newest = witness.sets.at(-1).id;
  for (const viewer of stalled) {
    await viewer.until('the present', () => viewer.sets.at(-1).id > newest);
    assert.ok(viewer.sets.length < witness.sets.length, 'it missed some');
    for (const { id, frames } of viewer.sets.slice(1, -1)) {
      const sent = witness.sets.find((set) => set.id === id);
      if (sent) assert.deepEqual(sensorsOf(frames), sensorsOf(sent.frames), `set ${id} is whole`);
    }
  }
});
