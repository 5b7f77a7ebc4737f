// SPDX-License-Identifier: Apache-2.0
// The scripts for Blender (examples/blender) in Blender itself, without a window: what they load is compared with the files
// as other libraries read them, and what a live room shows with what its sensors saw.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, readFileSync, readdirSync, statSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { writeViewerPose } from '../network/messages.mjs';
import { RoomClient } from '../network/room_client.mjs';
import { writeSmallRig } from '../network/small_rig.mjs';
import { Program, binary, run, scratchFolder, startHub } from './program.mjs';

const require = createRequire(new URL('../../web/package.json', import.meta.url));
const { PLYLoader } = await import(require.resolve('three/examples/jsm/loaders/PLYLoader.js'));
const { NodeIO } = require('@gltf-transform/core');

const here = dirname(fileURLToPath(import.meta.url));
const script = resolve(here, '../../examples/blender/roomcast_sequence.py');
const skip = spawnSync('blender', ['--version']).error ? 'blender is not installed (Debian: apt install blender)' : false;

const liveScript = resolve(here, '../../examples/blender/roomcast_live.py');
const pythonModule = resolve(dirname(binary), '../python');
const isBuilt = existsSync(join(pythonModule, 'roomcast')) && readdirSync(join(pythonModule, 'roomcast')).some((name) => name.startsWith('_core'));
const skipLive = skip || (isBuilt ? false : 'the Python module is not built');

const cleanups = [];
after(() => cleanups.forEach((cleanup) => cleanup()));
let rig;
before(() => {
  rig = writeSmallRig(scratchFolder({ after: (cleanup) => cleanups.push(cleanup) }), { fps: 5 });
});

async function blender(...args) {
  const quiet = ['--background', '--factory-startup', '--python-exit-code', '1'];
  const child = spawn('blender', [...quiet, ...args], { stdio: ['ignore', 'pipe', 'pipe'], timeout: 60_000 });
  let output = '';
  for (const stream of [child.stdout, child.stderr]) stream.setEncoding('utf8').on('data', (text) => (output += text));
  const [code, signal] = await once(child, 'close');
  return { code: code ?? signal, output };
}

/** What is in Blender's scene after the folder has been loaded at 10 frames a second; see blender_dump.py. */
async function load(t, folder, ...picture) {
  const out = join(scratchFolder(t), 'scene.json');
  const { code, output } = await blender('--python', join(here, 'blender_dump.py'), '--', script, out, folder, ...picture);
  assert.equal(code, 0, output);
  return JSON.parse(readFileSync(out, 'utf8'));
}

async function exported(t, recording, format, ...options) {
  const out = join(scratchFolder(t), format);
  const result = await run('export', recording, '--format', format, '--out', out, '--json', ...options);
  assert.equal(result.code, 0, result.stderr);
  return { out, totals: JSON.parse(result.stdout) };
}

function arrayBuffer(file) {
  return Uint8Array.from(readFileSync(file)).buffer;
}

/** Points of roomcast, y up, as Blender should have them. */
function turned(positions) {
  const result = [];
  for (let i = 0; i < positions.length; i += 3) result.push(positions[i], -positions[i + 2], positions[i + 1]);
  return result;
}

function assertSame(actual, expected) {
  assert.equal(actual.length, expected.length);
  for (let i = 0; i < expected.length; ++i) assert.ok(Math.abs(actual[i] - expected[i]) < 1e-4, `${i}: ${actual[i]}, not ${expected[i]}`);
}

test('point_clouds_follow_one_another', { skip }, async (t) => {
  const { out } = await exported(t, rig, 'ply', '--every', '3');
  const picture = join(scratchFolder(t), 'a.png');
  const { sets, visible, first } = await load(t, out, picture);
  assert.deepEqual(sets, ['set_000000', 'set_000003', 'set_000006', 'set_000009']);
  assert.deepEqual(visible, sets.map((name) => [name]), 'a rig has no date: one set a frame');
  const positions = new PLYLoader().parse(arrayBuffer(join(out, 'set_000000.ply'))).getAttribute('position').array;
  assert.equal(first.length, 1);
  assertSame(first[0].positions, turned(positions));
  assert.ok(statSync(picture).size > 5000, 'the picture shows something');
});

