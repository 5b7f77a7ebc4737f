// SPDX-License-Identifier: Apache-2.0
// What a person says while the room is recorded: everybody sees that it is recorded, the page that plays the recording is heard
// to play it, in step with timeline and pause, and it is exported as a sound file, at the time at which it was said.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';
import { seriousFindings } from './accessibility.mjs';
import { openPage } from './browser.mjs';
import { findChirp, period_s, rate_hz, writeChirp } from './chirp.mjs';
import { chirpTimes, isSilent, listenIn, loudnessOf } from './listening.mjs';
import { oneSensorRoom } from './one_sensor_room.mjs';
import { run } from './programs.mjs';
import { slow, stateOf, until, untilAllShown } from './waiting.mjs';

const folder = mkdtempSync(join(tmpdir(), 'roomcast-said-'));
const sound = join(folder, 'chirp.wav');
writeChirp(sound);
const microphone = ['--use-fake-device-for-media-stream', `--use-file-for-fake-audio-capture=${sound}`, '--use-fake-ui-for-media-stream'];
const room = oneSensorRoom('said', { more: microphone });
after(() => rmSync(folder, { recursive: true, force: true }));

const view = 'mode=points&at=0.2,1.7,2.6&look=0,0.9,-1';
const name = 'roomcast-room-0001';
const file = () => join(room.data, 'recordings', `${name}.mcap`);
const headers = () => ({ Authorization: `Bearer ${room.token}` });
const ask = (method, path, body) =>
  fetch(`${room.hub.page}api/v1/rooms/room${path}`, { method, headers: headers(), body: body && JSON.stringify(body) });
const recording = async () => (await ask('GET', '/recording')).json();
const note = (page) => page.locator('#panel .sound p').innerText();
const figures = (page) => page.evaluate(() => window.roomcast.playback());
const button = (page, text) => page.getByRole('button', { name: text, exact: true });

/** Plays from the second that is given, with sound. */
async function play(from_s) {
  const page = await openPage(room.browser.context, `${room.hub.page}?panel=1&${view}&room=room&play=${name}&from=${from_s}#token=${room.token}`);
  await untilAllShown(page, 1);
  await until('its sound is loaded', () => page.evaluate(() => window.roomcast.voice()), (voice) => voice?.speakers.length > 0);
  await page.locator('#room').click();
  await until('it sounds', () => page.evaluate(() => window.roomcast.voice()), ({ context }) => context === 'running');
  return page;
}

/** Where chirps begin in a WAV file, in seconds. */
function chirpsIn(path) {
  const bytes = readFileSync(path);
  const samples = Float32Array.from({ length: (bytes.length - 44) / 2 }, (_, i) => bytes.readInt16LE(44 + 2 * i) / 32768);
  const found = [];
  const stretch = period_s * rate_hz;
  for (let at = 0; at + stretch <= samples.length; at += stretch / 2) {
    const { at: begin, likeness } = findChirp(samples.subarray(at, at + stretch));
    const time_s = (at + begin) / rate_hz;
    if (likeness > 0.8 && found.every((other) => Math.abs(other - time_s) > 0.1)) found.push(time_s);
  }
  return found.sort((a, b) => a - b);
}

