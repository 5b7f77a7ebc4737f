// SPDX-License-Identifier: Apache-2.0
// Programs that die or freeze at arbitrary moments: the rest of the room loses only what the fault itself removed. A
// witness that shares no code with roomcast records every set and every frame.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';

import { Program, scratchFolder, startHub } from '../cli/program.mjs';
import { RoomClient, SendingSensor } from './room_client.mjs';
import { assertMissedNothing, longestPause_ms, startSensor } from './rooms.mjs';
import { writeSmallRig } from './small_rig.mjs';

/** For a room of 10 frames a second: a frame period, the deadline of a set, and the delay on a busy machine. */
const longestStop_ms = 2_000;

async function roomOfTwo(t) {
  const hub = await startHub(t);
  const rig = writeSmallRig(scratchFolder(t));
  await startSensor(t, hub.url, rig, 0);
  const victim = await startSensor(t, hub.url, rig, 1);
  const witness = await RoomClient.join(t, hub.url);
  await witness.until('both sensors', () => witness.sensor('s0')?.online && witness.sensor('s1')?.online);
  await witness.moreSets(5);
  return { hub, rig, victim, witness, s0: witness.sensor('s0').id, s1: witness.sensor('s1') };
}

test('killed_sensor_costs_the_room_only_its_own_frames', async (t) => {
  const { hub, rig, victim, witness, s0, s1 } = await roomOfTwo(t);
  await victim.stop('SIGKILL');
  await witness.until('it is missed', () => !witness.sensor('s1').online);
  await witness.moreSets(10);
  assertMissedNothing(witness, [s0, s1.id]);
  assert.ok(longestPause_ms(witness) < longestStop_ms, `${longestPause_ms(witness)} ms without a set`);

  const framesBefore = witness.seqsOf(s1.id).length;
  await startSensor(t, hub.url, rig, 1);
  await witness.until('it is back', () => witness.seqsOf(s1.id).length > framesBefore + 3);
  assert.deepEqual(witness.sensor('s1'), s1, 'same id, same pose');
  const back = witness.sets.flatMap(({ frames }) => frames.filter(({ sensor }) => sensor === s1.id))[framesBefore];
  assert.ok(back.key && back.seq === 0, 'it begins with a key frame');
  assertMissedNothing(witness, [s0]);
});

test('killed_viewer_costs_the_room_nothing', async (t) => {
  const { hub, witness, s0, s1 } = await roomOfTwo(t);
  const picture = join(scratchFolder(t), 'room.png');
  const viewer = new Program(['view', '--hub', hub.url, '--headless', '--png', picture, '--seconds', '20']);
  t.after(() => viewer.stop('SIGKILL'));
  await witness.until('the viewer', () => witness.rosters.at(-1).viewers === 2);
  await witness.moreSets(5);
  await viewer.stop('SIGKILL');
  await witness.until('it is gone', () => witness.rosters.at(-1).viewers === 1);
  await witness.moreSets(10);
  assertMissedNothing(witness, [s0, s1.id]);
  assert.ok(longestPause_ms(witness) < longestStop_ms, `${longestPause_ms(witness)} ms without a set`);
});

test('killed_hub_is_replaced_and_its_sensors_join_the_next_one_with_a_key_frame', async (t) => {
  const { hub, witness, s1 } = await roomOfTwo(t);
  await hub.program.stop('SIGKILL');
  await witness.closed;
  const next = new Program(['hub', '--listen', `127.0.0.1:${hub.port}`]);
  t.after(() => next.stop('SIGKILL'));
  await next.prints(/http/);
  const after = await RoomClient.join(t, hub.url);
  await after.until('both sensors', () => ['s0', 's1'].every((name) => after.seqsOf(after.sensor(name)?.id).length > 3));
  for (const name of ['s0', 's1']) {
    const { id } = after.sensor(name);
    const first = after.sets.flatMap(({ frames }) => frames).find(({ sensor }) => sensor === id);
    assert.ok(first.key, `what one sees of ${name} first is a key frame`);
  }
  assert.deepEqual(after.sensor('s1').worldFromDepth, s1.worldFromDepth);
  assertMissedNothing(after, [after.sensor('s0').id, after.sensor('s1').id]);
});

test('a_frozen_sensor_and_a_silent_viewer_delay_no_others_and_are_disconnected', { timeout: 60_000 }, async (t) => {
  const { victim, witness, hub, s0, s1 } = await roomOfTwo(t);
  const silent = await RoomClient.join(t, hub.url, { name: 'silent', options: { autoPong: false } });
  victim.child.kill('SIGSTOP');
  const frozen_ms = performance.now();
  await witness.until('it is missed', () => !witness.sensor('s1').online, 25_000);
  t.diagnostic(`a frozen sensor is called offline after ${Math.round(performance.now() - frozen_ms)} ms`);
  await silent.closed;
  assertMissedNothing(witness, [s0, s1.id]);
  assertMissedNothing(silent, [s0]);
  assert.ok(longestPause_ms(witness) < longestStop_ms, `${longestPause_ms(witness)} ms without a set`);

  victim.child.kill('SIGCONT');
  await witness.until('it is back', () => witness.sensor('s1').online);
  assert.deepEqual(witness.sensor('s1'), s1, 'same id, same pose');
});

test('a_sensor_at_ten_times_its_rate_delays_no_others', async (t) => {
  const hub = await startHub(t);
  const honest = await SendingSensor.start(t, hub.url, { name: 'honest', fps: 10 });
  const witness = await RoomClient.join(t, hub.url);
  await witness.moreSets(5);
  await SendingSensor.start(t, hub.url, { name: 'hasty', fps: 10, rate: 100 });
  await witness.moreSets(30);
  assertMissedNothing(witness, [honest.client.welcome.sensorId]);
  assert.ok(longestPause_ms(witness) < longestStop_ms, `${longestPause_ms(witness)} ms without a set`);
  const [first, last] = [witness.sets.at(-21), witness.sets.at(-1)];
  const setsPerSecond = 20_000 / (last.at_ms - first.at_ms);
  assert.ok(setsPerSecond < 15, `${setsPerSecond} sets a second in a room of 10`);
  const hasty = witness.sensor('hasty').id;
  const most = Math.max(...witness.sets.map(({ frames }) => frames.filter(({ sensor }) => sensor === hasty).length));
  assert.ok(most <= 4, `${most} frames of one sensor in a set`);
});
