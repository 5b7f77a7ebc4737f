// SPDX-License-Identifier: Apache-2.0
// roomcast align of recordings that are not what they seem: sensors of two rooms in one rig, one or two frames, clocks
// that are minutes off. It may refuse with a reason; it must not place a sensor wrongly. Simulated rooms.
import assert from 'node:assert/strict';
import { cpSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { run, scratchFolder } from './program.mjs';

const maxErrorM = 0.1;
const cleanups = [];
const rooms = {};

before(async () => {
  const folder = scratchFolder({ after: (f) => cleanups.push(f) });
  for (const scene of ['livingroom', 'office']) {
    rooms[scene] = join(folder, scene);
    const options = ['--scene', scene, '--sensors', '2', '--seconds', '0.5', '--fps', '20', '--views', '0'];
    const { code, stderr } = await run('simulate', rooms[scene], ...options);
    assert.equal(code, 0, stderr);
  }
});
after(() => cleanups.forEach((cleanup) => cleanup()));

const rigOf = (folder) => JSON.parse(readFileSync(join(folder, 'rig.json'), 'utf8'));
const writeRig = (folder, rig) => writeFileSync(join(folder, 'rig.json'), JSON.stringify(rig));

function copyOf(t, room) {
  const copy = join(scratchFolder(t), 'rig');
  cpSync(room, copy, { recursive: true });
  return copy;
}

async function align(rig) {
  const { code, stdout, stderr } = await run('align', rig, '--json');
  assert.equal(code, 0, stderr);
  return JSON.parse(stdout);
}

/** Row-major 4x4: the inverse of one rigid transform times another. */
function relative(one, other) {
  const at = (m, row, column) => m[4 * row + column];
  const result = [];
  for (let row = 0; row < 3; ++row) {
    for (let column = 0; column < 4; ++column) {
      let sum = 0;
      for (let k = 0; k < 3; ++k) {
        const entry = column < 3 ? at(other, k, column) : at(other, k, 3) - at(one, k, 3);
        sum += at(one, k, row) * entry;
      }
      result.push(sum);
    }
  }
  return [...result, 0, 0, 0, 1];
}

/** Distance from the true place of a point 2.5 m ahead of s1, as s0 has it. */
function errorM(found, truth) {
  const ahead = (m) => [0, 1, 2].map((row) => 2.5 * m[4 * row + 2] + m[4 * row + 3]);
  const [a, b] = [ahead(relative(...found)), ahead(relative(...truth))];
  return Math.hypot(...a.map((value, i) => value - b[i]));
}

function assertRightOrRefused(report, rig) {
  const truth = rigOf(rig).sensors.map((sensor) => sensor.world_from_depth);
  const [s0, s1] = report.sensors;
  for (const sensor of report.sensors) assert.match(sensor.reason, /\w+/);
  if (!s0.placed || !s1.placed) return false;
  const error = errorM([s0.world_from_depth, s1.world_from_depth], truth);
  assert.ok(error < maxErrorM, `${(1000 * error).toFixed(0)} mm off`);
  return true;
}

test('sensors_of_two_rooms_are_not_placed_together', async (t) => {
  const rig = copyOf(t, rooms.livingroom);
  cpSync(join(rooms.office, 's1'), join(rig, 'stranger'), { recursive: true });
  const file = rigOf(rig);
  file.sensors[1] = { ...rigOf(rooms.office).sensors[1], id: 'stranger', path: 'stranger' };
  writeRig(rig, file);
  const report = await align(rig);
  assert.ok(!report.sensors.every((sensor) => sensor.placed), JSON.stringify(report.pairs));
  for (const pair of report.pairs) {
    assert.equal(pair.accepted, false);
    assert.match(pair.reason, /\w+ \w+/);
  }
});

test('one_frame_or_two_are_aligned_or_refused', async (t) => {
  for (const count of [1, 2]) {
    const rig = copyOf(t, rooms.livingroom);
    for (const sensor of ['s0', 's1']) {
      for (const list of ['depth.txt', 'rgb.txt']) {
        const lines = readFileSync(join(rig, sensor, list), 'utf8').split('\n');
        const kept = lines.filter((line) => line.startsWith('#') || line === '');
        const frames = lines.filter((line) => line !== '' && !line.startsWith('#')).slice(0, count);
        writeFileSync(join(rig, sensor, list), [...kept.filter(Boolean), ...frames, ''].join('\n'));
      }
    }
    assert.ok(assertRightOrRefused(await align(rig), rig), `${count} frames of a furnished room are enough`);
  }
});

test('a_clock_that_is_minutes_off_places_nothing_wrongly', async (t) => {
  const rig = copyOf(t, rooms.livingroom);
  for (const list of ['depth.txt', 'rgb.txt']) {
    const file = join(rig, 's1', list);
    const later = (time) => (Number(time) + 300).toFixed(6);
    const shifted = readFileSync(file, 'utf8').replaceAll(/(^|\s)(\d+\.\d+)(?=\s)/g, (_, gap, time) => gap + later(time));
    writeFileSync(file, shifted);
  }
  assertRightOrRefused(await align(rig), rig);
});
