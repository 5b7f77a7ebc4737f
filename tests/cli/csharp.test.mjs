// SPDX-License-Identifier: Apache-2.0
// The C# bindings of unity/ under Mono, against a real hub; Unity's component against stubs of the editor's classes.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { RoomClient } from '../network/room_client.mjs';
import { writeSmallRig } from '../network/small_rig.mjs';
import { Program, assertFailed, binary, run, runOther, scratchFolder, startHub } from './program.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const source = resolve(here, '../..');
const library = resolve(dirname(binary), '../lib/libroomcast.so.1');
const unity = join(source, 'unity/org.roomcast.unity');
const bindings = readdirSync(join(unity, 'Runtime/Bindings')).filter((name) => name.endsWith('.cs')).map((name) => join(unity, 'Runtime/Bindings', name));

function whySkipped() {
  for (const program of ['mcs', 'mono']) {
    if (spawnSync(program, ['--version']).error) return `${program} is not installed (Debian: apt install mono-mcs mono-runtime)`;
  }
  return existsSync(library) ? false : `${library} is not built`;
}
const skip = whySkipped();

let folder;
before(() => (folder = mkdtempSync(join(tmpdir(), 'roomcast-csharp-'))));
after(() => rmSync(folder, { recursive: true, force: true }));

/** Compiles C# with all warnings as errors; gives the path of the program, which finds the library as the guide says. */
function compile(name, sources, ...options) {
  const out = join(folder, name);
  const { status, stdout, stderr } = spawnSync('mcs', ['-warn:4', '-warnaserror+', `-out:${out}`, ...options, ...sources], { encoding: 'utf8', timeout: 60_000 });
  assert.equal(status, 0, stdout + stderr);
  writeFileSync(`${out}.config`, `<configuration><dllmap dll="roomcast" target="${library}" /></configuration>`);
  return out;
}

const mono = (program, ...args) => runOther('mono', program, ...args);

let compiledChecks;
function checks() {
  return (compiledChecks ??= compile('Checks.exe', [join(here, 'csharp/Checks.cs'), ...bindings]));
}

const example = join(source, 'examples/csharp/CountFrames.cs');

async function startRoom(t, ...sensors) {
  const hub = await startHub(t);
  const rig = writeSmallRig(scratchFolder(t));
  for (const sensor of sensors) {
    const program = new Program(['sensor', '--source', `rig:${rig}#${sensor}`, '--hub', hub.url, '--codec', 'lossless', '--verbose']);
    t.after(() => program.stop('SIGKILL'));
    await program.prints(/joined/);
  }
  return hub;
}

test('count_frames_is_short_enough_to_read', () => {
  assert.ok(readFileSync(example, 'utf8').trimEnd().split('\n').length < 40);
});

test('count_frames_counts_every_frame_once', { skip }, async (t) => {
  const program = compile('CountFrames.exe', [example, ...bindings]);
  const hub = await startRoom(t, 's0', 's1');
  const { code, stdout, stderr } = await mono(program, hub.url, '3');
  assert.equal(code, 0, stderr);
  const counts = stdout.trim().split('\n').map((line) => /^(s[01]): (\d+) frames$/.exec(line) ?? assert.fail(stdout));
  assert.deepEqual(counts.map(([, name]) => name), ['s0', 's1']);
  // 10 a second for 3 s.
  for (const [line, , count] of counts) assert.ok(count >= 20 && count <= 32, line);
  assertFailed(await mono(program, 'ws://127.0.0.1:1', '1'), 1, /^CountFrames: .*127\.0\.0\.1/);
});

