// SPDX-License-Identifier: Apache-2.0
// A sensor with a microphone, for which a file with a chirp stands: the page plays it, lists it beside the sensor with a volume,
// and an admin mutes it in the console.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { openPage, startBrowser } from './browser.mjs';
import { writeChirp } from './chirp.mjs';
import { chirpTimes, listenIn } from './listening.mjs';
import { adminsToken, requireBuilt, startHub, startSensor } from './programs.mjs';
import { slow, stateOf, until } from './waiting.mjs';

const data = mkdtempSync(join(tmpdir(), 'roomcast-ear-'));
const sound = join(data, 'chirp.wav');
let hub, sensor, browser, page;

before(async () => {
  requireBuilt();
  writeChirp(sound);
  hub = await startHub(0, { data });
  sensor = startSensor(hub, 0, { fps: 3, audio: `wav:${sound}` });
  browser = await startBrowser({ width: 1000, height: 700 });
  await browser.context.addInitScript(listenIn);
  page = await openPage(browser.context, `${hub.page}?panel=1&mode=points#token=${await adminsToken(data)}`);
  await until('it has joined', () => stateOf(page), ({ phase }) => phase === 'joined');
}, slow);

after(async () => {
  await browser?.end();
  await sensor?.end();
  await hub?.end();
  rmSync(data, { recursive: true, force: true });
}, slow);

const row = () => page.locator('#panel .sensors li').first();
const voice = () => page.evaluate(() => window.roomcast.voice());

describe('the microphone of a room', () => {
  test('is heard in the page', slow, async (t) => {
    await until('the sound is loaded', voice, (figures) => figures?.speakers.length > 0);
    await page.locator('#room').click();
    await until('it sounds', voice, ({ context }) => context === 'running');
    assert.equal((await voice()).speakers[0].id, 0x80000000);
    const times = await chirpTimes(page, 'ear', 2);
    assert.equal(times.length, 2, 'two chirps are played');
    t.diagnostic(`chirps like the original: ${times.map(({ likeness }) => likeness.toFixed(2)).join(', ')}`);
  });

  test('is listed beside its sensor, with a volume', slow, async () => {
    await until('the row says so', () => row().innerText(), (text) => /is heard/.test(text));
    await row().locator('input[type=range]').fill('0.5');
    assert.equal((await voice()).speakers[0].volume, 0.5);
  });

  test('is muted by an admin, for all', slow, async () => {
    await page.getByRole('button', { name: 'Console', exact: true }).click();
    await page.getByRole('tab', { name: 'Sensors' }).click();
    const mute = page.locator('.cards .mute').first();
    await mute.click();
    await until('the row says so', () => row().innerText(), (text) => /muted/.test(text));
    await until('the switch is on', () => mute.getAttribute('aria-pressed'), (pressed) => pressed === 'true');
    await mute.click();
    await until('it is heard again', () => row().innerText(), (text) => /is heard/.test(text));
  });
});
