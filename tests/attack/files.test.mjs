// SPDX-License-Identifier: Apache-2.0
// Attacks what programs read: rigs, recordings, pictures, calibrations, configurations, tokens, the hub's own files and
// others are damaged, swapped, or replaced by things that are no files. Each program ends with a documented code and a
// sentence.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { symlinkSync, truncateSync, writeFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { test } from 'node:test';

import { run, scratchFolder, startHub } from '../cli/program.mjs';
import { startSensor } from '../network/rooms.mjs';
import { writeSmallRig } from '../network/small_rig.mjs';
import { confinedTo, faultsOf, runAttacked } from './attacked_program.mjs';
import { attackInTurn, timeout } from './attacker.mjs';
import { BystandingHub } from './bystander.mjs';
import { damaged } from './damage.mjs';

const patience_ms = 2_500;
const atATime = 3;
const sparseBytes = 5_000_000_000;
const wrongKindShare = 0.08;

const configuration = `listen = "127.0.0.1:0"
[access]
default = "token"
[[room]]
name = "lab"
record = "admin"
max_viewers = 5
`;

const cameraInfo = `image_width: 64
image_height: 48
camera_name: test
camera_matrix: {rows: 3, cols: 3, data: [60, 0, 31.5, 0, 60, 23.5, 0, 0, 1]}
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [0.1, 0, 0, 0, 0]}
`;

const credentials = `-----BEGIN NATS USER JWT-----
eyJ0eXAiOiJKV1QifQ.e30.x
------END NATS USER JWT------
-----BEGIN USER NKEY SEED-----
SUAA
------END USER NKEY SEED------
`;

const cameraPath = '{"keys": [{"time_s": 0, "at": [0, 1.5, 2], "look": [0, 1, 0]}, {"time_s": 1, "at": [1, 1.5, 2], "look": [0, 1, 0]}]}';

/** A rig with colour: every depth picture has one beside it, drawn by ffmpeg. False if there is no ffmpeg. */
function addColor(rig) {
  for (const sensor of readdirSync(rig).filter((name) => /^s\d$/.test(name))) {
    const folder = join(rig, sensor);
    mkdirSync(join(folder, 'rgb'));
    const picture = ['-f', 'lavfi', '-i', 'testsrc=size=64x48:rate=10', '-frames:v', '4', join(folder, 'rgb/%d.jpg')];
    if (spawnSync('ffmpeg', ['-v', 'error', ...picture]).status !== 0) return false;
    const lines = readFileSync(join(folder, 'depth.txt'), 'utf8').split('\n').filter((line) => /^\d/.test(line));
    const stamps = lines.slice(0, 4).map((line) => line.split(' ')[0]);
    writeFileSync(join(folder, 'rgb.txt'), stamps.map((stamp, i) => `${stamp} rgb/${i + 1}.jpg\n`).join(''));
    const camera = JSON.parse(readFileSync(join(folder, 'camera.json'), 'utf8'));
    const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    writeFileSync(join(folder, 'camera.json'), JSON.stringify({ ...camera, color: camera.depth, color_from_depth: identity }));
  }
  return true;
}

/** One of everything that a program reads, in `folder`; the originals of what is damaged. */
async function makeOriginals(t, folder) {
  mkdirSync(folder);
  const rig = writeSmallRig(folder, { fps: 4 });
  const hasColor = addColor(rig);
  const { code, stderr } = await run('info', rig);
  assert.equal(code, 0, `the undamaged rig: ${stderr}`);
  const data = join(folder, 'data');
  const hub = await startHub(t, '--data', data, '--tls-self-signed');
  assert.equal(await hub.program.stop('SIGTERM'), 0);
  const token = await run('token', '--data', data, '--role', 'admin', '--ttl', '1h');
  writeFileSync(join(folder, 'admin.token'), token.stdout);
  await recordRoom(t, rig, join(folder, 'room.mcap'));
  const exported = await run('export', rig, '--format', 'foxglove', '--out', join(folder, 'foxglove'));
  assert.equal(exported.code, 0, exported.stderr);
  writeFileSync(join(folder, 'roomcast.toml'), configuration);
  writeFileSync(join(folder, 'camera_info.yaml'), cameraInfo);
  writeFileSync(join(folder, 'path.json'), cameraPath);
  writeFileSync(join(folder, 'hub.creds'), credentials);
  return hasColor;
}

