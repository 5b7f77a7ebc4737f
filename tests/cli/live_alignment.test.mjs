// SPDX-License-Identifier: Apache-2.0
// A running room of real sensors that nobody calibrated: three Kinects of one nominal lens, whose depth differs by 4 %.
// The recording is played as if the cameras were live. Needs the recording `kinects3` ($ROOMCAST_DATA).
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { test } from 'node:test';

import { Program, scratchFolder } from './program.mjs';

const sourceDir = resolve(fileURLToPath(import.meta.url), '../../..');
const rig = join(process.env.ROOMCAST_DATA ?? join(sourceDir, '../shared/data'), 'kinects3');
const limitMs = 230_000;
const options = { timeout: limitMs, skip: existsSync(rig) ? false : `there is no ${rig}` };

test('a_running_room_of_real_kinects_is_placed_and_corrects_their_depth', options, async (t) => {
  const start = (...args) => {
    const program = new Program([...args, '--verbose'], { limitMs });
    t.after(() => program.stop('SIGKILL'));
    return program;
  };
  const hub = start('hub', '--listen', '127.0.0.1:0', '--data', scratchFolder(t));
  const url = `ws://127.0.0.1:${await hub.port()}`;
  const names = ['s0', 's1', 's2'];
  const sensors = names.map((name) => start('sensor', '--source', `rig:${rig}#${name}`, '--hub', url));
  for (const name of names) await hub.prints(new RegExp(`sensor "${name}" is placed`));
  // Their mean is 1, because nothing tells the scale of all. An independent calibration says that the readings of s1 and s2
  // are to be multiplied by 1.045 and 1.042 (real) beside those of s0.
  const factor = /depth is multiplied by (\d\.\d+)/;
  const told = await Promise.all(sensors.map((sensor) => sensor.prints(factor)));
  const [s0, s1, s2] = told.map(([, text]) => Number(text));
  for (const ratio of [s1 / s0, s2 / s0]) assert.ok(ratio > 1.01 && ratio < 1.06, `${s0} ${s1} ${s2}`);
});