test('sets_are_shown_when_they_were_captured', { skip }, async (t) => {
  const hub = await startHub(t);
  const sensor = new Program(['sensor', '--source', `rig:${rig}#s0`, '--hub', hub.url, '--verbose']);
  t.after(() => sensor.stop('SIGKILL'));
  await sensor.prints(/joined/);
  const file = join(scratchFolder(t), 'lab.mcap');
  assert.equal((await run('record', file, '--hub', hub.url, '--seconds', '3')).code, 0);
  const { out } = await exported(t, file, 'ply', '--every', '5');
  const captured = readdirSync(out).sort().map((name) => {
    const [, date, ms] = /^comment captured (\S+\.(\d{3}))\d{6}Z$/m.exec(readFileSync(join(out, name), 'latin1'));
    return Date.parse(`${date}Z`, ms);
  });
  assert.ok(captured.length >= 2);
  const { sets, visible } = await load(t, out);
  captured.forEach((time, i) => {
    const begin = visible.findIndex((names) => names.includes(sets[i]));
    assert.ok(Math.abs(begin / 10 - (time - captured[0]) / 1000) < 0.1, `${sets[i]} from frame ${begin + 1}`);
  });
  assert.ok(visible.every((names) => names.length === 1), 'always one set');
});

test('textured_meshes_are_where_their_sensors_saw_them', { skip }, async (t) => {
  const { out } = await exported(t, rig, 'gltf', '--every', '9');
  const { sets, first } = await load(t, out);
  assert.deepEqual(sets, ['set_000000', 'set_000009']);
  assert.deepEqual(first.map(({ name }) => name).sort(), ['s0', 's1', 's2', 's3']);
  const document = await new NodeIO().read(join(out, 'set_000000.glb'));
  for (const node of document.getRoot().listNodes()) {
    const m = node.getMatrix(); // column by column
    const local = node.getMesh().listPrimitives()[0].getAttribute('POSITION').getArray();
    const world = [];
    for (let i = 0; i < local.length; i += 3) {
      for (const row of [0, 1, 2]) world.push(m[row] * local[i] + m[4 + row] * local[i + 1] + m[8 + row] * local[i + 2] + m[12 + row]);
    }
    const { positions, triangles } = first.find(({ name }) => name === node.getName());
    assertSame(positions, turned(world));
    assert.equal(triangles, node.getMesh().listPrimitives()[0].getIndices().getCount() / 3);
  }
});

test('a_mesh_of_the_still_room_is_loaded_whole', { skip }, async (t) => {
  const { out, totals } = await exported(t, rig, 'mesh', '--to', '0.1', '--voxel', '0.02');
  const { sets, first } = await load(t, out);
  assert.deepEqual(sets, ['room']);
  const document = await new NodeIO().read(join(out, 'room.glb'));
  assertSame(first[0].positions, turned(document.getRoot().listMeshes()[0].listPrimitives()[0].getAttribute('POSITION').getArray()));
  // Blender leaves out triangles that another one covers.
  assert.ok(first[0].triangles <= totals.triangles && first[0].triangles > 0.999 * totals.triangles, `${first[0].triangles} of ${totals.triangles}`);
});

test('a_folder_without_an_export_is_a_sentence', { skip }, async (t) => {
  const { code, output } = await blender('--python', script, '--', scratchFolder(t));
  assert.equal(code, 1, output);
  assert.match(output, /roomcast_sequence\.py: .* has no set_NNNNNN\.glb, set_NNNNNN\.ply or room\.glb/);
  assert.doesNotMatch(output, /Traceback/);
});

