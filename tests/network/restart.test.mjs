// SPDX-License-Identifier: Apache-2.0
// A hub that is killed and started again with four connected sensors and ten viewers: all of them are real programs and
// come back by themselves within seconds.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { Program, scratchFolder, startHub } from '../cli/program.mjs';
import { RoomClient } from './room_client.mjs';
import { assertMissedNothing, startSensor } from './rooms.mjs';
import { writeSmallRig } from './small_rig.mjs';

const sensorCount = 4;
const viewerCount = 10;
const viewersWatch_s = 15;
const backWithin_ms = 10_000;

function startViewer(t, url, folder, n) {
  const picture = ['--headless', '--size', '64,48', '--png', join(folder, `${n}.png`)];
  const viewer = new Program(['view', '--hub', url, ...picture, '--seconds', String(viewersWatch_s), '--json']);
  t.after(() => viewer.stop('SIGKILL'));
  return viewer;
}

/** A witness in a room with all sensors and viewers present. */
async function witnessOfAll(t, url) {
  const witness = await RoomClient.join(t, url, { name: 'witness' });
  await witness.until('everybody', () => {
    const { sensors, viewers } = witness.rosters.at(-1) ?? { sensors: [], viewers: 0 };
    return sensors.filter(({ online }) => online).length === sensorCount && viewers === viewerCount + 1;
  });
  const ids = witness.rosters.at(-1).sensors.map(({ id }) => id);
  await witness.until('a frame of every sensor', () => ids.every((id) => witness.seqsOf(id).length > 0));
  return witness;
}

const sensorsByName = (witness) =>
  new Map(witness.rosters.at(-1).sensors.map(({ name, id, worldFromDepth }) => [name, { id, worldFromDepth }]));

test('killed_hub_comes_back_and_four_sensors_and_ten_viewers_with_it', { timeout: 60_000 }, async (t) => {
  const folder = scratchFolder(t);
  const rig = writeSmallRig(folder);
  const data = ['--data', join(folder, 'data')];
  const hub = await startHub(t, ...data);
  await Promise.all(Array.from({ length: sensorCount }, (_, n) => startSensor(t, hub.url, rig, n)));
  const viewers = Array.from({ length: viewerCount }, (_, n) => startViewer(t, hub.url, folder, n));
  const before = await witnessOfAll(t, hub.url);
  const places = new Set([...sensorsByName(before).values()].map(({ worldFromDepth }) => String(worldFromDepth)));
  assert.equal(places.size, sensorCount, 'four different poses');

  await hub.program.stop('SIGKILL');
  const killed_ms = performance.now();
  const next = new Program(['hub', '--listen', `127.0.0.1:${hub.port}`, ...data]);
  t.after(() => next.stop('SIGKILL'));
  await next.prints(/http/);
  const after = await witnessOfAll(t, hub.url);
  const back_ms = performance.now() - killed_ms;
  t.diagnostic(`all back ${Math.round(back_ms)} ms after the hub was killed`);
  assert.ok(back_ms < backWithin_ms, `${back_ms} ms`);
  assert.deepEqual(sensorsByName(after), sensorsByName(before), 'every sensor has its id and stands where it stood');

  await after.moreSets(20);
  assertMissedNothing(after, after.rosters.at(-1).sensors.map(({ id }) => id));
  for (const [n, viewer] of viewers.entries()) {
    assert.equal(await viewer.ended, 0, viewer.stderr);
    assert.ok(existsSync(join(folder, `${n}.png`)));
    assert.equal(JSON.parse(viewer.stdout).sensors.length, sensorCount, 'drew all sensors of the new hub');
  }
});
