// SPDX-License-Identifier: Apache-2.0
// roomcast nudge where nothing can be moved: it says at once why.
import { test } from 'node:test';

import { startSensor } from '../network/rooms.mjs';
import { writeSmallRig } from '../network/small_rig.mjs';
import { Program, assertFailed, run, scratchFolder, startHub } from './program.mjs';

const move = ['--move', '0.1', '0', '0'];

test('moving_a_sensor_takes_an_admins_token', async (t) => {
  const hub = await startHub(t);
  const sensor = new Program(['sensor', '--source', `tum:${writeSmallRig(scratchFolder(t))}/s0`, '--name', 'unplaced', '--hub', hub.url]);
  t.after(() => sensor.stop('SIGKILL'));
  await sensor.prints(/joined/);
  assertFailed(await run('nudge', 'unplaced', '--hub', hub.url, ...move), 1, /takes an admin's token \(roomcast token --role admin\)/);
});

test('a_sensor_that_has_supplied_its_pose_is_not_moved', async (t) => {
  const data = scratchFolder(t);
  const hub = await startHub(t, '--data', data);
  await startSensor(t, hub.url, writeSmallRig(scratchFolder(t)), 0);
  const { stdout: token } = await run('token', '--data', data, '--role', 'admin', '--ttl', '1h');
  const result = await run('nudge', 's0', '--hub', hub.url, ...move, '--token', token.trim());
  assertFailed(result, 1, /"s0" has supplied its pose.*start the sensor again/);
});