/** Points of s0 or s1 of the small rig, as Blender has them: each is where a pixel saw something, and all are of one instant. */
function assertSeenBy(sensor, positions) {
  assert.equal(positions.length, 3 * 62 * 46, 'all pixels but the border, which have normals');
  const instants = new Set();
  for (let i = 0; i < positions.length; i += 3) {
    const [x, y, z] = [positions[i], positions[i + 2], -positions[i + 1]]; // the room's y is up
    const ahead = sensor === 's0' ? 2 - z : 2 - x;
    const u = ((sensor === 's0' ? x : -z) / ahead) * 60 + 31.5;
    const v = ((1.5 - y) / ahead) * 60 + 23.5;
    for (const pixel of [u, v]) assert.ok(Math.abs(pixel - Math.round(pixel)) < 0.01, `${sensor}: ${u}, ${v}`);
    const instant = ahead * 1000 - Math.round(u) - Math.round(v) - (sensor === 's0' ? 1500 : 1600);
    assert.ok(Math.abs(instant - Math.round(instant)) < 0.01, `${sensor}: ${instant}`);
    instants.add(Math.round(instant));
  }
  assert.equal(instants.size, 1);
  return [...instants][0] / 10;
}

async function startLiveRoom(t) {
  const hub = await startHub(t);
  for (const sensor of ['s0', 's1']) {
    const program = new Program(['sensor', '--source', `rig:${rig}#${sensor}`, '--hub', hub.url, '--codec', 'lossless', '--verbose']);
    t.after(() => program.stop('SIGKILL'));
    await program.prints(/joined/);
  }
  return hub;
}

test('a_live_room_is_shown_and_followed', { skip: skipLive }, async (t) => {
  const hub = await startLiveRoom(t);
  const ada = await RoomClient.join(t, hub.url, { name: 'Ada' });
  const stands = setInterval(() => ada.send(writeViewerPose([0.5, 1.5, 0.25])), 50);
  t.after(() => clearInterval(stands));
  const out = join(scratchFolder(t), 'live.json');
  const { code, output } = await blender('--python', join(here, 'blender_live.py'), '--', liveScript, pythonModule, hub.url, out);
  assert.equal(code, 0, output);
  const { told, objects, left, head, failure } = JSON.parse(readFileSync(out, 'utf8'));
  const instants = told.map((sets) => ['s0', 's1'].map((sensor) => assertSeenBy(sensor, sets[sensor])));
  assert.equal(instants.length, 5);
  for (const n of [0, 1]) assert.ok(new Set(instants.map((pair) => pair[n])).size >= 4, `the points follow the room: ${instants}`);
  assert.deepEqual(objects, ['roomcast person Ada', 'roomcast s0', 'roomcast s1']);
  assertSame(head, [0.5, -0.25, 1.5]);
  assert.deepEqual(left, ['roomcast s0', 'roomcast s1'], 'what was received last stays');
  assert.match(failure, /127\.0\.0\.1/);
});

test('a_picture_of_a_live_room_is_saved_without_a_window', { skip: skipLive }, async (t) => {
  const hub = await startLiveRoom(t);
  const file = join(scratchFolder(t), 'room.blend');
  const { code, output } = await blender('--python', liveScript, '--', hub.url, '--module', pythonModule, '--save', file);
  assert.equal(code, 0, output);
  assert.match(output, new RegExp(`^2 sensors, ${2 * 62 * 46} points$`, 'm'));
  assert.ok(statSync(file).size > 50_000);
  const nowhere = await blender('--python', liveScript, '--', 'ws://127.0.0.1:1', '--module', pythonModule);
  assert.equal(nowhere.code, 1, nowhere.output);
  assert.match(nowhere.output, /^roomcast_live\.py: .*127\.0\.0\.1/m);
  assert.doesNotMatch(nowhere.output, /Traceback/);
});
