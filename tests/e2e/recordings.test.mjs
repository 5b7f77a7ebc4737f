// SPDX-License-Identifier: Apache-2.0
// The recordings that a hub keeps, in the console: listed, fetched, renamed, deleted; damaged ones.
import assert from 'node:assert/strict';
import { copyFileSync, existsSync, readFileSync, statSync, truncateSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, describe, test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';
import { seriousFindings } from './accessibility.mjs';
import { openPage, startBrowser } from './browser.mjs';
import { oneSensorRoom } from './one_sensor_room.mjs';
import { slow, until } from './waiting.mjs';

const view = 'mode=points&at=0.2,1.7,2.6&look=0,0.9,-1';
const room = oneSensorRoom('recordings');
const folder = () => join(room.data, 'recordings');
const file = (name) => join(folder(), `${name}.mcap`);
const ask = async (method, path) => {
  const headers = { Authorization: `Bearer ${room.token}` };
  return fetch(`${room.hub.page}api/v1/rooms/room${path}`, { method, headers });
};

/** Records the room for some seconds; the file is roomcast-room-0001. */
async function record(seconds) {
  const state = async () => (await ask('GET', '/recording')).json();
  assert.equal((await ask('POST', '/recording')).status, 201);
  await until('frames are recorded', state, ({ frames }) => frames > 2);
  await delay(1000 * seconds);
  await ask('DELETE', '/recording');
  await until('it has ended', state, (now) => now.state === 'off');
}

/** Opens the console's list of recordings. */
async function openList(context, press = (button) => button.click()) {
  const page = await openPage(context, `${room.hub.page}?panel=1&${view}#token=${room.token}`);
  await press(page.getByRole('button', { name: 'Console', exact: true }));
  await press(page.getByRole('tab', { name: 'Recordings' }));
  return page;
}

const row = (page, name) => page.locator('#console .kept').filter({ has: page.getByText(name, { exact: true }) });
const count = (page, wanted) => until(`${wanted} listed`, () => page.locator('#console .kept').count(), (n) => n === wanted);

describe('the recordings in the console', () => {
  before(() => record(2), slow);

  test('are listed with length, size and sensors, and fetched', slow, async () => {
    const page = await openList(room.browser.context);
    await row(page, 'roomcast-room-0001').waitFor();
    assert.match(await row(page, 'roomcast-room-0001').innerText(), /0:0\d min · \d+\.\d\d MB · 1 sensor/);
    assert.deepEqual(await seriousFindings(page), []);
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: 'Download: roomcast-room-0001' }).click(),
    ]);
    assert.equal(download.suggestedFilename(), 'roomcast-room-0001.mcap');
    assert.ok(!download.url().includes(room.token));
    assert.deepEqual(readFileSync(await download.path()), readFileSync(file('roomcast-room-0001')));
    assert.equal((await fetch(download.url())).status, 404, 'its address works once');
    assert.deepEqual(page.complaints, []);
    await page.close();
  });

  test('say what is wrong with a damaged one', slow, async () => {
    copyFileSync(file('roomcast-room-0001'), file('cut'));
    truncateSync(file('cut'), statSync(file('cut')).size >> 1);
    writeFileSync(file('noise <img src=x>'), 'nothing of the kind');
    const page = await openList(room.browser.context);
    await count(page, 3);
    assert.match(await row(page, 'cut').innerText(), /Damaged\. Its end is missing\./);
    assert.match(await row(page, 'noise <img src=x>').innerText(), /Damaged: it cannot be read\. It is not an MCAP file\./);
    assert.deepEqual(await seriousFindings(page), []);
    for (const name of ['cut', 'noise <img src=x>']) {
      await page.getByRole('button', { name: `Delete: ${name}` }).click();
      await page.getByRole('button', { name: `Delete for good?: ${name}` }).click();
      await page.getByText(`${name} is deleted.`).waitFor();
    }
    await count(page, 1);
    assert.ok(!existsSync(file('cut')));
    assert.deepEqual(page.complaints, []);
    await page.close();
  });

  test('are renamed and deleted by keyboard alone, deleted only when asked twice', slow, async () => {
    copyFileSync(file('roomcast-room-0001'), file('second'));
    const page = await openList(room.browser.context);
    await count(page, 2);
    const press = async (name, key = 'Enter') => {
      await page.getByRole('button', { name, exact: true }).focus();
      await page.keyboard.press(key);
    };
    await press('Rename: second');
    await page.keyboard.press('Escape');
    assert.ok(await page.locator('#console').isVisible(), 'Escape ended the renaming only');
    await press('Rename: second');
    await page.keyboard.type('roomcast-room-0001');
    await page.keyboard.press('Enter');
    await page.getByText(/there is a recording "roomcast-room-0001" already/).waitFor();
    await page.keyboard.press('ControlOrMeta+a');
    await page.keyboard.type('Tuesday’s visit');
    await page.keyboard.press('Enter');
    await row(page, 'Tuesday’s visit').waitFor();
    assert.ok(existsSync(file('Tuesday’s visit')));
    await press('Delete: Tuesday’s visit');
    await page.keyboard.press('Tab');
    await page.getByRole('button', { name: 'Delete: Tuesday’s visit', exact: true }).waitFor();
    assert.ok(existsSync(file('Tuesday’s visit')), 'it was asked once, and is not answered');
    await press('Delete: Tuesday’s visit');
    await page.keyboard.press('Enter');
    await count(page, 1);
    assert.ok(!existsSync(file('Tuesday’s visit')));
    await page.close();
  });

  test('appear when they are made, and are left alone until they are whole', slow, async () => {
    const page = await openList(room.browser.context);
    await count(page, 1);
    await page.getByRole('button', { name: 'Start recording' }).click();
    const made = row(page, 'roomcast-room-0002');
    await made.getByText('It is being recorded.').waitFor();
    assert.ok(await made.getByRole('button', { name: /^Delete/ }).isDisabled());
    await page.getByRole('button', { name: 'Stop recording' }).click();
    await until('it is whole', () => made.innerText(), (text) => !/being recorded/.test(text));
    assert.equal((await ask('DELETE', '/recordings/roomcast-room-0002')).status, 204);
    await page.close();
  });

  test('fit on a phone', slow, async () => {
    const phone = await startBrowser({ width: 390, height: 844, phone: true });
    const page = await openList(phone.context, (button) => button.tap());
    await count(page, 1);
    assert.deepEqual(await seriousFindings(page), []);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'nothing sticks out');
    await page.getByRole('button', { name: 'Rename: roomcast-room-0001' }).tap();
    await page.getByLabel('New name: roomcast-room-0001').waitFor();
    await phone.end();
  });
});