test('structures_are_those_of_the_header', { skip }, async () => {
  const { code, stdout, stderr } = await mono(checks(), 'layouts');
  assert.equal(code, 0, stderr);
  const lines = stdout.trim().split('\n').map((line) => line.split(' '));
  assert.ok(lines.length > 60);
  const nameInC = (type) => `roomcast_${type.replace(/(?!^)[A-Z]/g, (letter) => `_${letter}`).toLowerCase()}`;
  const prints = lines.map(([type, field]) => (field === 'sizeof' ? `sizeof(${nameInC(type)})` : `offsetof(${nameInC(type)}, ${field})`));
  const c = ['#include <roomcast.h>', '#include <stdio.h>', 'int main(void) {', ...prints.map((value) => `  printf("%zu\\n", ${value});`), '}', ''];
  writeFileSync(join(folder, 'layouts.c'), c.join('\n'));
  const built = spawnSync('cc', ['-I', join(source, 'roomcast/capi'), '-o', join(folder, 'layouts'), join(folder, 'layouts.c')], { encoding: 'utf8' });
  assert.equal(built.status, 0, built.stderr);
  const inC = spawnSync(join(folder, 'layouts'), { encoding: 'utf8' }).stdout.trim().split('\n');
  assert.deepEqual(lines.map(([type, field, at]) => `${type} ${field} ${at}`), lines.map(([type, field], i) => `${type} ${field} ${inC[i]}`));
});

test('depth_and_calibration_arrive_unchanged_and_others_see_the_head', { skip }, async (t) => {
  const hub = await startRoom(t, 's0');
  const other = await RoomClient.join(t, hub.url);
  const file = join(scratchFolder(t), 'depth');
  const { code, stdout, stderr } = await mono(checks(), 'depth', hub.url, file);
  assert.equal(code, 0, stderr);
  const [about, pose, captured_ms] = stdout.trim().split('\n');
  assert.ok(Math.abs(Date.now() - captured_ms) < 20_000, `${captured_ms} is not UTC`);
  assert.equal(about, `s0 64 48 60 23.5 True False ${64 * 48} 255`);
  assert.deepEqual(pose.split(' ').map(Number), [1, 0, 0, 0, 0, -1, 0, 1.5, 0, 0, -1, 2, 0, 0, 0, 1]);
  const depth = new Uint16Array(Uint8Array.from(readFileSync(file)).buffer);
  assert.equal(depth.length, 64 * 48);
  depth.forEach((value, i) => assert.equal(value, depth[0] + (i % 64) + Math.floor(i / 64)));
  await other.until('the head', () => other.heads.some((head) => head.join() === '0.5,1.5,2'));
});

test('a_program_in_csharp_is_a_sensor', { skip }, async (t) => {
  const hub = await startHub(t);
  const sending = mono(checks(), 'publish', hub.url, 'csharp-camera');
  const other = await RoomClient.join(t, hub.url);
  await other.until('the sensor', () => other.sensor('csharp-camera'));
  const file = join(scratchFolder(t), 'depth');
  const seen = await mono(checks(), 'depth', hub.url, file);
  assert.match(seen.stdout, /^csharp-camera 64 48 60 23\.5 True True /, seen.stderr);
  assert.equal(new Uint16Array(Uint8Array.from(readFileSync(file)).buffer)[65], 1502);
  const { code, stdout, stderr } = await sending;
  assert.equal(code, 0, stderr);
  const [, sent, problem] = /^(\d+) True (.*)\n$/.exec(stdout) ?? assert.fail(stdout);
  assert.ok(sent > 40, stdout);
  assert.equal(problem, 'no problem');
});

test('people_and_marks_in_csharp', { skip }, async (t) => {
  const hub = await startHub(t);
  const { code, stdout, stderr } = await mono(checks(), 'people', hub.url);
  assert.equal(code, 0, stderr);
  const expected = [
    /^True Note 1,2,3 C♯ Ada False$/,
    /^Ada 1 0 0 0\.5 0 1 0 1\.5 0 0 1 2 0 0 0 1 True$/,
    /^mark of another: RoomcastException: only its author/,
    /^note without words: RoomcastException: a note and a place need words$/,
    /^half a point: RoomcastException: each point has 3 numbers$/,
    /^place without a token: RoomcastException: .*admin's token/,
    /^nudge without a token: RoomcastException: .*admin's token/,
    /^people that are gone: ObjectDisposedException/,
  ];
  const lines = stdout.trim().split('\n');
  assert.equal(lines.length, expected.length, stdout);
  lines.forEach((line, i) => assert.match(line, expected[i]));
});

