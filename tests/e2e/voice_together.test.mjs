// SPDX-License-Identifier: Apache-2.0
// Two people play one recording together and talk: each hears the other from where they stand in it, also while it is paused.
// Somebody in the live room hears neither, and they do not hear the live room. The microphone is a file with a chirp.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';
import { seriousFindings } from './accessibility.mjs';
import { openPage } from './browser.mjs';
import { writeChirp } from './chirp.mjs';
import { chirpTimes, isSilent, listenIn } from './listening.mjs';
import { repeatRecording } from './long_recording.mjs';
import { oneSensorRoom } from './one_sensor_room.mjs';
import { slow, stateOf, until, untilAllShown } from './waiting.mjs';

const folder = mkdtempSync(join(tmpdir(), 'roomcast-together-'));
const sound = join(folder, 'chirp.wav');
writeChirp(sound);
const microphone = ['--use-fake-device-for-media-stream', `--use-file-for-fake-audio-capture=${sound}`, '--use-fake-ui-for-media-stream'];
const room = oneSensorRoom('talk', { more: microphone });
after(() => rmSync(folder, { recursive: true, force: true }));

const played = 'long';
const longer_s = 300; // so that it does not end while a busy machine draws
const ask = (method, path, body) =>
  fetch(`${room.hub.page}api/v1/rooms/room${path}`, {
    ...{ method, body: body && JSON.stringify(body) },
    headers: { Authorization: `Bearer ${room.token}`, 'Content-Type': 'application/json' },
  });
const file = (name) => join(room.data, 'recordings', `${name}.mcap`);
const button = (page, text) => page.getByRole('button', { name: text, exact: true });
const microphoneOf = (page) => page.locator('#panel').getByRole('button', { name: 'Microphone' });
const voiceOf = (page) => page.evaluate(() => window.roomcast.voice());
const note = (page) => page.locator('#panel .sound p').innerText();
const says = (page, pattern) => until(`the page says ${pattern}`, () => note(page), (text) => pattern.test(text));
const viewers = async () => (await (await ask('GET', '/viewers')).json()).viewers;

async function play(name) {
  const address = `${room.hub.page}?panel=1&mode=points&at=0.2,1.7,2.6&look=0,0.9,-1&room=room&play=${played}&name=${name}#token=${room.token}`;
  const page = await openPage(room.browser.context, address);
  await untilAllShown(page, 1);
  await says(page, /microphone is off/);
  return page;
}

/** A gesture, without which browsers play nothing; then until somebody's voice has arrived. */
async function listen(page) {
  await page.locator('#room').click();
  await until('a voice', () => voiceOf(page), (voice) => voice?.speakers.some(({ played }) => played > 0));
  await page.locator('#room').click();
  await until('sound is on', () => voiceOf(page), (voice) => voice.context === 'running');
}

describe('two people in one recording', () => {
  let live, ada, bob;

  before(async () => {
    await room.browser.context.addInitScript(listenIn);
    await ask('POST', '/recording');
    await until('it is recorded', async () => (await ask('GET', '/recording')).json(), ({ frames }) => frames > 2);
    await delay(4000);
    await ask('DELETE', '/recording');
    await until('it has ended', async () => (await ask('GET', '/recording')).json(), ({ state }) => state === 'off');
    repeatRecording(file('roomcast-room-0001'), file(played), longer_s);
    live = await openPage(room.browser.context, `${room.hub.page}?panel=1&mode=points&name=Live`);
    await untilAllShown(live, 1);
    ada = await play('Ada');
    bob = await play('Bob');
  }, slow);

  test('hear each other from where they stand, also while it is paused', slow, async (t) => {
    await ada.getByText('Together with Bob').waitFor();
    await ada.evaluate(() => window.roomcast.setView([1.5, 1.6, 0.5], [0, 1, -1]));
    await button(ada, 'Pause').click();
    await microphoneOf(ada).click();
    await says(ada, /hear you/);
    await listen(bob);
    const chirps = await chirpTimes(bob, 'ear', 3);
    assert.ok(chirps.length >= 3, `${chirps.length} chirps`);
    const { viewers: seen } = await stateOf(bob);
    const { id } = seen.find(({ name }) => name === 'Ada (with you)');
    assert.deepEqual((await voiceOf(bob)).speakers.map((speaker) => speaker.id), [id]);
    await bob.locator('#panel .people li.speaks', { hasText: 'Ada (with you)' }).waitFor();
    const place = await bob.evaluate((who) => window.roomcast.otherPoses().find(({ viewerId }) => viewerId === who)?.head, id);
    assert.ok(Math.abs(place.x - 1.5) < 0.05, JSON.stringify(place));
    t.diagnostic(`heard as ${id}, from ${place.x.toFixed(2)}, ${place.z.toFixed(2)}`);
    assert.deepEqual(await seriousFindings(bob), []);
  });

  test('seeking and speed do not interrupt what they say', slow, async () => {
    await bob.getByLabel('Speed').selectOption('2');
    await button(bob, 'Play').click();
    await bob.getByRole('slider', { name: 'Position in the recording' }).press('PageUp');
    await delay(1000);
    assert.ok((await chirpTimes(bob, 'ear', 2)).length >= 2);
    await bob.getByLabel('Speed').selectOption('1');
  });

  test('nobody in the live room hears them, nor is heard or sees them', slow, async () => {
    assert.equal(await voiceOf(live), null, 'nothing of voice was loaded');
    assert.deepEqual((await stateOf(live)).viewers.map(({ name }) => name), ['Live']);
    await microphoneOf(live).click();
    await says(live, /hear you/);
    await delay(1500);
    const heard = (await voiceOf(bob)).speakers.length;
    assert.equal(heard, 1, 'Ada only');
    await microphoneOf(live).click();
    const people = await viewers();
    assert.deepEqual(people.filter(({ plays }) => plays === played).map(({ name }) => name).sort(), ['Ada', 'Bob']);
  });

  test('an admin mutes one there, who is told', slow, async () => {
    const { id } = (await viewers()).find(({ name }) => name === 'Ada');
    assert.equal((await ask('PATCH', `/viewers/${id}`, { muted: true })).status, 200);
    await says(ada, /muted you/);
    await delay(1500);
    assert.ok(await isSilent(bob), 'she is silent');
    await bob.locator('#panel .people li', { hasText: 'muted' }).waitFor();
    await ask('PATCH', `/viewers/${id}`, { muted: false });
    await says(ada, /microphone is off/);
    await microphoneOf(ada).click();
    assert.ok((await chirpTimes(bob, 'ear', 1)).length >= 1, 'she is heard again');
  });

  test('who plays alone neither hears nor is heard, and the page says so', slow, async () => {
    await bob.getByLabel('Together with Ada').uncheck();
    await says(bob, /You play this recording alone/);
    await until('the hub knows', viewers, (people) => people.filter(({ plays }) => plays).length === 1);
    await delay(1500);
    assert.ok(await isSilent(bob), 'silent');
    await bob.getByLabel('Together with others').check();
    await says(bob, /microphone is off/);
    assert.ok((await chirpTimes(bob, 'ear', 1)).length >= 1, 'she is heard again');
    for (const page of [ada, bob, live]) assert.deepEqual(page.complaints, []);
  });
});
