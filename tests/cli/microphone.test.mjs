// SPDX-License-Identifier: Apache-2.0
// A sensor's microphone, for which a WAV file stands: who listens hears its tone, a recording has it, an admin mutes it; and
// microphones that are not there are refused with a sentence.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { writeSmallRig } from '../network/small_rig.mjs';
import { writeWav } from '../wav_file.mjs';
import { Program, assertFailed, run, scratchFolder, startHub } from './program.mjs';

const cleanups = [];
const forAllTests = { after: (cleanup) => cleanups.push(cleanup) };
after(() => cleanups.forEach((cleanup) => cleanup()));

const rate_hz = 48_000;
const tone_hz = 600;
let folder;
let rig;
let tone;

/** One channel of 16 bits, as loud at each sample as `loudness` says. */
function writeTone(path, loudness = () => 12_000) {
  const length = rate_hz; // a second, a whole number of periods
  const samples = Array.from({ length }, (_, i) => loudness(i) * Math.sin((2 * Math.PI * tone_hz * i) / rate_hz));
  writeWav(path, samples, rate_hz);
}

/** Of a sine of this frequency in a WAV file that roomcast wrote, in the middle second of one channel. */
function amplitude(path, frequency_hz, channel = 0, channels = 1) {
  const bytes = readFileSync(path);
  const count = (bytes.length - 44) / 2 / channels;
  const from = Math.max(0, Math.floor(count / 2) - rate_hz / 2);
  let [sine, cosine] = [0, 0];
  for (let i = 0; i < rate_hz; ++i) {
    const value = bytes.readInt16LE(44 + 2 * ((from + i) * channels + channel));
    sine += value * Math.sin((2 * Math.PI * frequency_hz * i) / rate_hz);
    cosine += value * Math.cos((2 * Math.PI * frequency_hz * i) / rate_hz);
  }
  return (2 * Math.hypot(sine, cosine)) / rate_hz;
}

function startSensor(t, hub, ...options) {
  const sensor = new Program(['sensor', '--source', `rig:${rig}#s0`, '--hub', hub.url, '--audio', `wav:${tone}`, ...options]);
  t.after(() => sensor.stop('SIGKILL'));
  return sensor;
}

before(() => {
  folder = scratchFolder(forAllTests);
  rig = writeSmallRig(folder);
  tone = join(folder, 'tone.wav');
  writeTone(tone);
});

test('the_sound_is_recorded_with_the_room_and_exported_under_the_sensors_name', async (t) => {
  const hub = await startHub(t);
  const sensor = startSensor(t, hub);
  await sensor.prints(/joined as "s0"/);
  const file = join(folder, 'room.mcap');
  const recorded = await run('record', file, '--hub', hub.url, '--seconds', '4');
  assert.equal(recorded.code, 0, recorded.stderr);
  const exported = await run('export', file, '--format', 'wav', '--out', join(folder, 'sound'), '--per-person');
  assert.equal(exported.code, 0, exported.stderr);
  const loudness = amplitude(join(folder, 'sound', 's0.wav'), tone_hz);
  assert.ok(loudness > 9_000 && loudness < 14_000, `the tone of 12000 has an amplitude of ${loudness}`);
  assert.ok(amplitude(join(folder, 'sound', 's0.wav'), 1000) < 300);
  assert.match(readFileSync(join(folder, 'sound', 'voices.csv'), 'utf8'), /s0\.wav.*s0/);
});

test('who_views_the_room_at_a_desktop_hears_it', async (t) => {
  const hub = await startHub(t);
  await startSensor(t, hub).prints(/joined as "s0"/);
  const heard = join(folder, 'heard.wav');
  const window = ['--size', '64,48', '--mode', 'points', '--seconds', '4', '--at', '0,1.6,2'];
  const viewed = await run('view', '--hub', hub.url, ...window, '--microphone', 'none', '--speaker', heard, {
    through: ['env', 'SDL_VIDEODRIVER=offscreen', 'SDL_AUDIODRIVER=dummy'],
  });
  assert.equal(viewed.code, 0, viewed.stderr);
  const loudness = Math.max(amplitude(heard, tone_hz, 0, 2), amplitude(heard, tone_hz, 1, 2));
  assert.ok(loudness > 1_000, `the tone has an amplitude of ${loudness}`);
});