async function recordRoom(t, rig, file) {
  const hub = await startHub(t);
  const sensors = [await startSensor(t, hub.url, rig, 0), await startSensor(t, hub.url, rig, 1)];
  const { code, stderr } = await run('record', file, '--hub', hub.url, '--seconds', '2');
  assert.equal(code, 0, stderr);
  await Promise.all([hub.program, ...sensors].map((program) => program.stop('SIGKILL')));
}

const inRig = /^rig\//;
const isRecording = /^room\.mcap$/;
const isForFoxglove = /^foxglove\//;
const isOfHub = /^data\//;

/** Which programs read a file: [pattern of its path, arguments]. `at` makes a path in the case's folder. */
const readers = [
  [inRig, (at) => ['info', at('rig')]],
  [inRig, (at) => ['info', at('rig'), '--thumbnails', at('out.png'), '--json']],
  [inRig, (at, url) => ['sensor', '--source', `rig:${at('rig')}#s0`, '--hub', url, '--once']],
  [inRig, (at) => ['align', at('rig'), '--json']],
  [inRig, (at) => ['align', at('rig'), '--write']],
  [inRig, (at, url, random) => ['export', at('rig'), '--format', random.pick(['ply', 'pcd', 'gltf', 'rig', 'tum', 'foxglove']), '--out', at('out')]],
  [inRig, (at) => ['measure', at('rig'), '--floor-plan', at('out.svg')]],
  [inRig, (at) => ['measure', at('rig'), '--from', 's0:10,10', '--to', 's0:30,20']],
  [inRig, (at) => ['info', at('rig/s0')]],
  [inRig, (at) => ['bench', 'codec', `rig:${at('rig')}#s0`, '--frames', '2', '--codec', 'roomcast']],
  [/camera\.json$/, (at, url) => ['sensor', '--source', 'sim:bare,clean', '--calibration', at('rig/s0/camera.json'), '--hub', url]],
  [isRecording, (at) => ['info', at('room.mcap')]],
  [isRecording, (at) => ['info', at('room.mcap'), '--thumbnails', at('out.png'), '--json']],
  [isRecording, (at, url, random) => ['play', at('room.mcap'), '--hub', url, '--speed', '10', ...(random.isTrue(0.3) ? ['--loop'] : [])]],
  [isRecording, (at) => ['play', at('room.mcap'), '--port', '0', '--speed', '10', '--from', '0.5']],
  [isRecording, (at, url) => ['sensor', '--source', `mcap:${at('room.mcap')}#s1`, '--hub', url, '--once']],
  [isRecording, (at, url, random) => ['export', at('room.mcap'), '--format', random.pick(['ply', 'pcd', 'gltf', 'rig', 'tum', 'foxglove']), '--out', at('out')]],
  [isRecording, (at) => ['measure', at('room.mcap'), '--floor-plan', at('out.svg')]],
  [isForFoxglove, (at) => ['import', at('foxglove/room.mcap'), at('out')]],
  [isForFoxglove, (at) => ['info', at('foxglove/room.mcap'), '--json']],
  [isForFoxglove, (at, url) => ['sensor', '--source', `foxglove:${at('foxglove/room.mcap')}#s1`, '--hub', url, '--once']],
  [/^roomcast\.toml$/, (at) => ['hub', '--config', at('roomcast.toml'), '--data', at('other')]],
  [/^roomcast\.toml$/, (at) => ['hub', '--check', '--config', at('roomcast.toml')]],
  [/^roomcast\.toml$/, (at) => ['token', '--list', '--config', at('roomcast.toml'), '--data', at('other')]],
  [isOfHub, (at) => ['hub', '--listen', '127.0.0.1:0', '--data', at('data'), '--tls-self-signed']],
  [isOfHub, (at) => ['token', '--data', at('data'), '--list', '--json']],
  [isOfHub, (at) => ['token', '--data', at('data'), '--role', 'viewer', '--room', 'room', '--link', 'https://127.0.0.1:1']],
  [isOfHub, (at) => ['hub', '--listen', '127.0.0.1:0', '--data', at('other'), '--tls-cert', at('data/self-signed.pem'), '--tls-key', at('data/self-signed.pem')]],
  [/^admin\.token$/, (at, url) => ['record', at('out.mcap'), '--hub', url, '--seconds', '0.2', '--token-file', at('admin.token')]],
  [/^admin\.token$/, (at, url) => ['nudge', 's0', '--hub', url, '--move', '0.1', '0', '0', '--token-file', at('admin.token')]],
  [/^camera_info\.yaml$/, (at) => ['calibrate', '--source', `rig:${at('rig')}#s0`, '--color-info', at('camera_info.yaml'), '--out', at('out'), '--views', '3']],
  [/^path\.json$/, (at) => ['export', at('rig'), '--format', 'video', '--size', '64,48', '--fps', '2', '--path', at('path.json'), '--out', at('out')]],
  [/^hub\.creds$/, (at) => ['hub', '--listen', '127.0.0.1:0', '--data', at('other'), '--nats', 'nats://127.0.0.1:1', '--nats-credentials', at('hub.creds')]],
];