describe('what is said in a room that is recorded', () => {
  let ada, said;

  before(async () => {
    await room.browser.context.addInitScript(listenIn);
    ada = await openPage(room.browser.context, `${room.hub.page}?panel=1&${view}&name=Ada`);
    await untilAllShown(ada, 1);
    await ada.getByRole('button', { name: 'Microphone' }).click();
    await until('she is heard', () => note(ada), (text) => /hear you/.test(text));
  }, slow);

  test('people see that it is recorded, with voices', slow, async () => {
    assert.doesNotMatch(await note(ada), /recorded/);
    assert.equal((await ask('POST', '/recording')).status, 201);
    await until('the microphone says so', () => note(ada), (text) => /is being recorded, with what is said/.test(text));
    await ada.locator('#panel .people li', { hasText: 'records, with voices' }).waitFor();
    assert.deepEqual(await seriousFindings(ada), []);
    said = await chirpTimes(ada, 'mouth', 6);
    await ask('DELETE', '/recording');
    await until('it has ended', recording, ({ state }) => state === 'off');
    await until('the microphone says that, too', () => note(ada), (text) => !/recorded/.test(text));
    await ada.getByRole('button', { name: 'Microphone' }).click();
  });

  test('is exported when it was said, for each person', slow, async (t) => {
    const out = join(folder, 'voices');
    const report = JSON.parse((await run('export', file(), '--format', 'wav', '--out', out, '--per-person', '--json')).join('\n'));
    assert.deepEqual(report.people.map(({ person }) => person), ['Ada']);
    assert.ok(report.people[0].speech_s > 1, JSON.stringify(report.people));
    for (const path of ['voices.wav', 'Ada.wav']) {
      const found = chirpsIn(join(out, path));
      assert.ok(found.length >= 4, `${path}: ${found}`);
      const off_ms = found.flatMap((time_s) => {
        const when_ms = 1000 * (report.began_at + time_s);
        const nearest = said.map(({ time_ms }) => time_ms - when_ms).sort((a, b) => Math.abs(a) - Math.abs(b))[0];
        return Math.abs(nearest) < 500 ? [nearest] : [];
      });
      const steps_ms = found.slice(1).map((time_s, i) => (1000 * (time_s - found[i])) % (1000 * period_s));
      t.diagnostic(`${path}: microphone minus file ${off_ms.map((ms) => ms.toFixed(1))} ms; steps off by ${steps_ms.map((ms) => ms.toFixed(2))} ms`);
      for (const ms of steps_ms) assert.ok(Math.min(ms, 1000 * period_s - ms) < 20, `${steps_ms}`);
      assert.ok(off_ms.length >= 3 && off_ms.every((ms) => Math.abs(ms) < 100), `${off_ms}`);
    }
  });

  test('is in a film, where it belongs', slow, async (t) => {
    const out = join(folder, 'film');
    await run('export', file(), '--format', 'video', '--out', out, '--size', '160,120', '--fps', '5');
    const wav = join(folder, 'film.wav');
    execFileSync('ffmpeg', ['-loglevel', 'error', '-i', join(out, 'film.mp4'), '-ac', '1', '-ar', String(rate_hz), '-bitexact', wav]);
    const inFilm = chirpsIn(wav);
    const alone = chirpsIn(join(folder, 'voices', 'Ada.wav'));
    const shifts = inFilm.map((time_s) => Math.min(...alone.map((other) => Math.abs(time_s - other))));
    t.diagnostic(`chirps in the film at ${inFilm.map((s) => s.toFixed(3))} s, in the sound file at ${alone.map((s) => s.toFixed(3))} s`);
    assert.ok(inFilm.length >= 3 && shifts.every((s) => s < 0.5), `${inFilm} ${alone}`);
    assert.deepEqual(readdirSync(out), ['film.mp4']);
  });

  test('is heard when it is played, and not while it is paused', slow, async () => {
    const page = await play(0.5);
    await page.getByLabel('Voices').waitFor();
    const played = await chirpTimes(page, 'ear', 2);
    assert.ok(played.length >= 2, 'chirps are heard');
    const { viewers } = await stateOf(page);
    const { id } = viewers.find((viewer) => viewer.name === 'Ada');
    assert.deepEqual((await page.evaluate(() => window.roomcast.voice())).speakers.map((speaker) => speaker.id), [id]);
    await button(page, 'Pause').click();
    await delay(1200); // the ear keeps the last 0.7 s
    assert.equal(await loudnessOf(page), 0, 'silent');
    assert.ok(await isSilent(page), 'and stays so');
    await button(page, 'Play').click();
    const { position_s, length_s } = await figures(page);
    if (position_s > length_s - 4) await page.getByRole('slider', { name: 'Position in the recording' }).press('Home');
    assert.ok((await chirpTimes(page, 'ear', 1)).length > 0, 'and again');
    assert.deepEqual(page.complaints, []);
    await page.close();
  });

  test('is in step with the timeline after seeking back and forth', slow, async (t) => {
    const page = await play(0.5);
    const line = page.getByRole('slider', { name: 'Position in the recording' });
    const export_s = chirpsIn(join(folder, 'voices', 'Ada.wav'));
    const off_ms = [];
    for (const key of ['Home', 'ArrowRight', 'Home']) {
      await line.press(key);
      await delay(1000); // the ear keeps the last 0.7 s, from before as well
      const [chirp] = await chirpTimes(page, 'ear', 1);
      const { now_ms, position_s } = await page.evaluate(() => ({
        now_ms: performance.timeOrigin + performance.now(),
        position_s: window.roomcast.playback().position_s,
      }));
      const at_s = position_s - (now_ms - chirp.time_ms) / 1000;
      off_ms.push(1000 * Math.min(...export_s.map((time_s) => Math.abs(time_s - at_s))));
    }
    t.diagnostic(`heard off the timeline by ${off_ms.map((ms) => ms.toFixed(0))} ms; the position is told every 200 ms`);
    assert.ok(off_ms.every((ms) => ms < 500), `${off_ms}`);
    await page.close();
  });

  test('is not heard at another speed, and the page says so', slow, async () => {
    const page = await play(0);
    await page.getByLabel('Speed').selectOption('0.5');
    await page.getByText('Voices are heard at speed 1 ×.').waitFor();
    await delay(1200);
    assert.equal(await loudnessOf(page), 0);
    assert.ok(await isSilent(page));
    await page.getByLabel('Speed').selectOption('1');
    await page.getByLabel('Voices').uncheck();
    await delay(1200);
    assert.ok((await loudnessOf(page)) < 0.001);
    assert.ok(await isSilent(page));
    assert.deepEqual(await seriousFindings(page), []);
    await page.close();
  });
});

describe('a room whose voices are not recorded', () => {
  test('is recorded without them', slow, async () => {
    assert.equal((await ask('PATCH', '', { record_voices: false })).status, 200);
    const ada = await openPage(room.browser.context, `${room.hub.page}?panel=1&${view}&name=Ada`);
    await untilAllShown(ada, 1);
    await ada.getByRole('button', { name: 'Microphone' }).click();
    await until('she is heard', () => note(ada), (text) => /hear you/.test(text));
    assert.equal((await ask('POST', '/recording')).status, 201);
    await ada.locator('#panel .people .voice-tag', { hasText: /^records$/ }).waitFor();
    assert.doesNotMatch(await note(ada), /recorded/);
    await delay(3000);
    await ask('DELETE', '/recording');
    await until('it has ended', recording, ({ state }) => state === 'off');
    const { recordings } = await (await ask('GET', '/recordings')).json();
    const [newest] = recordings;
    assert.equal(newest.voices, false);
    const silent = join(room.data, 'recordings', `${newest.name}.mcap`);
    await assert.rejects(run('export', silent, '--format', 'wav', '--out', join(folder, 'none')), /nobody is heard/);
    await ada.close();
  });
});
