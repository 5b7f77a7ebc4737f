// SPDX-License-Identifier: Apache-2.0
// roomcast view: in an empty room it reports so and writes no picture; a window opens without a display, or reports why
// it cannot.
import { deepEqual, equal, match } from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { RoomClient, SendingSensor } from '../network/room_client.mjs';
import { startSensor } from '../network/rooms.mjs';
import { writeSmallRig } from '../network/small_rig.mjs';
import { Program, assertFailed, run, scratchFolder, startHub } from './program.mjs';

function viewInto(folder, hub) {
  return ['view', '--hub', hub.url, '--headless', '--size', '64,48', '--png', join(folder, 'room.png')];
}

test('room_without_sensors_is_not_drawn', async (t) => {
  const hub = await startHub(t);
  const folder = scratchFolder(t);
  assertFailed(await run(...viewInto(folder, hub)), 1, /no sensor has joined this room/);
  deepEqual(readdirSync(folder), []);
});

test('room_without_its_sensors_is_not_drawn', async (t) => {
  const hub = await startHub(t);
  const sensor = await startSensor(t, hub.url, writeSmallRig(scratchFolder(t)), 0);
  const folder = scratchFolder(t);
  const viewer = new Program([...viewInto(folder, hub), '--seconds', '3']);
  t.after(() => viewer.stop('SIGKILL'));
  const witness = await RoomClient.join(t, hub.url);
  await witness.until('both viewers', () => witness.rosters.at(-1)?.viewers === 2);
  await witness.moreSets(5);
  await sensor.stop();
  const code = await viewer.ended;
  assertFailed({ code, stderr: viewer.stderr }, 1, /all sensors have left this room/);
  deepEqual(readdirSync(folder), []);
});

test('a_sensor_that_sends_garbage_keeps_no_other_from_the_picture', { timeout: 60_000 }, async (t) => {
  const hub = await startHub(t);
  await startSensor(t, hub.url, writeSmallRig(scratchFolder(t)), 0);
  await SendingSensor.start(t, hub.url, { name: 'garbage', fps: 10 });
  const folder = scratchFolder(t);
  const { code, stderr } = await run(...viewInto(folder, hub));
  equal(code, 0, stderr);
  match(stderr, /^roomcast view: no picture came from garbage within \d+ s; the others are drawn$/m);
  deepEqual(readdirSync(folder), ['room.png']);
});

/** A shell in which this library cannot be loaded, where root may mount something in its place. */
function without(library) {
  const hide = `file=$(ldconfig -p | sed -n 's/.*${library} .*=> //p' | head -n 1); mount --bind /dev/null "$(readlink -f "$file")"`;
  return ['unshare', '--mount', 'sh', '-c', `${hide} && exec "$0" "$@"`];
}
const canHide = spawnSync('unshare', ['--mount', 'true']).status === 0;

test('without_the_library_of_egl_there_is_a_sentence', { skip: canHide ? false : 'hiding a library takes root' }, async (t) => {
  const hub = await startHub(t);
  const folder = scratchFolder(t);
  const rig = writeSmallRig(folder);
  await startSensor(t, hub.url, rig, 0);
  const film = ['export', rig, '--format', 'video', '--to', '0.2', '--size', '64,48', '--out', join(folder, 'film')];
  for (const args of [viewInto(folder, hub), ['view', '--hub', hub.url], film]) {
    assertFailed(await run(...args, { through: without('libEGL.so.1') }), 1, /libEGL\.so\.1 cannot be loaded here; apt install libegl1/);
  }
});

test('window_opens_and_its_last_picture_is_kept', async (t) => {
  const hub = await startHub(t);
  const folder = scratchFolder(t);
  const picture = join(folder, 'window.png');
  const viewer = new Program(
    ['view', '--hub', hub.url, '--size', '320,240', '--mode', 'mesh', '--seconds', '1', '--last-picture', picture],
    { through: ['env', 'SDL_VIDEODRIVER=offscreen'] },
  );
  t.after(() => viewer.stop('SIGKILL'));
  equal(await viewer.ended, 0, viewer.stderr);
  equal(viewer.stderr, '', 'also where there is no sound card');
  deepEqual(readdirSync(folder), ['window.png']);
});

test('sound_files_that_cannot_be_used_are_refused_before_a_window_opens', async (t) => {
  const hub = await startHub(t);
  const folder = scratchFolder(t);
  const file = join(folder, 'text.wav');
  writeFileSync(file, 'no sound');
  const view = (...options) => run('view', '--hub', hub.url, ...options, { through: ['env', 'SDL_VIDEODRIVER=offscreen'] });
  assertFailed(await view('--microphone', file), 1, /text\.wav is no WAV file/);
  assertFailed(await view('--microphone', join(folder, 'none.wav')), 1, /none\.wav/);
  assertFailed(await view('--speaker', file), 1, /there is .*text\.wav already/);
});

test('window_closes_on_sigterm', async (t) => {
  const hub = await startHub(t);
  const witness = await RoomClient.join(t, hub.url);
  const viewer = new Program(['view', '--hub', hub.url, '--size', '64,48'], {
    through: ['env', 'SDL_VIDEODRIVER=offscreen'],
  });
  t.after(() => viewer.stop('SIGKILL'));
  await witness.until('both viewers', () => witness.rosters.at(-1)?.viewers === 2);
  equal(await viewer.stop('SIGTERM'), 0, viewer.stderr);
});

test('window_without_a_display_is_refused_in_a_sentence', async (t) => {
  const hub = await startHub(t);
  const viewer = new Program(['view', '--hub', hub.url], {
    through: ['env', '-u', 'DISPLAY', 'SDL_VIDEODRIVER=x11'],
  });
  const code = await viewer.ended;
  assertFailed({ code, stderr: viewer.stderr }, 1, /no window can be opened here.*--headless --png/);
});

test('window_says_on_stderr_what_is_wrong_with_the_named_headset_software', async (t) => {
  const hub = await startHub(t);
  const viewer = new Program(['view', '--hub', hub.url, '--size', '64,48', '--seconds', '1', '--vr'], {
    through: ['env', 'SDL_VIDEODRIVER=offscreen', 'XR_RUNTIME_JSON=/nonexistent.json'],
  });
  t.after(() => viewer.stop('SIGKILL'));
  equal(await viewer.ended, 0, viewer.stderr);
  match(viewer.stderr, /^roomcast view: The room is shown on the desktop only: XR_RUNTIME_JSON is "\/nonexistent.json"/m);
});

test('headless_without_a_file_is_wrong_usage', async () => {
  assertFailed(await run('view', '--hub', 'ws://127.0.0.1:1', '--headless'), 2, /--png/);
});
