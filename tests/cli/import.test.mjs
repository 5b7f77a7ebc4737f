// SPDX-License-Identifier: Apache-2.0
// Imports recordings of other programs, and compares pictures and times with what FFmpeg reads in them.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, readdirSync, truncateSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { Program, assertFailed, run, scratchFolder } from './program.mjs';

const sourceDir = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
const sharedData = process.env.ROOMCAST_DATA ?? join(sourceDir, '../shared/data');
const realAzureKinect = join(sharedData, 'azurekinect_mkv/recording.mkv');

const ffmpeg = (...args) => execFileSync('ffmpeg', ['-v', 'error', '-y', ...args], { maxBuffer: 1 << 30, stdio: ['ignore', 'pipe', 'pipe'] });

/** Depth values of a picture or of a track, frame after frame, as FFmpeg decodes them. */
const depthBytes = (...input) => ffmpeg(...input, '-f', 'rawvideo', '-vsync', '0', '-pix_fmt', 'gray16be', '-');

/** A lens and pose of the kind that an Azure Kinect has; the format is that of its calibration.json. */
function calibration() {
  const camera = (location, parameters, width, height, translation) => ({
    Location: `CALIBRATION_CameraLocation${location}`,
    SensorWidth: width,
    SensorHeight: height,
    Intrinsics: { ModelType: 'CALIBRATION_LensDistortionModelBrownConrady', ModelParameters: parameters },
    Rt: { Rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1], Translation: translation },
  });
  const depth = [0.51, 0.52, 0.49, 0.49, 0.55, -0.021, -0.0027, 0.89, 0.086, -0.014, 0, 0, -7e-5, 2e-5];
  const color = [0.5, 0.51, 0.48, 0.64, 0.33, -2.5, 1.46, 0.21, -2.31, 1.38, 0, 0, -1e-4, -2e-4];
  return { CalibrationInformation: { Cameras: [camera('D0', depth, 1024, 1024, [0, 0, 0]), camera('PV0', color, 4096, 3072, [-0.032, 0, 0])] } };
}

/**
 * A recording as k4arecorder makes it, written by FFmpeg: 320x288 depth and 1280x720 JPEG at 30 frames/s. FFmpeg does not name the
 * format of 16-bit depth in the track's header, so the four letters are put there afterwards.
 */
function writeAzureKinect(folder, serial, { sync = 'STANDALONE', offset_ns = 500_000_000, frames = 6, time = '2024-01-01T10:00:00Z' } = {}) {
  const file = join(folder, `${serial}.mkv`);
  const json = join(folder, 'calibration.json');
  writeFileSync(json, JSON.stringify(calibration()));
  const tags = { K4A_DEPTH_MODE: 'NFOV_2X2BINNED', K4A_COLOR_MODE: 'MJPG_720P', K4A_START_OFFSET_NS: offset_ns, K4A_WIRED_SYNC_MODE: sync, K4A_DEVICE_SERIAL_NUMBER: serial };
  ffmpeg(
    ...['320x288', '1280x720'].flatMap((size) => ['-t', String(frames / 30), '-f', 'lavfi', '-i', `testsrc2=size=${size}:rate=30`]),
    ...['-map', '0', '-map', '1', '-c:v:0', 'rawvideo', '-pix_fmt:v:0', 'gray16be', '-allow_raw_vfw', '1', '-c:v:1', 'mjpeg'],
    ...['-metadata:s:v:0', 'title=DEPTH', '-metadata:s:v:1', 'title=COLOR', '-metadata', `creation_time=${time}`],
    ...Object.entries(tags).flatMap(([name, value]) => ['-metadata', `${name}=${value}`]),
    ...['-attach', json, '-metadata:s:t', 'mimetype=application/octet-stream', '-metadata:s:t', 'filename=calibration.json', file],
  );
  const bytes = readFileSync(file);
  const header = bytes.indexOf(Buffer.from([40, 0, 0, 0, 320 & 255, 320 >> 8, 0, 0]));
  assert.ok(header > 0);
  bytes.write('b16g', header + 16, 'latin1');
  writeFileSync(file, bytes);
  return file;
}

const picturesOf = (folder) => readdirSync(folder).sort().map((name) => join(folder, name));
const timesOf = (list) => readFileSync(list, 'utf8').split('\n').filter((line) => /^\d/.test(line)).map((line) => Number(line.split(' ')[0]));

test('depth, colour and times are those that FFmpeg reads in a real recording', { skip: !existsSync(realAzureKinect) && `${realAzureKinect} is not there` }, async (t) => {
  const out = join(scratchFolder(t), 'rig');
  const result = await run('import', realAzureKinect, out, '--json');
  assert.equal(result.code, 0, result.stderr);
  const [sensor] = JSON.parse(result.stdout).sensors;
  const folder = join(out, sensor.id);
  const [depth] = picturesOf(join(folder, 'depth'));
  assert.ok(depthBytes('-i', depth).equals(depthBytes('-i', realAzureKinect, '-map', '0:1')));
  const [jpeg] = picturesOf(join(folder, 'rgb'));
  const copied = ffmpeg('-i', realAzureKinect, '-map', '0:0', '-c', 'copy', '-f', 'mjpeg', '-');
  assert.ok(readFileSync(jpeg).equals(copied));
  const packets = JSON.parse(execFileSync('ffprobe', ['-v', 'error', '-of', 'json', '-select_streams', 'v:1', '-show_packets', '-show_format', realAzureKinect], { stdio: ['ignore', 'pipe', 'ignore'] }));
  const seconds = Number(packets.packets[0].pts_time) + Number(packets.format.tags.K4A_START_OFFSET_NS) / 1e9;
  assert.ok(Math.abs(timesOf(join(folder, 'depth.txt'))[0] - seconds) < 1e-9);
});

