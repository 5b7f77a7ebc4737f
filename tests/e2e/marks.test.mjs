// SPDX-License-Identifier: Apache-2.0
// What people show each other in the room: pointing by mouse, key and finger. One room of one sensor for all.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { openPage, startBrowser } from './browser.mjs';
import { requireBuilt, startHub, startSensor } from './programs.mjs';
import { slow, stateOf, until, untilAllShown } from './waiting.mjs';

const view = 'mode=mesh&at=0.2,1.7,2.6&look=0,0.9,-1';
const data = mkdtempSync(join(tmpdir(), 'roomcast-marks-'));
const [middle, side] = [{ x: 600, y: 320 }, { x: 700, y: 330 }];
let hub, sensor, browser;

before(async () => {
  requireBuilt();
  hub = await startHub(0, { data });
  sensor = startSensor(hub, 0, { fps: 3 });
  browser = await startBrowser({ width: 1000, height: 640 });
}, slow);

after(async () => {
  await browser?.end();
  await sensor?.end();
  await hub?.end();
  rmSync(data, { recursive: true, force: true });
}, slow);

const open = (more = '', { context } = browser) => openPage(context, `${hub.page}?panel=0&${view}${more}`);
const viewOf = (page) => page.evaluate(() => window.roomcast.view());
const distance = (a, b) => Math.hypot(...a.map((value, i) => value - b[i]));
/** What `of`, another page's viewer, points at; null while they do not. */
async function pointOf(of, page) {
  const { viewerId } = await stateOf(of);
  return (await page.evaluate(() => window.roomcast.otherPoses())).find((pose) => pose.viewerId === viewerId)?.pointsAt ?? null;
}

describe('pointing', () => {
  let ada, bob;
  before(async () => {
    ada = await open('&name=Ada');
    bob = await open('&name=Bob');
    await untilAllShown(ada, 1);
    await untilAllShown(bob, 1);
  }, slow);
  after(() => Promise.all([ada?.close(), bob?.close()]));

  test('by a long press shows the others the surface under the mouse, until it is let go; the view stays', slow, async () => {
    await ada.bringToFront();
    const before = await viewOf(ada);
    await ada.mouse.move(middle.x, middle.y);
    await ada.mouse.down();
    const first = await until('Bob sees it', () => pointOf(ada, bob), (point) => point !== null);
    await ada.mouse.move(side.x, side.y);
    const second = await until('it follows', () => pointOf(ada, bob), (point) => point && distance(point, first) > 0.05);
    assert.ok(second.every(Number.isFinite) && second[1] > -0.2 && second[2] < before.position[2], `${second}`);
    await ada.mouse.up();
    await until('it is off', () => pointOf(ada, bob), (point) => point === null);
    assert.deepEqual(await viewOf(ada), before);
    assert.deepEqual(ada.complaints, []);
  });

  test('by the key L works with the mouse and without it', slow, async () => {
    await ada.bringToFront();
    await ada.locator('#room').focus();
    await ada.keyboard.down('KeyL');
    const there = await until('Bob sees it', () => pointOf(ada, bob), (point) => point !== null);
    await ada.mouse.move(middle.x, middle.y);
    await until('it follows', () => pointOf(ada, bob), (point) => point && distance(point, there) > 0.05);
    await ada.keyboard.up('KeyL');
    await until('it is off', () => pointOf(ada, bob), (point) => point === null);
    const typing = await open('&name=Eve');
    await typing.getByRole('button', { name: 'Open the panel' }).click();
    await typing.getByRole('button', { name: 'Change your name' }).click();
    await typing.keyboard.down('KeyL');
    await typing.waitForTimeout(400);
    assert.equal(await pointOf(typing, bob), null, 'a letter of a name points at nothing');
    await typing.close();
  });

  test('does not begin where one drags', slow, async () => {
    await ada.bringToFront();
    await ada.mouse.move(middle.x, middle.y);
    await ada.mouse.down();
    await ada.mouse.move(middle.x + 60, middle.y, { steps: 3 });
    await ada.waitForTimeout(900);
    assert.equal(await pointOf(ada, bob), null);
    await ada.mouse.up();
  });
});

describe('a phone', () => {
  let phone, page, other;
  before(async () => {
    phone = await startBrowser({ width: 390, height: 844, phone: true });
    page = await open('&name=Ada', phone);
    other = await open('&name=Bob');
    await untilAllShown(page, 1);
  }, slow);
  after(() => Promise.all([phone?.end(), other?.close()]));

  test('points by press and hold, and a second finger ends it', slow, async () => {
    const screen = await phone.context.newCDPSession(page);
    const touch = (type, ...places) =>
      screen.send('Input.dispatchTouchEvent', { type, touchPoints: places.map(([x, y], id) => ({ x, y, id })) });
    await touch('touchStart', [195, 330]);
    await until('Bob sees it', () => pointOf(page, other), (point) => point !== null);
    await touch('touchStart', [195, 330], [260, 400]);
    await until('it is off', () => pointOf(page, other), (point) => point === null);
    await touch('touchEnd');
    assert.deepEqual(page.complaints, []);
  });
});