function filesIn(folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name);
    return entry.isDirectory() ? filesIn(path) : [path];
  });
}

/** What is no file, or endless, or of another kind. */
const wrongKinds = {
  folder: (path) => mkdirSync(path),
  pipe: (path) => spawnSync('mkfifo', [path]),
  endless: (path) => symlinkSync('/dev/zero', path),
  full: (path) => symlinkSync('/dev/full', path),
  itself: (path) => symlinkSync(path, path),
  nothing: () => {},
  sparse(path) {
    writeFileSync(path, '');
    truncateSync(path, sparseBytes);
  },
};

function damageFile(path, random, others) {
  if (random.isTrue(wrongKindShare)) {
    const kind = random.pick(Object.keys(wrongKinds));
    rmSync(path);
    wrongKinds[kind](path);
    return kind;
  }
  if (random.isTrue(0.05)) {
    const other = random.pick(others);
    writeFileSync(path, readFileSync(other));
    return `swapped with ${other}`;
  }
  writeFileSync(path, damaged(readFileSync(path), random));
  return 'damaged';
}

/** A program that the damaged file is read by, and how the file was damaged. */
function damagedCase(random, originals, folder, url) {
  const [pattern, argumentsOf] = random.pick(readers);
  const files = filesIn(originals);
  const chosen = random.pick(files.filter((path) => pattern.test(relative(originals, path))));
  const name = relative(originals, chosen);
  const [top] = name.split('/');
  cpSync(join(originals, top), join(folder, top), { recursive: true });
  if (top !== 'rig') cpSync(join(originals, 'rig'), join(folder, 'rig'), { recursive: true });
  const how = damageFile(join(folder, name), random, files);
  return { name, how, args: argumentsOf((path) => join(folder, path), url, random) };
}

test('no_damaged_file_makes_a_program_fall_over', timeout, async (t) => {
  const folder = scratchFolder(t);
  const through = confinedTo(folder);
  if (!through) return t.skip('root without a mount namespace: damaged files could lead anywhere');
  const originals = join(folder, 'originals');
  const hasColor = await makeOriginals(t, originals);
  if (!hasColor) t.diagnostic('without colour: there is no ffmpeg');
  for (const [pattern] of readers) {
    assert.ok(filesIn(originals).some((path) => pattern.test(relative(originals, path))), `there is a ${pattern}`);
  }
  const hub = await BystandingHub.start(t);
  const env = { PATH: process.env.PATH, HOME: folder, XDG_STATE_HOME: folder, TMPDIR: folder, LANG: 'C.UTF-8' };
  await attackInTurn(
    t,
    async (random) => {
      const cwd = mkdtempSync(join(folder, 'case_'));
      const { name, how, args } = damagedCase(random, originals, cwd, hub.url);
      const faults = faultsOf(await runAttacked(args, { through, cwd: folder, env, patience_ms }));
      if (faults.length === 0) rmSync(cwd, { recursive: true, force: true });
      return faults.map((fault) => `${name}, ${how}: ${fault}`);
    },
    { atATime },
  );
  await hub.assertServes(t, join(originals, 'rig'));
});
