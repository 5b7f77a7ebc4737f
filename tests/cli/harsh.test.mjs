// SPDX-License-Identifier: Apache-2.0
// Harsh recordings: what `simulate --harsh` writes; and rigs whose lens file is nonsense, which no command may take.
import assert from 'node:assert/strict';
import { cpSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { Program, assertFailed, run, scratchFolder, startHub } from './program.mjs';

let recording;
const cleanups = [];

before(async () => {
  recording = join(scratchFolder({ after: (f) => cleanups.push(f) }), 'rig');
  const options = ['--scene', 'bare', '--harsh=structured', '--sensors', '2', '--seed', '5', '--views', '0'];
  const { code, stderr } = await run('simulate', recording, ...options);
  assert.equal(code, 0, stderr);
});
after(() => cleanups.forEach((cleanup) => cleanup()));

/** The first entry of a JPEG's first quantisation table. */
function coarseness(file) {
  const bytes = readFileSync(file);
  const at = bytes.indexOf(Buffer.from([0xff, 0xdb]));
  return bytes[at + 5];
}

test('a_harsh_recording_is_short_slow_and_coarse', () => {
  const rig = JSON.parse(readFileSync(join(recording, 'rig.json'), 'utf8'));
  assert.ok(rig.fps >= 5 && rig.fps <= 30, String(rig.fps));
  const depth = readdirSync(join(recording, 's0', 'depth'));
  assert.ok(depth.length >= 1 && depth.length <= 30, String(depth.length));
  const color = readdirSync(join(recording, 's0', 'rgb')).sort();
  assert.equal(coarseness(join(recording, 's0', 'rgb', color[0])), 13); // 16 at quality 50, 13 at 60
});

test('harsh_sensors_declare_one_nominal_lens_and_have_others', () => {
  const lens = (folder, sensor) => JSON.parse(readFileSync(join(folder, sensor, 'camera.json'), 'utf8')).depth;
  assert.equal(lens(recording, 's0').fx, lens(recording, 's1').fx);
  const truth = join(recording, 'truth');
  assert.notEqual(lens(truth, 's0').fx, lens(truth, 's1').fx);
});

test('mutual_interference_can_be_had_alone_and_changes_what_sensors_read', async (t) => {
  const folder = scratchFolder(t);
  const options = ['--scene', 'corners', '--sensors', '4', '--seconds', '0.03', '--clock-drift', '0', '--views', '0'];
  const written = async (name, ...more) => {
    const { code, stderr } = await run('simulate', join(folder, name), ...options, ...more);
    assert.equal(code, 0, stderr);
    return readFileSync(join(folder, name, 's0', 'depth', '000000.png'));
  };
  const alone = await written('alone');
  assert.deepEqual(await written('again'), alone);
  const { stdout } = await run('simulate', '--help');
  assert.match(stdout, /--mutual-interference/);
});

/** A copy of the recording with another lens file of s0. */
function rigWithLens(t, text) {
  const rig = join(scratchFolder(t), 'rig');
  cpSync(recording, rig, { recursive: true });
  writeFileSync(join(rig, 's0', 'camera.json'), text);
  return rig;
}

const whole = () => JSON.parse(readFileSync(join(recording, 's0', 'camera.json'), 'utf8'));
const nonsense = {
  no_json: () => 'f = 585',
  no_focal_length: () => JSON.stringify({ ...whole(), depth: { ...whole().depth, fx: 0 } }),
  a_negative_width: () => JSON.stringify({ ...whole(), depth: { ...whole().depth, width: -640 } }),
  a_focal_length_of_text: () => JSON.stringify({ ...whole(), depth: { ...whole().depth, fx: 'wide' } }),
  a_focal_length_that_no_lens_has: () => JSON.stringify({ ...whole(), depth: { ...whole().depth, fx: 1e9, fy: 1e9 } }),
  a_centre_far_outside: () => JSON.stringify({ ...whole(), depth: { ...whole().depth, cx: 1e6 } }),
  another_size_than_the_pictures: () =>
    JSON.stringify({ ...whole(), depth: { ...whole().depth, width: 320, height: 240 } }),
};

for (const [what, text] of Object.entries(nonsense)) {
  test(`a_lens_file_with_${what}_is_named_by_sensor_demo_and_bench`, async (t) => {
    const rig = rigWithLens(t, text());
    const hub = await startHub(t);
    const why = /(camera\.json|\d{6}\.png|depth picture|focal|centre)/;
    assertFailed(await run('sensor', '--source', `rig:${rig}#s0`, '--hub', hub.url, '--once'), 1, why);
    const demo = await run('demo', '--rig', rig, '--port', '0', '--headless', '--seconds', '5');
    assert.equal(demo.code, 1, demo.stderr);
    assert.match(demo.stderr, why);
    assertFailed(await run('bench', 'real', rig, '--frames', '0'), 1, why);
  });
}

test('a_sensor_prints_its_state_as_json', async (t) => {
  const hub = await startHub(t);
  const sensor = new Program(['sensor', '--source', 'sim:bare', '--hub', hub.url, '--json', '--always']);
  t.after(() => sensor.stop('SIGKILL'));
  const [line] = await sensor.prints(/\{.*"interference".*\}/);
  const state = JSON.parse(line);
  assert.ok(state.frames_sent > 0);
  assert.ok(state.interference.flickering >= 0 && state.interference.flickering < 0.05, line);
});

test('a_sensor_that_fits_its_line_says_what_the_line_carries', async (t) => {
  const hub = await startHub(t);
  const options = ['sensor', '--source', 'sim:bare', '--hub', hub.url];
  const sensor = new Program([...options, '--json', '--always', '--mbit', 'auto']);
  t.after(() => sensor.stop('SIGKILL'));
  const [line] = await sensor.prints(/\{.*"line_mbit_per_s".*\}/);
  assert.ok(JSON.parse(line).line_mbit_per_s >= 0.1, line);
  assertFailed(await run(...options, '--mbit', 'automatic'), 2, /automatic is not a number from 0\.1 to 100, nor auto/);
  assertFailed(await run(...options, '--mbit', 'auto', '--codec', 'lossless'), 2, /a target rate needs live depth/);
});
