// SPDX-License-Identifier: Apache-2.0
// roomcast align of recordings without a recoverable pose: it prints one sentence, and never crashes or gives a pose.
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { deflateSync } from 'node:zlib';

import { pngOf, writeSmallRig } from '../network/small_rig.mjs';
import { assertFailed, run, scratchFolder } from './program.mjs';

const [width, height] = [64, 48];

/** Makes every sensor's colour black. */
function writeBlackRig(t) {
  const rig = writeSmallRig(scratchFolder(t), { fps: 20 });
  const black = pngOf(8, 2, deflateSync(Buffer.alloc(height * (1 + 3 * width))));
  for (const n of [0, 1, 2, 3]) {
    const sensor = join(rig, `s${n}`);
    const lines = readFileSync(join(sensor, 'depth.txt'), 'utf8');
    mkdirSync(join(sensor, 'rgb'));
    for (const [, name] of lines.matchAll(/depth\/(\S+)/g)) writeFileSync(join(sensor, 'rgb', name), black);
    writeFileSync(join(sensor, 'rgb.txt'), lines.replaceAll('depth/', 'rgb/'));
    const camera = JSON.parse(readFileSync(join(sensor, 'camera.json'), 'utf8'));
    const colored = { ...camera, color: camera.depth, color_from_depth: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] };
    writeFileSync(join(sensor, 'camera.json'), JSON.stringify(colored));
  }
  return rig;
}

const sensorKeys = [
  ...['id', 'placed', 'world_from_depth', 'expected_error_mm', 'expected_error_deg', 'color_shift_px', 'overlap'],
  ...['inliers', 'residual_mm', 'reason', 'depth_scale', 'depth_scale_standard_error'],
];

test('sensors_with_black_pictures_are_refused_each_with_a_reason', async (t) => {
  const rig = writeBlackRig(t);
  const result = await run('align', rig, '--json');
  assert.equal(result.code, 0, result.stderr);
  const { sensors, pairs } = JSON.parse(result.stdout);
  assert.equal(sensors.length, 4);
  for (const sensor of sensors) {
    assert.deepEqual(Object.keys(sensor).sort(), [...sensorKeys].sort());
    assert.equal(sensor.placed, false);
    assert.equal(sensor.world_from_depth, null);
    assert.equal(sensor.residual_mm, null);
    assert.match(sensor.reason, /\w+ \w+/);
  }
  for (const pair of pairs) assert.equal(pair.b_from_a, null);
  const text = await run('align', rig);
  assert.equal(text.code, 0, text.stderr);
  assert.match(text.stdout, /s0 +apart/);
  assert.doesNotMatch(text.stdout, /0\.0 mm|nan/);
});

test('verbose_json_adds_the_numbers_of_every_stage_and_changes_nothing_else', async (t) => {
  const rig = writeBlackRig(t);
  const brief = await run('align', rig, '--json');
  const verbose = await run('align', rig, '--json', '--verbose');
  assert.equal(verbose.code, 0, verbose.stderr);
  const { options, ...report } = JSON.parse(verbose.stdout);
  assert.deepEqual(report, JSON.parse(brief.stdout));
  const stages = ['bundle', 'view', 'rig', 'homography', 'nudge', 'stored_pose', 'refined_placement', 'heads', 'trajectories'];
  assert.deepEqual(Object.keys(options).sort(), [...stages, 'pose_change'].sort());
  assert.equal(options.rig.pair.free_space.points, 1500);
  assert.equal(options.view.planes.thickness_m, 0.025);
  for (const stage of Object.values(options)) assert.ok(Object.keys(stage).length > 2);
});

test('verbose_is_refused_without_json', async (t) => {
  const result = await run('align', writeBlackRig(t), '--verbose');
  assert.notEqual(result.code, 0);
  assert.match(result.stderr, /--json/);
});

test('invalid_intrinsics_are_refused_with_a_sentence', async (t) => {
  const rig = writeBlackRig(t);
  for (const lens of ['NaN', 'null', '1e999', '-60']) {
    const file = join(rig, 's1', 'camera.json');
    const camera = readFileSync(join(rig, 's0', 'camera.json'), 'utf8');
    writeFileSync(file, camera.replace('"fx":60', `"fx":${lens}`));
    assertFailed(await run('align', rig), 1, /camera\.json|s1|fx/);
  }
});

test('an_invalid_pose_in_rig_json_is_refused_with_a_sentence', async (t) => {
  const rig = writeBlackRig(t);
  const file = join(rig, 'rig.json');
  writeFileSync(file, readFileSync(file, 'utf8').replace('"world_from_depth":[1', '"world_from_depth":[NaN'));
  assertFailed(await run('align', rig), 1, /rig\.json/);
});
