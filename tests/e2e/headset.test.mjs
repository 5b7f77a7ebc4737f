// SPDX-License-Identifier: Apache-2.0
// The room in a headset emulated by iwer: real Chromium, hub and sensor, and a WebXR device implemented in JavaScript.
// A second page is another viewer, which sees the wearer's movements.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { openPage, startBrowser } from './browser.mjs';
import { wearHeadsets } from './headset_device.mjs';
import { requireBuilt, startHub, startSensor } from './programs.mjs';
import { distance, panelText, slow, stateOf, until, untilAllShown } from './waiting.mjs';

const eyesApart_m = 0.063; // iwer's default
const floorView = 'panel=1&at=0.5,1.6,1.5&look=0.5,1.6,0';

const headsetOf = (page) => page.evaluate(() => window.roomcast.headset());

describe('the room in a headset', () => {
  let hub, sensor, browser, page, other;

  before(async () => {
    requireBuilt();
    hub = await startHub();
    sensor = startSensor(hub, 0, { fps: 2 });
    browser = await startBrowser({ width: 480, height: 240 });
    other = await openPage(browser.context, `${hub.page}?panel=0&mode=points&name=other`);
    await wearHeadsets(browser.context);
    page = await openPage(browser.context, `${hub.page}?${floorView}&name=wearer`);
    await untilAllShown(page, 1);
  }, slow);

  after(async () => {
    await browser?.end();
    await sensor?.end();
    await hub?.end();
  }, slow);

  const untilHeadset = (what, enough) => until(what, () => headsetOf(page), enough);
  const seenByOther = async () => {
    const { viewerId } = await stateOf(page);
    return (await other.evaluate(() => window.roomcast.otherPoses())).find((pose) => pose.viewerId === viewerId);
  };

  test('a button enters it, and both eyes look from the person’s viewpoint', slow, async () => {
    await page.getByRole('button', { name: 'Enter VR' }).click();
    const { views } = await untilHeadset('two views', ({ on, views }) => on && views.length === 2);
    const [left, right] = [views.find(({ eye }) => eye === 'left'), views.find(({ eye }) => eye === 'right')];
    assert.ok(Math.abs(distance(left.position, right.position) - eyesApart_m) < 1e-3, JSON.stringify(views));
    const middle = left.position.map((value, i) => (value + right.position[i]) / 2);
    assert.ok(Math.abs(middle[0] - 0.5) < 0.02 && Math.abs(middle[2] - 1.5) < 0.02, `at ${middle}`);
    assert.ok(Math.abs(middle[1] - 1.7) < 0.02, 'the floor is the room’s floor');
    assert.ok(right.position[0] > left.position[0], 'one looks along -z');
  });

  test('pictures keep coming, with new frames', slow, async () => {
    const before = await stateOf(page);
    await until(
      'they do',
      () => stateOf(page),
      (now) => now.pictures > before.pictures + 2 && now.shownSets > before.shownSets,
    );
  });

  test('the view follows the head, and so do the eyes of the person’s avatar', slow, async () => {
    await page.evaluate(() => {
      window.device.position.set(0.4, 1.5, -0.3);
      window.device.quaternion.set(0, Math.sin(0.3), 0, Math.cos(0.3));
    });
    const near = (head) => head && distance([head.x, head.y, head.z], [0.9, 1.5, 1.2]) < 0.05;
    await untilHeadset('the head has moved', ({ head }) => near(head) && Math.abs(head.qy - Math.sin(0.3)) < 0.01);
    const seen = await until('the other sees it', seenByOther, (pose) => near(pose?.head));
    assert.ok(
      seen.hands.every((hand) => hand !== null),
      'with both hands',
    );
  });

  test('a stick turns the wearer about the head, and the trigger teleports', slow, async () => {
    const { head: start } = await headsetOf(page);
    await page.evaluate(() => window.device.controllers.right.updateAxes('thumbstick', 1, 0));
    const turned = await untilHeadset('a turn', ({ head }) => Math.abs(head.qy - start.qy) > 0.1);
    assert.ok(distance(place(turned.head), place(start)) < 0.02, 'the head stays where it is');
    await page.evaluate(() => window.device.controllers.right.updateAxes('thumbstick', 0, 0));

    await page.evaluate(() => window.device.controllers.right.updateButtonValue('trigger', 1));
    const { pictures } = await stateOf(page);
    await until(
      'two pictures of aiming',
      () => stateOf(page),
      (now) => now.pictures > pictures + 2,
    );
    await page.evaluate(() => window.device.controllers.right.updateButtonValue('trigger', 0));
    await untilHeadset('a select', ({ selects }) => selects === 1);
    const moved = await untilHeadset('a new place', ({ head }) => distance(place(head), place(turned.head)) > 0.3);
    assert.ok(Math.abs(moved.head.y - turned.head.y) < 0.02, 'on the same floor');
    assert.equal(moved.narrowness, 0);

    await page.evaluate(() => window.device.controllers.left.updateAxes('thumbstick', 0, -1));
    await untilHeadset('a narrow view while walking', ({ narrowness }) => narrowness > 0.5);
    await page.evaluate(() => window.device.controllers.left.updateAxes('thumbstick', 0, 0));
    await untilHeadset('the whole view again', ({ narrowness }) => narrowness === 0);
  });

  test('hands without controllers are drawn joint by joint', slow, async () => {
    assert.deepEqual((await headsetOf(page)).drawnHands, ['controller', 'controller']);
    await page.evaluate(() => (window.device.primaryInputMode = 'hand'));
    await untilHeadset('both hands', ({ drawnHands }) => drawnHands.every((shown) => shown === 'joints'));
    await page.evaluate(() => (window.device.primaryInputMode = 'controller'));
    await untilHeadset('controllers again', ({ drawnHands }) => drawnHands.every((shown) => shown === 'controller'));
  });

  test('the session ends cleanly, and the screen shows the headset’s last view', slow, async () => {
    const { head } = await headsetOf(page);
    await page.getByRole('button', { name: 'Leave the headset' }).dispatchEvent('click'); // covered by iwer's picture
    await untilHeadset('it is off', ({ on, presenting }) => !on && !presenting);
    const { position } = await page.evaluate(() => window.roomcast.view());
    assert.ok(distance(position, place(head)) < 0.05);
    const before = await stateOf(page);
    await until(
      'the screen goes on',
      () => stateOf(page),
      (now) => now.pictures > before.pictures + 1,
    );
    await until('hands are gone', seenByOther, (pose) => pose?.hands.every((hand) => hand === null));
    assert.deepEqual(page.complaints, []);
  });

  test('with passthrough the wearer’s own room is visible between the surfaces', slow, async () => {
    await page.getByRole('button', { name: 'Enter with your own room around you' }).click();
    await untilHeadset('passthrough', ({ on, passthrough, views }) => on && passthrough && views.length === 2);
    await page.getByRole('button', { name: 'Leave the headset' }).dispatchEvent('click');
    await untilHeadset('it is off', ({ on, passthrough }) => !on && !passthrough);
    assert.deepEqual(page.complaints, []);
  });

  test('a browser without a headset gives advice', slow, async () => {
    await other.evaluate(() => document.querySelector('.toggle').click());
    await until(
      'the panel says so',
      () => panelText(other),
      (text) => /No headset is connected|does not support WebXR/.test(text),
    );
  });
});

function place({ x, y, z }) {
  return [x, y, z];
}