test('two recordings become one room, on the clock that a sync cable joined', async (t) => {
  const folder = scratchFolder(t);
  const left = writeAzureKinect(folder, 'left', { sync: 'MASTER' });
  const right = writeAzureKinect(folder, 'right', { sync: 'SUBORDINATE', offset_ns: 550_000_000 });
  const out = join(folder, 'rig');
  const result = await run('import', left, right, out, '--json');
  assert.equal(result.code, 0, result.stderr);
  const report = JSON.parse(result.stdout);
  assert.match(report.clock, /sync cable/);
  assert.deepEqual(report.sensors.map(({ id, frames, frames_with_color, damaged }) => [id, frames, frames_with_color, damaged]), [['left', 6, 6, 0], ['right', 6, 6, 0]]);
  const depth = Buffer.concat(picturesOf(join(out, 'left/depth')).map((file) => depthBytes('-i', file)));
  assert.ok(depth.equals(depthBytes('-f', 'lavfi', '-i', 'testsrc2=size=320x288:rate=30', '-frames:v', '6')));
  const times = { left: timesOf(join(out, 'left/depth.txt')), right: timesOf(join(out, 'right/depth.txt')) };
  assert.ok(Math.abs(times.right[0] - times.left[0] - 0.05) < 1e-9);
  const info = await run('info', out, '--json');
  assert.equal(JSON.parse(info.stdout).sensors[1].frames, 6);
});

test('recordings play as one room without being imported', async (t) => {
  const folder = scratchFolder(t);
  const sources = ['a', 'b'].map((name) => `mkv:${writeAzureKinect(folder, name, { frames: 3 })}`);
  const demo = await run('demo', '--headless', '--seconds', '4', '--port', '0', ...sources.flatMap((source) => ['--source', source]));
  assert.equal(demo.code, 0, demo.stderr);
  assert.match(demo.stdout, /received 2 of 2 sensors/);
  assert.match(demo.stderr, /joined by the time of day/);
});

test('info lists a recording of another program', async (t) => {
  const file = writeAzureKinect(scratchFolder(t), 'a', { frames: 3 });
  const info = await run('info', file, '--json');
  assert.equal(info.code, 0, info.stderr);
  const [sensor] = JSON.parse(info.stdout).sensors;
  assert.deepEqual([sensor.id, sensor.frames, sensor.depth_size], ['a', 3, [320, 288]]);
});

test('recordings of different days are one room only if they are told to begin together', async (t) => {
  const folder = scratchFolder(t);
  const files = [writeAzureKinect(folder, 'a', { frames: 2 }), writeAzureKinect(folder, 'b', { frames: 2, time: '2024-01-02T10:00:00Z' })];
  assertFailed(await run('import', ...files, join(folder, 'one')), 2, /begins 86\d{3}\.\d s after/);
  const together = await run('import', ...files, join(folder, 'two'), '--clock', 'start');
  assert.equal(together.code, 0, together.stderr);
  assert.match(together.stdout, /first frames/);
});

test('what cannot be imported gets one sentence and no rig', async (t) => {
  const folder = scratchFolder(t);
  const at = (name) => join(folder, name);
  writeFileSync(at('empty.mkv'), '');
  writeFileSync(at('text.bag'), 'no bag at all');
  writeFileSync(at('head.bag'), '#ROSBAG V2.0\n');
  writeFileSync(at('damaged.mkv'), Buffer.concat([Buffer.from('1A45DFA3FF', 'hex'), Buffer.alloc(5000, 0xff)]));
  const cut = writeAzureKinect(folder, 'cut', { frames: 2 });
  truncateSync(cut, 3000);
  for (const name of ['empty.mkv', 'text.bag', 'head.bag', 'damaged.mkv', 'cut.mkv', 'absent.mkv']) {
    assertFailed(await run('import', at(name), at('rig')), 1, new RegExp(name));
    assert.ok(!existsSync(at('rig')), name);
  }
  assert.equal((await run('import', at('empty.mkv'))).code, 2);
});

test('a recording that ends within a picture is read up to there', async (t) => {
  const folder = scratchFolder(t);
  const file = writeAzureKinect(folder, 'cut', { frames: 6 });
  truncateSync(file, readFileSync(file).length - 500_000);
  const result = await run('import', file, join(folder, 'rig'), '--json');
  assert.equal(result.code, 0, result.stderr);
  assert.match(result.stderr, /ends too early/);
  const [sensor] = JSON.parse(result.stdout).sensors;
  assert.ok(sensor.frames >= 2 && sensor.frames < 6, String(sensor.frames));
});

test('an interrupted import leaves a rig that plays', async (t) => {
  const folder = scratchFolder(t);
  const file = writeAzureKinect(folder, 'long', { frames: 120 });
  const importing = new Program(['import', file, join(folder, 'rig')]);
  while (!existsSync(join(folder, 'rig/long/depth/000002.png'))) await new Promise((done) => setTimeout(done, 5));
  importing.child.kill('SIGINT');
  assert.equal(await importing.ended, 1, importing.stderr);
  const info = await run('info', join(folder, 'rig'), '--json');
  assert.equal(info.code, 0, info.stderr);
});
