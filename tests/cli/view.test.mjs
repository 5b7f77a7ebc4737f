// SPDX-License-Identifier: Apache-2.0
// roomcast view in a room with nothing to see: it says so, and no picture of an empty room is left behind.
import { deepEqual } from 'node:assert/strict';
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { RoomClient } from '../network/room_client.mjs';
import { startSensor } from '../network/rooms.mjs';
import { writeSmallRig } from '../network/small_rig.mjs';
import { Program, assertFailed, run, scratchFolder, startHub } from './program.mjs';

function viewInto(folder, hub) {
  return ['view', '--hub', hub.url, '--headless', '--size', '64,48', '--png', join(folder, 'room.png')];
}

test('room_without_sensors_is_not_drawn', async (t) => {
  const hub = await startHub(t);
  const folder = scratchFolder(t);
  assertFailed(await run(...viewInto(folder, hub)), 1, /no sensor has joined this room/);
  deepEqual(readdirSync(folder), []);
});

test('room_whose_sensors_have_left_is_not_drawn', async (t) => {
  const hub = await startHub(t);
  const sensor = await startSensor(t, hub.url, writeSmallRig(scratchFolder(t)), 0);
  const folder = scratchFolder(t);
  const viewer = new Program([...viewInto(folder, hub), '--seconds', '3']);
  t.after(() => viewer.stop('SIGKILL'));
  const witness = await RoomClient.join(t, hub.url);
  await witness.until('both viewers', () => witness.rosters.at(-1)?.viewers === 2);
  await witness.moreSets(5);
  await sensor.stop();
  const code = await viewer.ended;
  assertFailed({ code, stderr: viewer.stderr }, 1, /all sensors have left this room/);
  deepEqual(readdirSync(folder), []);
});