test('what_somebody_says_at_a_desktop_is_heard_and_recorded', async (t) => {
  const hub = await startHub(t);
  const sound = join(folder, 'words.wav');
  writeTone(sound, (i) => (i % 24_000 < 12_000 ? 12_000 : 0)); // like syllables: noise that goes on is removed
  const viewer = new Program(
    ['view', '--hub', hub.url, '--name', 'Ada', '--size', '64,48', '--speak', '--microphone', sound, '--speaker', 'none'],
    { through: ['env', 'SDL_VIDEODRIVER=offscreen', 'SDL_AUDIODRIVER=dummy'] },
  );
  t.after(() => viewer.stop('SIGKILL'));
  const file = join(folder, 'said.mcap');
  const recorded = await run('record', file, '--hub', hub.url, '--seconds', '5');
  assert.equal(recorded.code, 0, recorded.stderr);
  assert.equal(await viewer.stop(), 0, viewer.stderr);
  const exported = await run('export', file, '--format', 'wav', '--out', join(folder, 'said'), '--per-person');
  assert.equal(exported.code, 0, exported.stderr);
  assert.ok(amplitude(join(folder, 'said', 'Ada.wav'), tone_hz) > 1_500);
});

test('the_status_says_how_loud_it_is_and_that_it_is_sent', async (t) => {
  const hub = await startHub(t);
  const sensor = startSensor(t, hub, '--json', '--always');
  const line = await sensor.prints(/^\{.*"packets_sent":[1-9].*\}$/m);
  const { microphone } = JSON.parse(line[0]);
  assert.equal(microphone.connected, true);
  assert.equal(microphone.permitted, true);
  assert.ok(Math.abs(microphone.loudness - 12_000 / 32_768 / Math.SQRT2) < 0.02, line[0]);
});

test('a_microphone_that_is_not_there_is_refused_with_a_sentence', async (t) => {
  const hub = await startHub(t);
  const sensor = (audio) => run('sensor', '--source', `rig:${rig}#s0`, '--hub', hub.url, '--audio', audio);
  const noSound = join(folder, 'text.wav');
  writeFileSync(noSound, 'this is no sound');
  assertFailed(await sensor('nonsense'), 2, /"nonsense" is no microphone: give default, alsa:DEVICE/);
  assertFailed(await sensor(`wav:${join(folder, 'none.wav')}`), 1, /none\.wav/);
  assertFailed(await sensor(noSound), 1, /text\.wav is no WAV file/);
  assertFailed(await sensor('alsa:there_is_no_such_device'), 1, /there is no microphone "there_is_no_such_device"|built without ALSA/);
});

test('a_room_where_only_admins_speak_gets_pictures_without_sound', async (t) => {
  const config = join(folder, 'silent.toml');
  writeFileSync(config, '[[room]]\nname = "lab"\nspeak = "admin"\n');
  const hub = await startHub(t, '--config', config);
  const sensor = startSensor(t, hub, '--always', '--json');
  await sensor.prints(/this room does not let the sensor's microphone be heard/);
  const line = await sensor.prints(/^\{.*"frames_sent":[1-9].*\}$/m);
  assert.deepEqual([JSON.parse(line[0]).microphone.permitted, JSON.parse(line[0]).microphone.packets_sent], [false, 0]);
});

test('an_admin_mutes_a_microphone_for_all', async (t) => {
  const data = scratchFolder(t);
  const hub = await startHub(t, '--data', data);
  const token = (await run('token', '--data', data, '--role', 'admin')).stdout.trim().split('\n').at(-1);
  await startSensor(t, hub, '--always').prints(/joined as "s0"/);
  const ask = async (method, path, body) => {
    const answer = await fetch(`http://127.0.0.1:${hub.port}/api/v1/rooms/room${path}`, {
      method,
      headers: { Authorization: `Bearer ${token}` },
      body: body && JSON.stringify(body),
    });
    assert.equal(answer.status, 200, await answer.clone().text());
    return answer.json();
  };
  const isHeard = async (wanted) => {
    for (let tries = 0; tries < 100; ++tries) {
      const [sensor] = (await ask('GET', '/sensors')).sensors;
      if (sensor.speaks === wanted) return sensor;
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
    return assert.fail(`the microphone is ${wanted ? 'not ' : ''}heard`);
  };
  assert.equal((await isHeard(true)).has_microphone, true);
  assert.equal((await ask('PATCH', '/sensors/s0', { muted: true })).muted, true);
  await isHeard(false);
  await ask('PATCH', '/sensors/s0', { muted: false });
  await isHeard(true);
});

test('devices_lists_microphones', async () => {
  const { code, stdout } = await run('devices', '--json');
  assert.equal(code, 0);
  for (const { source, description } of JSON.parse(stdout).microphones) {
    assert.match(source, /^alsa:/);
    assert.ok(description.length > 0);
  }
});
