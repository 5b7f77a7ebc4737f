// SPDX-License-Identifier: Apache-2.0
// Sensor poses persist across restarts of the hub that found them: they are used again at once, as not verified. The
// sensors' pictures then confirm the pose, or contradict it for a sensor that was moved meanwhile.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { Program, run, scratchFolder } from '../cli/program.mjs';
import { RoomClient } from './room_client.mjs';

const aligned = 2; // PLACEMENT_ALIGNED
const limitMs = 300_000; // of hub and sensors
const placedWithin_ms = 90_000;
const exact_m = 0.03;

/** Records three sensors without known poses. */
async function recordRoom(folder) {
  const rig = join(folder, 'rig');
  const brief = ['--sensors', '3', '--seconds', '3', '--fps', '15', '--half-color', '--views', '0', '--drops', '0'];
  const { code, stderr } = await run('simulate', rig, '--scene', 'lab', ...brief, { limitMs });
  assert.equal(code, 0, stderr);
  const file = join(rig, 'rig.json');
  const description = JSON.parse(readFileSync(file, 'utf8'));
  const truth = new Map(description.sensors.map((sensor) => [sensor.id, sensor.world_from_depth]));
  for (const sensor of description.sensors) sensor.world_from_depth = null;
  writeFileSync(file, JSON.stringify(description));
  return { rig, truth };
}

function startHub(t, data, port = 0) {
  const hub = new Program(['hub', '--listen', `127.0.0.1:${port}`, '--data', data], { limitMs });
  t.after(() => hub.stop('SIGKILL'));
  return hub;
}

/** A sensor with this name at the recorded pose of sensor `seen`. */
function startSensor(t, url, rig, seen, name) {
  const sensor = new Program(['sensor', '--source', `rig:${rig}#${seen}`, '--name', name, '--hub', url, '--wait'], { limitMs });
  t.after(() => sensor.stop('SIGKILL'));
  return sensor;
}

/** The second sensor's position in the frame of the first. */
function placeFrom(first, second) {
  const apart = [3, 7, 11].map((i) => second[i] - first[i]);
  return [0, 1, 2].map((column) => [0, 1, 2].reduce((sum, row) => sum + first[4 * row + column] * apart[row], 0));
}

function assertStandsAs(witness, name, seen, truth) {
  const is = placeFrom(witness.sensor('s0').worldFromDepth, witness.sensor(name).worldFromDepth);
  const should = placeFrom(truth.get('s0'), truth.get(seen));
  const off_m = Math.hypot(...is.map((metres, i) => metres - should[i]));
  assert.ok(off_m < exact_m, `${name} is ${off_m} m away from where it stands`);
}

const areVerified = (witness) => ['s0', 's1'].every((name) => {
  const sensor = witness.sensor(name);
  return sensor?.online && sensor.placement === aligned && !sensor.unverified;
});

test('poses_of_before_a_restart_are_shown_at_once_then_confirmed_or_found_anew', { timeout: limitMs }, async (t) => {
  const folder = scratchFolder(t);
  const { rig, truth } = await recordRoom(folder);
  const hub = startHub(t, join(folder, 'data'));
  const port = await hub.port();
  const url = `ws://127.0.0.1:${port}`;
  startSensor(t, url, rig, 's0', 's0');
  const other = startSensor(t, url, rig, 's1', 's1');
  const before = await RoomClient.join(t, url, { name: 'before' });
  await before.until('both placed', () => areVerified(before), placedWithin_ms);
  assertStandsAs(before, 's1', 's1', truth);
  const [first, second] = ['s0', 's1'].map((name) => before.sensor(name).worldFromDepth);

  await hub.stop(); // orderly; the newest results may not be on disk yet
  await other.stop('SIGKILL');
  startSensor(t, url, rig, 's2', 's1'); // moved to the pose of s2
  const next = startHub(t, join(folder, 'data'), port);
  await next.port();
  const after = await RoomClient.join(t, url, { name: 'after' });
  await after.until('the first one is there', () => after.sensor('s0')?.online);
  const shown = after.rosters.map((roster) => roster.sensors.find(({ name, online }) => name === 's0' && online)).find(Boolean);
  assert.deepEqual(shown.worldFromDepth, first, 'it stands where it stood');
  assert.ok(shown.unverified, 'as far as anybody knows');
  await after.until('one confirmed, one found anew', () => areVerified(after), placedWithin_ms);
  assertStandsAs(after, 's1', 's2', truth);
  const ofOther = after.rosters.flatMap((roster) => roster.sensors.filter(({ name, online }) => name === 's1' && online));
  const whereItStood = ofOther.filter(({ worldFromDepth }) => String(worldFromDepth) === String(second));
  assert.ok(whereItStood.length > 0, 'it was shown where it stood');
  assert.ok(whereItStood.every(({ unverified }) => unverified), 'which nobody could confirm');
});
