// SPDX-License-Identifier: Apache-2.0
// The room is put somewhere in the wearer's own room, which the emulated headset shows around it: on the floor, turned by a
// stick, on a table, not on a wall; it is there again when the headset is put on the next time.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { keepPicture, openPage, startBrowser } from './browser.mjs';
import { pointAt, pressOnBoard, pullTrigger, wearHeadsets } from './headset_device.mjs';
import { requireBuilt, startHub, startSensor } from './programs.mjs';
import { distance, slow, until, untilAllShown } from './waiting.mjs';

describe('the room in one’s own room', () => {
  let hub, sensor, browser, page;

  before(async () => {
    requireBuilt();
    hub = await startHub();
    sensor = startSensor(hub, 0, { fps: 2 });
    browser = await startBrowser({ width: 900, height: 450 });
    await wearHeadsets(browser.context);
    page = await openPage(browser.context, `${hub.page}?panel=1&at=0.5,1.6,1.5&look=0.5,1.6,0&mode=points&name=wearer`);
    await untilAllShown(page, 1);
  }, slow);

  after(async () => {
    await browser?.end();
    await sensor?.end();
    await hub?.end();
  }, slow);

  const headset = () => page.evaluate(() => window.roomcast.headset());
  const untilHeadset = (what, enough) => until(what, headset, enough);
  const press = (text) => pressOnBoard(page, async () => (await headset()).panel, text);
  /** Where a point of the own room is in the remote room. */
  const inRoom = ({ x, y, z, yaw }, [px, py, pz]) => {
    const [sin, cos] = [Math.sin(yaw), Math.cos(yaw)];
    return [x + cos * px + sin * pz, y + py, z - sin * px + cos * pz];
  };
  const near = (a, b) => distance(a, b) < 0.02;
  async function enter() {
    await page.getByRole('button', { name: 'Enter with your own room around you' }).click();
    await untilHeadset('the tile', ({ panel, head }) => head && panel?.tile?.buttons[0]?.text === 'Menu');
  }
  async function leave() {
    await page.getByRole('button', { name: 'Leave the headset' }).dispatchEvent('click'); // covered by iwer's picture
    await untilHeadset('it is off', ({ on }) => !on);
  }
  async function beginToPlace() {
    await press('Menu');
    await untilHeadset('the menu', ({ panel }) => panel.board?.buttons.some(({ text }) => text === 'Place the room'));
    await press('Place the room');
    await untilHeadset('the words', ({ places, panel }) => places && /Point at your floor/.test(panel.tile.texts.join(' ')));
  }

  const floor = [-1, 0, -1.5]; // in the own room
  const other = [-1.8, 0, -2];
  const table = [1, 0.75, -1];
  let placed;

  test('it follows where one points, and its floor is the own floor', slow, async () => {
    await enter();
    await beginToPlace();
    await pointAt(page, floor);
    const before = (await headset()).standing;
    const held = inRoom(before, floor);
    await pointAt(page, other);
    const { standing } = await untilHeadset('it has moved', (now) => near(inRoom(now.standing, other), held));
    assert.ok(Math.abs(standing.y) < 0.001 && Math.abs(standing.yaw - before.yaw) < 0.001, JSON.stringify(standing));
    await keepPicture(page, 'own_room_placing');
  });

  test('a stick turns it about that point', slow, async () => {
    const { standing: before } = await headset();
    const held = inRoom(before, other);
    await page.evaluate(() => window.device.controllers.right.updateAxes('thumbstick', 1, 0));
    await untilHeadset('it turns', ({ standing }) => standing.yaw - before.yaw > 0.3);
    await page.evaluate(() => window.device.controllers.right.updateAxes('thumbstick', 0, 0));
    assert.ok(near(inRoom((await headset()).standing, other), held));
  });

  test('it is put on a table, but not on a wall', slow, async () => {
    const before = inRoom((await headset()).standing, other);
    await pointAt(page, [0, 1.5, -4]);
    await pullTrigger(page);
    assert.ok((await headset()).places, 'a wall takes no room');
    await pointAt(page, table);
    const { standing } = await untilHeadset('it is on the table', (now) => near(inRoom(now.standing, table), before));
    assert.ok(Math.abs(standing.y + 0.75) < 0.01, 'its floor is as high as the table');
    await pullTrigger(page);
    ({ standing: placed } = await untilHeadset('it is put down', ({ places }) => !places));
    await pointAt(page, floor);
    await untilHeadset('it stays', (now) => near(inRoom(now.standing, table), inRoom(placed, table)));
    await keepPicture(page, 'own_room_placed');
  });

  test('it is there again the next time', slow, async () => {
    await until('the headset’s place is kept', () => page.evaluate(() => localStorage.getItem('roomcast.placed.room')), (kept) => kept !== null);
    await leave();
    await page.reload();
    await untilAllShown(page, 1);
    await page.evaluate(() => window.device.position.set(0.3, 1.6, 0.2)); // the wearer stands elsewhere
    await enter();
    const { standing } = await untilHeadset('it is back', (now) => near(inRoom(now.standing, table), inRoom(placed, table)));
    const turned = Math.atan2(Math.sin(standing.yaw - placed.yaw), Math.cos(standing.yaw - placed.yaw));
    assert.ok(Math.abs(turned) < 0.01, `${turned}`);
  });

  test('a stick that walks ends that, until the next time', slow, async () => {
    await page.evaluate(() => window.device.controllers.left.updateAxes('thumbstick', 0, -1));
    await untilHeadset('the wearer walks', ({ standing }) => !near(inRoom(standing, table), inRoom(placed, table)));
    await page.evaluate(() => window.device.controllers.left.updateAxes('thumbstick', 0, 0));
    await leave();
    assert.deepEqual(page.complaints, []);
  });

  test('without known surfaces it is put on the floor', slow, async () => {
    await page.evaluate(() => {
      localStorage.clear();
      XRSession.prototype.requestHitTestSource = () => Promise.reject(new Error('none here'));
      XRFrame.prototype.createAnchor = undefined;
    });
    await page.evaluate(() => window.device.position.set(0, 1.7, 0));
    await enter();
    await beginToPlace();
    await pointAt(page, floor);
    const held = inRoom((await headset()).standing, floor);
    await pointAt(page, table);
    const under = [table[0] * (1.7 / 0.95), 0, table[2] * (1.7 / 0.95)];
    await untilHeadset('it is where the ray meets the floor', (now) => near(inRoom(now.standing, under), held));
    await pullTrigger(page);
    await untilHeadset('it is put down', ({ places }) => !places);
    await leave();
    assert.deepEqual(page.complaints, []);
  });
});
