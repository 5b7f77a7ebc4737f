// SPDX-License-Identifier: Apache-2.0
// The libroomcast examples against a real hub: C, C++ and Python receive and record a room.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { RoomClient } from '../network/room_client.mjs';
import { writeSmallRig } from '../network/small_rig.mjs';
import { Program, binary, run, runOther, scratchFolder, startHub } from './program.mjs';

const build = resolve(dirname(binary), '..');
const examples = resolve(dirname(fileURLToPath(import.meta.url)), '../../examples');
const library = join(build, 'lib/libroomcast.so.1');
const skip = existsSync(library) ? false : `${library} is not built`;

async function startRoom(t) {
  const hub = await startHub(t);
  const rig = writeSmallRig(scratchFolder(t));
  for (const sensor of ['s0', 's1']) {
    const program = new Program(['sensor', '--source', `rig:${rig}#${sensor}`, '--hub', hub.url, '--verbose']);
    t.after(() => program.stop('SIGKILL'));
    await program.prints(/joined/);
  }
  return hub;
}

test('library_shows_the_functions_of_its_header_and_nothing_else', { skip }, async () => {
  const header = readFileSync(join(examples, '../roomcast/capi/roomcast.h'), 'utf8');
  const declared = [...header.matchAll(/^ROOMCAST_API [^(]*?(roomcast_\w+)\(/gm)].map(([, name]) => name);
  const { stdout } = await runOther('nm', '--dynamic', '--defined-only', '--format=posix', library);
  const shown = stdout.split('\n').filter((line) => / T /.test(line)).map((line) => line.split(/[@ ]/)[0]);
  assert.ok(declared.length >= 13);
  assert.deepEqual(shown.sort(), declared.sort());
});

test('c_example_writes_the_points_of_the_room', { skip }, async (t) => {
  const hub = await startRoom(t);
  const ply = join(scratchFolder(t), 'room.ply');
  const { code, stdout, stderr } = await runOther(join(build, 'bin/roomcast_example_points'), hub.url, ply);
  assert.equal(code, 0, stderr);
  const [, count] = /^(\d+) points of 2 of 2 sensors/.exec(stdout) ?? assert.fail(stdout);
  assert.ok(Number(count) > 1000);
  const bytes = readFileSync(ply);
  const header = bytes.indexOf('end_header\n') + 'end_header\n'.length;
  assert.equal(bytes.length - header, 16 * Number(count));
});

test('c_example_leaves_a_note_and_sees_who_is_there', { skip }, async (t) => {
  const hub = await startHub(t);
  const { code, stdout, stderr } = await runOther(join(build, 'bin/roomcast_example_people'), hub.url, '1');
  assert.equal(code, 0, stderr);
  assert.match(stdout, /^people\.c is somewhere$/m);
  assert.match(stdout, /^people\.c left "people\.c was here" at 0\.0, 1\.0, 0\.0 m$/m);
  const nobody = await runOther(join(build, 'bin/roomcast_example_people'), 'ws://127.0.0.1:1', '1');
  assert.equal(nobody.code, 1);
  assert.match(nobody.stderr, /127\.0\.0\.1/);
});

test('c_example_is_a_sensor_whose_depth_arrives_unchanged', { skip }, async (t) => {
  const hub = await startHub(t);
  const sensor = runOther(join(build, 'bin/roomcast_example_sensor'), hub.url, 'my-camera', '4');
  const other = await RoomClient.join(t, hub.url);
  await other.until('the sensor', () => other.sensor('my-camera'));
  const seen = await runOther('python3', join(examples, 'depth.py'), hub.url, library);
  assert.match(seen.stdout, new RegExp(`^my-camera: 320x240, ${240 * (320 - 40)} readings, median 2\\.00 m$`, 'm'), seen.stderr);
  const { code, stdout, stderr } = await sensor;
  assert.equal(code, 0, stderr);
  assert.ok(Number(/^(\d+) frames sent, \d+ skipped/.exec(stdout)?.[1]) > 30, stdout);
});

test('c_examples_are_short_enough_to_read', () => {
  for (const name of ['sensor.c', 'read.c', 'people.c']) assert.ok(readFileSync(join(examples, name), 'utf8').trimEnd().split('\n').length < 40, name);
});

test('the_first_programs_of_the_guides_are_short_and_as_long_as_they_say', () => {
  for (const [guide, name] of [['python.md', 'python/save_live_points.py'], ['c-api.md', 'sensor.c'], ['csharp.md', 'csharp/CountFrames.cs']]) {
    const lines = readFileSync(join(examples, name), 'utf8').trimEnd().split('\n').length;
    assert.ok(lines < 40, name);
    const text = readFileSync(join(examples, '../docs/guides', guide), 'utf8');
    assert.ok(text.includes(`](../../examples/${name})`) && text.includes(`in ${lines} lines`), guide);
  }
});

test('cpp_example_records_the_room', { skip }, async (t) => {
  const hub = await startRoom(t);
  const file = join(scratchFolder(t), 'room.mcap');
  const example = join(build, 'bin/roomcast_example_record');
  const { code, stdout, stderr } = await runOther(example, hub.url, file, '2');
  assert.equal(code, 0, stderr);
  assert.match(stdout, /s0: frame \d+, \d+\.\d+ m ahead/);
  const info = await run('info', file, '--json');
  assert.equal(info.code, 0, info.stderr);
  assert.ok(JSON.parse(info.stdout).sensors.every(({ frames }) => frames > 5));
});

test('c_example_reads_a_recording_without_a_hub', { skip }, async (t) => {
  const hub = await startRoom(t);
  const file = join(scratchFolder(t), 'room.mcap');
  assert.equal((await run('record', file, '--hub', hub.url, '--seconds', '2')).code, 0);
  const { code, stdout, stderr } = await runOther(join(build, 'bin/roomcast_example_read'), file);
  assert.equal(code, 0, stderr);
  assert.match(stdout, /^s0: 64 x 48, focal length 60\.0\ns1: 64 x 48, focal length 60\.0$/m);
  assert.match(stdout, /^\d+\.\d{3} s: s1, 1[67]\d\d mm in the middle$/m);
  const [, sets, points] = /^(\d+) sets, (\d+) points$/m.exec(stdout) ?? assert.fail(stdout);
  assert.ok(sets > 5 && points > 64 * 48 * sets, stdout);
  const failed = await runOther(join(build, 'bin/roomcast_example_read'), '/nowhere.mcap');
  assert.equal(failed.code, 1);
  assert.match(failed.stderr, /nowhere/);
});

test('python_example_reads_depth_and_is_seen_by_others', { skip }, async (t) => {
  const hub = await startRoom(t);
  const other = await RoomClient.join(t, hub.url);
  const { code, stdout, stderr } = await runOther('python3', join(examples, 'depth.py'), hub.url, library);
  assert.equal(code, 0, stderr);
  for (const sensor of ['s0', 's1']) assert.match(stdout, new RegExp(`^${sensor}: 64x48, \\d+ readings, median \\d+\\.\\d\\d m$`, 'm'));
  await other.until('the pose', () => other.heads.some((head) => head.join() === '0.5,1.5,2'));
});

test('an_example_without_a_hub_says_so', { skip }, async () => {
  const nobody = 'ws://127.0.0.1:1';
  for (const program of [
    ['python3', join(examples, 'depth.py'), nobody, library],
    [join(build, 'bin/roomcast_example_sensor'), nobody, 'my-camera'],
  ]) {
    const { code, stderr } = await runOther(...program);
    assert.equal(code, 1);
    assert.match(stderr, /127\.0\.0\.1/);
  }
});
