// SPDX-License-Identifier: Apache-2.0
// A sensor that supplied its pose is pushed: it is marked within seconds and re-registered relative to the others,
// whose poses stay.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';

import { Program, scratchFolder } from '../cli/program.mjs';
import { RoomClient } from './room_client.mjs';

const aligned = 2; // PLACEMENT_ALIGNED
const sensorCount = 3;
const pushed = 's2';
const pushAfter_s = 25; // the sensor compares with its first 30 frames
const push_m = 0.08;
const markedWithin_ms = 20_000; // 2 s, and a sensor's start on a busy machine; PoseChangeDetector's tests are exact
const alignWithin_ms = 90_000;
const exact_m = 0.03;
const limitMs = 230_000; // of hub and sensors

async function startHub(t) {
  const data = join(scratchFolder(t), 'data');
  const hub = new Program(['hub', '--listen', '127.0.0.1:0', '--data', data], { limitMs });
  t.after(() => hub.stop('SIGKILL'));
  return `ws://127.0.0.1:${await hub.port()}`;
}

function startSensor(t, url, n) {
  const push = `s${n}` === pushed ? `,bump_at=${pushAfter_s},bump_cm=${100 * push_m},bump_deg=2` : '';
  const source = `sim:livingroom${push}#${n}`;
  const sensor = new Program(['sensor', '--source', source, '--hub', url, '--fps', '5', '--wait'], { limitMs });
  t.after(() => sensor.stop('SIGKILL'));
}

const placeOf = (entry) => [3, 7, 11].map((i) => entry.worldFromDepth[i]);
const distance = (a, b) => Math.hypot(...placeOf(a).map((metres, i) => metres - placeOf(b)[i]));

test('a_pushed_sensor_is_marked_and_placed_anew_and_the_rest_stays', { timeout: 240_000 }, async (t) => {
  const url = await startHub(t);
  const started_ms = performance.now();
  for (let n = 0; n < sensorCount; n++) startSensor(t, url, n);
  const viewer = await RoomClient.join(t, url, { name: 'witness' });
  const sensors = () => viewer.rosters.at(-1)?.sensors ?? [];
  await viewer.until('all sensors', () => sensors().length === sensorCount);
  const before = new Map(sensors().map((entry) => [entry.name, entry]));

  await viewer.until('marked as moved', () => viewer.sensor(pushed).moved, alignWithin_ms);
  const marked_ms = performance.now() - started_ms - 1000 * pushAfter_s;
  t.diagnostic(`marked ${Math.round(marked_ms)} ms after the push, starting up included`);
  assert.ok(marked_ms < markedWithin_ms, `${marked_ms} ms`);

  const placedAnew = () => viewer.sensor(pushed).placement === aligned && !viewer.sensor(pushed).moved;
  await viewer.until('placed anew', placedAnew, alignWithin_ms);
  const moved_m = distance(viewer.sensor(pushed), before.get(pushed));
  assert.ok(Math.abs(moved_m - push_m) < exact_m, `${pushed} was pushed by ${push_m} m, placed ${moved_m} m away`);
  for (const entry of sensors()) {
    if (entry.name !== pushed) assert.deepEqual(placeOf(entry), placeOf(before.get(entry.name)), `${entry.name} stays`);
  }
});