test('voices_in_csharp', { skip }, async (t) => {
  const hub = await startHub(t);
  const { code, stdout, stderr } = await mono(checks(), 'voices', hub.url);
  assert.equal(code, 0, stderr);
  assert.match(stdout, /^may speak\nTrue True True True\ntoo much at once: RoomcastException: .*ahead of time\n$/);
});

test('a_voice_is_played_evenly', { skip }, async () => {
  const { stdout, stderr } = await mono(checks(), 'sound');
  assert.equal(
    stdout,
    'one packet is kept: 0\nthree are played: 1 1 1\nthen silence: 0, gaps 1\nof too many the newest are left: True, gaps 1\na short word is played: 1\n',
    stderr,
  );
});

test('a_program_in_csharp_records', { skip }, async (t) => {
  const hub = await startRoom(t, 's0');
  const file = join(scratchFolder(t), 'röom.mcap');
  const { code, stdout, stderr } = await mono(checks(), 'record', hub.url, file);
  assert.equal(code, 0, stderr);
  assert.equal(stdout, 'no problem\n');
  assert.ok(JSON.parse((await run('info', file, '--json')).stdout).sensors[0].frames > 5);
});

test('misuse_is_an_exception_with_a_sentence', { skip }, async (t) => {
  const hub = await startRoom(t, 's0');
  const { code, stdout, stderr } = await mono(checks(), 'misuse', hub.url);
  assert.equal(code, 0, stderr);
  const expected = [
    /^short matrix: RoomcastException: a matrix has 16 numbers, not 3$/,
    /^no rotation: RoomcastException: \S/,
    /^no such sensor: ArgumentOutOfRangeException/,
    /^picture of freed frames: ObjectDisposedException/,
    /^room that was left: ObjectDisposedException/,
    /^short picture: RoomcastException: the depth picture needs 3072 numbers, not 5$/,
    /^sensor without a camera: RoomcastException: \S/,
    /^nowhere: RoomcastException: .*\/nowhere\/a\.mcap/,
  ];
  const lines = stdout.trim().split('\n');
  assert.equal(lines.length, expected.length, stdout);
  lines.forEach((line, i) => assert.match(line, expected[i]));
});

const ofUnity = ['Runtime/RoomcastRoom.cs', 'Runtime/RoomcastPeople.cs', 'Runtime/RoomcastVoices.cs', 'Editor/RoomcastMenu.cs'];

test('what_needs_unity_compiles_against_stubs', { skip }, () => {
  compile('Unity.dll', [...ofUnity.map((file) => join(unity, file)), join(here, 'csharp/UnityStubs.cs'), ...bindings], '-target:library', '-nowarn:0649,0414');
});

test('the_unity_package_describes_itself', () => {
  const json = (name) => JSON.parse(readFileSync(join(unity, name), 'utf8'));
  const { name, version, unity: editor } = json('package.json');
  assert.match(name, /^[a-z0-9-]+(\.[a-z0-9-]+){2,}$/);
  assert.match(version, /^\d+\.\d+\.\d+$/);
  assert.match(editor, /^20\d\d\.\d$/);
  const parts = json('Runtime/Roomcast.Unity.asmdef');
  assert.deepEqual(parts.references, [json('Runtime/Bindings/Roomcast.Bindings.asmdef').name]);
  assert.deepEqual(json('Editor/Roomcast.Unity.Editor.asmdef').references, [...parts.references, parts.name]);
  for (const file of [...ofUnity, 'Runtime/Shaders/RoomcastDepthMesh.shader']) {
    assert.match(readFileSync(join(unity, file), 'utf8'), /NOT RUN/, 'what needs the editor says so');
  }
});
