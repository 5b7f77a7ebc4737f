// SPDX-License-Identifier: Apache-2.0
// Recording and playing rooms with real programs. The MCAP format's own library reads the files.
import assert from 'node:assert/strict';
import { chmodSync, copyFileSync, mkdirSync, readFileSync, statSync, truncateSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { McapWriter, isFrame, parseFrame, readFromStart, readIndexed } from './mcap.mjs';
import { writeSmallRig } from '../network/small_rig.mjs';
import { Program, assertFailed, assertServes, run, scratchFolder, startHub } from './program.mjs';

const cleanups = [];
const forAllTests = { after: (cleanup) => cleanups.push(cleanup) };
after(() => cleanups.forEach((cleanup) => cleanup()));

/** A rig of two sensors, and a hub to which both send it again and again. */
let rig;
/** A complete recording of 3 s of that room. */
let recording;

async function startRoom(t) {
  const hub = await startHub(t);
  for (const sensor of ['s0', 's1']) {
    const program = new Program(['sensor', '--source', `rig:${rig}#${sensor}`, '--hub', hub.url, '--verbose']);
    t.after(() => program.stop('SIGKILL'));
    await program.prints(/joined/);
  }
  return hub;
}

function startRecorder(t, file, hub, ...options) {
  const recorder = new Program(['record', file, '--hub', hub.url, ...options]);
  t.after(() => recorder.stop('SIGKILL'));
  return recorder;
}

async function until(what, condition) {
  for (let tries = 0; tries < 200; ++tries) {
    if (await condition()) return;
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  assert.fail(`waited in vain for ${what}`);
}

function sizeOf(file) {
  try {
    return statSync(file).size;
  } catch {
    return 0;
  }
}

before(async () => {
  rig = writeSmallRig(scratchFolder(forAllTests));
  const hub = await startRoom(forAllTests);
  recording = join(scratchFolder(forAllTests), 'room.mcap');
  const recorded = await run('record', recording, '--hub', hub.url, '--seconds', '3', '--json');
  assert.equal(recorded.code, 0, recorded.stderr);
  const [room] = JSON.parse(recorded.stdout).rooms;
  assert.ok(room.frames > 30, `only ${room.frames} frames`);
  assert.ok(room.file_bytes > room.frame_bytes);
});

test('the_official_reader_finds_every_frame_through_the_index', async () => {
  const { reader, messages, metadata } = await readIndexed(recording);
  assert.deepEqual(metadata.map(({ name }) => name), ['roomcast']);
  const topics = [...reader.channelsById.values()].map(({ topic }) => topic).sort();
  assert.deepEqual(topics.filter((topic) => topic !== '/room/viewer_poses'),
    ['/room/clock', '/room/roster', '/sensor/s0/frame', '/sensor/s1/frame']);
  const frames = messages.filter(isFrame);
  assert.ok(frames.length > 30);
  const [{ data }] = messages.filter(({ topic }) => topic === '/room/clock');
  const clock = JSON.parse(Buffer.from(data).toString());
  for (const frame of frames) {
    const header = parseFrame(frame.data);
    assert.equal(header.magic, 0x4352);
    assert.equal(frame.publishTime, header.captureNs + BigInt(clock.unix_minus_room_ns));
  }
});

test('frames_that_were_played_and_recorded_again_are_the_same_bit_for_bit', async (t) => {
  const hub = await startHub(t);
  const again = join(scratchFolder(t), 'again.mcap');
  const recorder = startRecorder(t, again, hub, '--verbose');
  await until('a recorder', () => sizeOf(again) > 0);
  const played = await run('play', recording, '--hub', hub.url, '--json');
  assert.equal(played.code, 0, played.stderr);
  await recorder.stop('SIGINT');
  const payloads = async (file, sensor) =>
    (await readIndexed(file)).messages
      .filter(({ topic }) => topic === `/sensor/${sensor}/frame`)
      .map(({ data }) => parseFrame(data));
  for (const sensor of ['s0', 's1']) {
    const [first, second] = [await payloads(recording, sensor), await payloads(again, sensor)];
    // Frames before the first key frame cannot be shown and are not played.
    const begin = first.findIndex(({ key }) => key);
    const sent = first.slice(begin);
    assert.equal(second.length, sent.length);
    sent.forEach((frame, i) => assert.ok(frame.payload.equals(second[i].payload), `${sensor}, frame ${i}`));
  }
});

test('a_recording_is_exported_and_not_imported', async (t) => {
  assertFailed(await run('import', recording, join(scratchFolder(t), 'rig')), 1, /is a recording of roomcast itself; make a rig of it by roomcast export --format rig/);
});

test('a_recorder_that_is_killed_loses_no_more_than_the_last_second', async (t) => {
  const hub = await startRoom(t);
  const file = join(scratchFolder(t), 'killed.mcap');
  const recorder = startRecorder(t, file, hub);
  await until('chunks on disk', () => sizeOf(file) > 12_000);
  const killedAt = BigInt(Date.now()) * 1_000_000n;
  await recorder.stop('SIGKILL');
  const { messages, whole } = await readFromStart(file);
  assert.equal(whole, false);
  const last = messages.filter(isFrame).at(-1);
  const lostNs = killedAt - last.logTime;
  assert.ok(lostNs < 1_000_000_000n, `${Number(lostNs) / 1e9} s are lost`);
  const { code, stdout, stderr } = await run('info', file, '--json');
  assert.equal(code, 0, stderr);
  assert.ok(JSON.parse(stdout).sensors.every(({ frames }) => frames > 0));
});

test('a_full_disk_ends_the_recording_with_a_sentence_and_the_room_goes_on', async (t) => {
  const hub = await startRoom(t);
  const file = join(scratchFolder(t), 'full.mcap');
  // A limit on the file size simulates a full disk.
  const recorder = new Program(['record', file, '--hub', hub.url], { through: ['prlimit', '--fsize=12000'] });
  t.after(() => recorder.stop('SIGKILL'));
  const code = await recorder.ended;
  assertFailed({ code, stderr: recorder.stderr }, 1, /cannot write to .*full\.mcap/);
  assert.ok(sizeOf(file) <= 12_000);
  await assertServes(t, hub);
  const info = await run('info', file, '--json');
  assert.equal(info.code, 0, info.stderr);
});

test('files_of_the_official_writer_are_read', async (t) => {
  const { reader, messages, metadata } = await readIndexed(recording);
  const parts = [];
  let position = 0n;
  const writer = new McapWriter({
    writable: {
      position: () => position,
      write: async (bytes) => {
        parts.push(Buffer.from(bytes));
        position += BigInt(bytes.length);
      },
    },
    chunkSize: 5_000,
  });
  await writer.start({ profile: '', library: 'test' });
  for (const record of metadata) await writer.addMetadata(record);
  const schemas = new Map();
  for (const schema of reader.schemasById.values()) schemas.set(schema.id, await writer.registerSchema(schema));
  const channels = new Map();
  for (const channel of reader.channelsById.values()) {
    channels.set(channel.id, await writer.registerChannel({ ...channel, schemaId: schemas.get(channel.schemaId) ?? 0 }));
  }
  for (const message of messages) await writer.addMessage({ ...message, channelId: channels.get(message.channelId) });
  await writer.end();
  const file = join(scratchFolder(t), 'official.mcap');
  writeFileSync(file, Buffer.concat(parts));
  const [theirs, ours] = [await run('info', file, '--json'), await run('info', recording, '--json')];
  assert.equal(theirs.code, 0, theirs.stderr);
  assert.deepEqual(JSON.parse(theirs.stdout).sensors, JSON.parse(ours.stdout).sensors);
});

test('a_truncated_file_is_read_up_to_there', async (t) => {
  const file = join(scratchFolder(t), 'cut.mcap');
  copyFileSync(recording, file);
  const { reader } = await readIndexed(recording);
  const chunks = reader.chunkIndexes.map(({ chunkStartOffset }) => Number(chunkStartOffset)).sort((a, b) => a - b);
  assert.ok(chunks.length > 2, `${chunks.length} chunks`);
  truncateSync(file, chunks[chunks.length >> 1] + 10);
  const [cut, whole] = [await run('info', file, '--json'), await run('info', recording, '--json')];
  assert.equal(cut.code, 0, cut.stderr);
  const frames = ({ stdout }) => JSON.parse(stdout).sensors[0].frames;
  assert.ok(frames(cut) > 0 && frames(cut) < frames(whole));
});

test('a_recording_is_a_source', async (t) => {
  const hub = await startHub(t);
  for (const sensor of ['s0', 's1']) {
    const program = new Program(['sensor', '--source', `mcap:${recording}#${sensor}`, '--hub', hub.url, '--verbose']);
    t.after(() => program.stop('SIGKILL'));
    await program.prints(/joined/);
  }
  await assertServes(t, hub);
});

test('a_recording_plays_on_a_hub_of_its_own', async (t) => {
  const player = new Program(['play', recording, '--port', '0', '--loop', '--speed', '4']);
  t.after(() => player.stop('SIGKILL'));
  const [, port] = await player.prints(/127\.0\.0\.1:(\d+)/);
  await assertServes(t, { url: `ws://127.0.0.1:${port}` });
  assert.equal(await player.stop('SIGINT'), 0);
});

/** The recording up to its first chunk: what is on disk until a list of sensors has come. */
function beginOfRecording() {
  const bytes = readFileSync(recording);
  const magicBytes = 8, recordHeaderBytes = 9, chunk = 0x06;
  let at = magicBytes;
  while (bytes[at] !== chunk) at += recordHeaderBytes + Number(bytes.readBigUInt64LE(at + 1));
  return bytes.subarray(0, at);
}

test('a_recording_that_ended_before_its_first_list_of_sensors_is_described_as_empty', async (t) => {
  const folder = scratchFolder(t);
  const file = join(folder, 'brief.mcap');
  writeFileSync(file, beginOfRecording());
  const { code, stdout, stderr } = await run('info', file);
  assert.equal(code, 0, stderr);
  assert.match(stdout, /^room "room": 0\.00 s\nno sensors: .* before the first frame/);
  const report = JSON.parse((await run('info', file, '--json')).stdout);
  assert.deepEqual(report, { recording: file, room: 'room', begin: '', seconds: 0, sensors: [] });
  const others = [['play', file], ['export', file, '--out', join(folder, 'out')], ['info', file, '--thumbnails', join(folder, 'a.png')]];
  for (const args of others) {
    const { code, stderr } = await run(...args);
    assert.equal(code, 1, `${args[0]}: ${stderr}`);
    assert.match(stderr.trimEnd().split('\n').at(-1), /no frame|no sensor/);
  }
});

test('info_tells_when_and_how_long_a_room_was_recorded', async () => {
  const { room, begin, seconds } = JSON.parse((await run('info', recording, '--json')).stdout);
  assert.equal(room, 'room');
  assert.ok(Math.abs(Date.parse(begin) - statSync(recording).mtimeMs) < 60_000, begin);
  assert.ok(seconds > 2 && seconds < 4, `${seconds}`);
  assert.match((await run('info', recording)).stdout, /^room "room": \d\.\d\d s, recorded from \d{4}-\d\d-\d\dT/);
});

test('exports_keep_the_date_of_a_recording', async (t) => {
  const folder = scratchFolder(t);
  const begin_s = Date.parse(JSON.parse((await run('info', recording, '--json')).stdout).begin) / 1000;
  for (const format of ['tum', 'foxglove']) {
    const { code, stderr } = await run('export', recording, '--format', format, '--out', join(folder, format));
    assert.equal(code, 0, stderr);
  }
  const { messages } = await readIndexed(join(folder, 'foxglove/room.mcap'));
  const inFolder = (name) => Number(/^\d+\.\d+/m.exec(readFileSync(join(folder, 'tum/s0', name), 'utf8'))[0]);
  const dates_s = [inFolder('depth.txt'), inFolder('groundtruth.txt'), Number(messages[0].logTime) / 1e9];
  for (const date_s of dates_s) assert.ok(Math.abs(date_s - begin_s) < 3, `${date_s}, not ${begin_s}`);
  // Each depth picture has the same capture time in both, to the microsecond that TUM lists can hold.
  const inTum = readFileSync(join(folder, 'tum/s0/depth.txt'), 'utf8').match(/^\d+\.\d+/gm).map(Number);
  const inFoxglove = messages.filter(({ topic }) => topic === '/s0/depth').map(({ logTime }) => Number(logTime) / 1e9);
  assert.equal(inFoxglove.length, inTum.length);
  inTum.forEach((date_s, i) => assert.ok(Math.abs(date_s - inFoxglove[i]) < 2e-6, `${date_s}, not ${inFoxglove[i]}`));
  const again = await run('info', join(folder, 'tum'), '--json');
  assert.equal(again.code, 0, again.stderr);
});

test('a_folder_for_recordings_is_closed_to_other_users', async (t) => {
  const folder = scratchFolder(t);
  const config = join(folder, 'roomcast.toml');
  writeFileSync(config, '[[room]]\nname = "a"\n[[room]]\nname = "b"\n');
  const hub = await startHub(t, '--config', config);
  const record = (out) => run('record', out, '--hub', hub.url, '--room', 'a', '--room', 'b', '--seconds', '0.5');
  const modeOf = (path) => statSync(path).mode & 0o777;
  const [open, made] = [join(folder, 'open'), join(folder, 'made')];
  mkdirSync(open);
  chmodSync(open, 0o755);
  const first = await record(open);
  assert.equal(first.code, 0, first.stderr);
  assert.match(first.stderr, /other users .* could enter .*open; it is closed to them now/);
  const second = await record(made);
  assert.equal(second.code, 0, second.stderr);
  assert.doesNotMatch(second.stderr, /other users/);
  assert.deepEqual([open, made].map(modeOf), [0o700, 0o700]);
  assert.equal(modeOf(join(made, 'a.mcap')), 0o600);
});

test('other_files_are_refused_with_a_reason', async (t) => {
  const file = join(scratchFolder(t), 'other.mcap');
  writeFileSync(file, readFileSync(recording).subarray(100));
  assertFailed(await run('info', file), 1, /not an MCAP file/);
  assertFailed(await run('play', file), 1, /not an MCAP file/);
  assertFailed(await run('play', join(rig, 'nothing')), 1, /cannot open/);
  assertFailed(await run('record', recording, '--hub', 'ws://127.0.0.1:1'), 1, /127\.0\.0\.1/);
});
