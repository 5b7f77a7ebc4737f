// SPDX-License-Identifier: Apache-2.0
// Damaged recordings: roomcast names the file and the fault, and exits with 1.
import assert from 'node:assert/strict';
import { cpSync, existsSync, readFileSync, readdirSync, rmSync, truncateSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';

import { Program, assertFailed, run, scratchFolder, startHub } from './program.mjs';

const obeysWithin_ms = 1_000;

/** A small recording made by the program itself; each test damages a copy of it. */
let recording;
const cleanups = [];

before(async () => {
  recording = join(scratchFolder({ after: (f) => cleanups.push(f) }), 'rig');
  const { code, stderr } = await run('simulate', recording, '--sensors', '2', '--seconds', '0.3');
  assert.equal(code, 0, stderr);
});
after(() => cleanups.forEach((cleanup) => cleanup()));

function copyOfRecording(t) {
  const rig = join(scratchFolder(t), 'rig');
  cpSync(recording, rig, { recursive: true });
  return rig;
}

function firstPicture(folder) {
  return join(folder, readdirSync(folder).sort()[0]);
}

function lastPicture(folder) {
  return join(folder, readdirSync(folder).sort().at(-1));
}

/** Plays sensor s0 of `rig` once, to a new hub. */
async function play(t, rig) {
  const hub = await startHub(t);
  return run('sensor', '--source', `rig:${rig}#s0`, '--hub', hub.url, '--once');
}

test('whole_recording_is_read_to_its_end', async () => {
  const { code, stdout, stderr } = await run('info', recording, '--json');
  assert.equal(code, 0, stderr);
  const { sensors } = JSON.parse(stdout);
  assert.deepEqual(sensors.map(({ id }) => id), ['s0', 's1']);
  for (const { frames, depth_crc32 } of sensors) {
    assert.ok(frames > 0);
    assert.equal(depth_crc32.length, frames);
  }
});

test('whole_recording_is_played_to_its_end', async (t) => {
  const { code, stderr } = await play(t, recording);
  assert.equal(code, 0, stderr);
});

test('a_sensor_whose_later_frames_lack_colour_is_played_to_its_end', async (t) => {
  const rig = copyOfRecording(t);
  const list = join(rig, 's0/rgb.txt');
  const lines = readFileSync(list, 'utf8').split('\n').filter((line) => /^\d/.test(line));
  assert.ok(lines.length > 2);
  writeFileSync(list, `${lines[0]}\n`);
  const { code, stderr } = await play(t, rig);
  assert.equal(code, 0, stderr);
});

const damages = {
  missing_depth_picture: [(rig) => rmSync(firstPicture(join(rig, 's0/depth'))), /s0\/depth\/.*\.png/],
  truncated_depth_picture: [(rig) => truncateSync(firstPicture(join(rig, 's0/depth')), 1000), /s0\/depth\/.*\.png/],
  empty_depth_picture: [(rig) => truncateSync(firstPicture(join(rig, 's0/depth')), 0), /s0\/depth\/.*\.png/],
  truncated_colour_picture: [(rig) => truncateSync(firstPicture(join(rig, 's0/rgb')), 1000), /s0\/rgb\//],
  depth_picture_of_another_size: [shrinkCamera, /size|512|424/],
  rig_json_cut_off: [(rig) => truncateSync(join(rig, 'rig.json'), 40), /rig\.json/],
  rig_json_of_another_type: [(rig) => writeFileSync(join(rig, 'rig.json'), '[1, 2]'), /rig\.json/],
  camera_json_missing: [(rig) => rmSync(join(rig, 's0/camera.json')), /camera\.json/],
  list_of_depth_missing: [(rig) => rmSync(join(rig, 's0/depth.txt')), /depth\.txt/],
  pose_that_is_no_rotation: [bendPose, /rig\.json/],
};

function shrinkCamera(rig) {
  const file = join(rig, 's0/camera.json');
  const camera = JSON.parse(readFileSync(file, 'utf8'));
  camera.depth.width -= 16;
  writeFileSync(file, JSON.stringify(camera));
}

function bendPose(rig) {
  const file = join(rig, 'rig.json');
  const description = JSON.parse(readFileSync(file, 'utf8'));
  description.sensors[0].world_from_depth = Array(16).fill(2);
  writeFileSync(file, JSON.stringify(description));
}

for (const [name, [spoil, sentence]] of Object.entries(damages)) {
  test(`damaged_recording_ends_with_1_and_one_sentence: ${name}`, async (t) => {
    const rig = copyOfRecording(t);
    spoil(rig);
    assertFailed(await run('info', rig), 1, sentence);
  });
}

test('sensor_that_comes_to_a_damaged_frame_ends_with_1_and_one_sentence', async (t) => {
  const rig = copyOfRecording(t);
  truncateSync(lastPicture(join(rig, 's0/depth')), 1000);
  assertFailed(await play(t, rig), 1, /s0\/depth\/.*\.png/);
});

test('folder_without_rig_json_is_no_rig', async (t) => {
  const rig = copyOfRecording(t);
  rmSync(join(rig, 'rig.json'));
  assertFailed(await play(t, rig), 1, /rig\.json/);
});

test('an_unknown_sensor_of_a_rig_is_named_with_the_existing_ones', async (t) => {
  const hub = await startHub(t);
  assertFailed(await run('sensor', '--source', `rig:${recording}#s9`, '--hub', hub.url), 1, /s9.*s0.*s1/);
});

/** Many thousand times the same picture: reading it takes seconds. */
function longRecording(t) {
  const rig = copyOfRecording(t);
  const [, file] = /^\d\S* (\S+)$/m.exec(readFileSync(join(rig, 's0/depth.txt'), 'utf8'));
  writeFileSync(join(rig, 's0/depth.txt'), Array.from({ length: 20_000 }, (_, i) => `${i}.0 ${file}\n`).join(''));
  rmSync(join(rig, 's0/rgb.txt'));
  return join(rig, 's0');
}

test('info_that_is_interrupted_fails_instead_of_telling_figures_of_a_part', async (t) => {
  const recording = longRecording(t);
  for (const options of [['--json'], [], ['--thumbnails', join(recording, 'a.png')]]) {
    const program = new Program(['info', recording, ...options]);
    await delay(500);
    const begin = performance.now();
    const code = await program.stop('SIGINT');
    assertFailed({ code, stderr: program.stderr }, 1, /interrupted before the recording was read to its end/);
    if (options.includes('--json')) assert.deepEqual(Object.keys(JSON.parse(program.stdout)), ['error']);
    else assert.equal(program.stdout, '');
    assert.ok(performance.now() - begin < obeysWithin_ms);
  }
});

test('simulate_does_not_overwrite_a_recording', async (t) => {
  const rig = copyOfRecording(t);
  const before = readFileSync(join(rig, 'rig.json'));
  assertFailed(await run('simulate', rig, '--sensors', '1', '--seconds', '0.1'), 1, /not empty/);
  assert.deepEqual(readFileSync(join(rig, 'rig.json')), before);
});

test('simulate_that_is_interrupted_leaves_a_recording_that_can_be_played', async (t) => {
  const rig = join(scratchFolder(t), 'rig');
  const program = new Program(['simulate', rig, '--sensors', '1', '--seconds', '60']);
  while (!hasPicture(rig)) await new Promise((resolve) => setImmediate(resolve));
  await program.stop('SIGINT');
  const { code, stderr } = await run('info', rig);
  assert.equal(code, 0, stderr);
});

test('simulate_obeys_while_it_prepares_the_room', async (t) => {
  const rig = join(scratchFolder(t), 'rig');
  const program = new Program(['simulate', rig, '--sensors', '8', '--seconds', '60', '--views', '0']);
  await delay(1_000);
  const begin = performance.now();
  const code = await program.stop('SIGINT');
  const took_ms = performance.now() - begin;
  t.diagnostic(`${took_ms.toFixed(0)} ms`);
  assertFailed({ code, stderr: program.stderr }, 1, /stopped before the first frame/);
  assert.equal(existsSync(rig), false, 'no empty folder is left');
  assert.ok(took_ms < obeysWithin_ms, `${took_ms} ms`);
});

test('a_simulated_sensor_and_the_demo_obey_while_they_prepare_the_room', async (t) => {
  const hub = await startHub(t);
  for (const args of [['sensor', '--source', 'sim', '--hub', hub.url], ['demo', '--port', '0']]) {
    const program = new Program(args);
    await delay(700);
    const begin = performance.now();
    assert.equal(await program.stop('SIGINT'), 0, `${args[0]}: ${program.stderr}`);
    const took_ms = performance.now() - begin;
    t.diagnostic(`${args[0]}: ${took_ms.toFixed(0)} ms`);
    assert.ok(took_ms < obeysWithin_ms, `${args[0]}: ${took_ms} ms`);
  }
});

test('a_sensor_whose_hub_does_not_answer_obeys', async (t) => {
  const silent = createServer(() => {});
  await new Promise((resolve) => silent.listen(0, '127.0.0.1', resolve));
  t.after(() => silent.close());
  const asked = new Promise((resolve) => silent.once('connection', resolve));
  const hub = `ws://127.0.0.1:${silent.address().port}`;
  const program = new Program(['sensor', '--source', 'sim', '--hub', hub]);
  (await asked).on('error', () => {});
  assert.equal(await program.stop('SIGINT'), 0, program.stderr);
});

function hasPicture(rig) {
  try {
    return readFileSync(join(rig, 's0/depth.txt'), 'utf8').includes('.png');
  } catch {
    return false;
  }
}
