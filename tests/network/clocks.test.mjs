// SPDX-License-Identifier: Apache-2.0
// Sensors with clocks unrelated to the hub's: their frames carry room time, and frames of the same time come in one
// set. Each host is a Linux time namespace with a monotonic clock of its own.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { test } from 'node:test';

import { scratchFolder, startHubThrough } from '../cli/program.mjs';
import { RoomClient } from './room_client.mjs';
import { startSensor } from './rooms.mjs';
import { writeSmallRig, writeSmallRigTimedAs } from './small_rig.mjs';

// Ahead of this machine, whose clock began when it was started: no clock can show a time before that. The hub's clock is
// between those of its sensors.
const hubAhead_s = 7_000;
const sensorsAhead_s = [7_000, 97_000, 0, 3_463_789];
const data = process.env.ROOMCAST_DATA ?? fileURLToPath(new URL('../../../shared/data', import.meta.url));
const house = `${data}/house3`;

/** A command that runs another command on a host whose clock is `seconds` ahead. */
const onHostAhead = (seconds) => ['unshare', '--time', `--monotonic=${seconds}`, '--fork', '--kill-child', '--'];

const mayHaveOtherHosts = spawnSync('unshare', [...onHostAhead(1).slice(1), 'true']).status === 0;
const noOtherHosts = mayHaveOtherHosts ? false : 'time namespaces need root and Linux 5.6';

const percentile = (values, share) => [...values].sort((a, b) => a - b)[Math.floor(share * (values.length - 1))];

/** For each set with frames of all these sensors: time between its oldest and its newest picture, milliseconds. */
function skews_ms(client, sensorIds) {
  const shownBy = ({ frames }, id) => frames.findLast(({ sensor }) => sensor === id)?.captureNs;
  return client.sets
    .map((set) => sensorIds.map((id) => shownBy(set, id)))
    .filter((times) => times.every((time) => time !== undefined))
    .map((times) => times.sort((a, b) => (a < b ? -1 : 1)))
    .map((times) => Number(times.at(-1) - times[0]) / 1e6);
}

async function witnessOf(t, hub, sensors, sets) {
  const witness = await RoomClient.join(t, hub.url);
  await witness.until('all sensors', () => witness.rosters.at(-1)?.sensors.filter(({ online }) => online).length === sensors);
  const ids = witness.rosters.at(-1).sensors.map(({ id }) => id);
  await witness.until('a frame of each', () => ids.every((id) => witness.seqsOf(id).length > 0));
  witness.sets = [];
  await witness.moreSets(sets);
  return { witness, ids };
}

test('sensors_whose_clocks_are_days_apart_stamp_room_time', { skip: noOtherHosts }, async (t) => {
  const fps = 10;
  const hub = await startHubThrough(t, onHostAhead(hubAhead_s));
  const rig = writeSmallRig(scratchFolder(t), { fps });
  await Promise.all(sensorsAhead_s.map((ahead, n) => startSensor(t, hub.url, rig, n, { through: onHostAhead(ahead) })));
  const { witness, ids } = await witnessOf(t, hub, sensorsAhead_s.length, 40);

  // A recording is played so that its frames are due at whole tenths of a second of its host's clock, and the hosts'
  // clocks are whole seconds apart: the remainder is the error.
  const frames = witness.sets.flatMap((set) => set.frames);
  const errors_us = frames.map(({ captureNs }) => Math.abs(Number((captureNs + 50_000_000n) % 100_000_000n) - 5e7) / 1e3);
  t.diagnostic(`error of capture times: p50 ${percentile(errors_us, 0.5)} us, p95 ${percentile(errors_us, 0.95)} us`);
  frames.forEach(({ clockErrorUs }, i) => {
    assert.ok(errors_us[i] <= clockErrorUs, `${errors_us[i]} us wrong, and said at most ${clockErrorUs} us`);
  });
  assert.ok(percentile(errors_us, 0.95) < 1_000, 'within a millisecond');
  const skews = skews_ms(witness, ids);
  assert.ok(skews.length >= 0.9 * witness.sets.length, `${skews.length} of ${witness.sets.length} sets are complete`);
  assert.ok(percentile(skews, 0.9) < 2, `the frames of a set are ${percentile(skews, 0.9)} ms apart`);
});

const noRealTimes = existsSync(house) ? noOtherHosts : `no recordings at ${data}; set ROOMCAST_DATA to test with them`;

test('sensors_that_drift_and_drop_frames_at_seconds_apart_line_up', { skip: noRealTimes }, async (t) => {
  const period_ms = 1000 / 30;
  const jitter_ms = 2; // of that recording's stamps
  const hub = await startHubThrough(t, onHostAhead(hubAhead_s));
  const rig = writeSmallRigTimedAs(house, scratchFolder(t));
  await Promise.all([0, 1, 2].map((n) => startSensor(t, hub.url, rig, n, { through: onHostAhead(sensorsAhead_s[n]) })));
  const { witness, ids } = await witnessOf(t, hub, 3, 90);
  const skews = skews_ms(witness, ids);
  const [median, worst] = [percentile(skews, 0.5).toFixed(1), Math.max(...skews).toFixed(1)];
  t.diagnostic(`${skews.length} of ${witness.sets.length} sets have all sensors, ${median} ms apart, at most ${worst} ms`);
  assert.ok(skews.length >= 0.8 * witness.sets.length, `${skews.length} of ${witness.sets.length} sets are complete`);
  const aligned = skews.filter((skew) => skew <= period_ms + 2 * jitter_ms);
  assert.ok(aligned.length >= 0.9 * skews.length, `${aligned.length} of ${skews.length} sets within a frame period`);
});
