// SPDX-License-Identifier: Apache-2.0
// In the emulated headset a hand points at the room's surfaces, which the others see, and measures between them.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { keepPicture, openPage, startBrowser } from './browser.mjs';
import { pointAt, pressOnBoard, pullTrigger, wearHeadsets } from './headset_device.mjs';
import { requireBuilt, startHub, startSensor } from './programs.mjs';
import { distance, slow, stateOf, until, untilAllShown } from './waiting.mjs';

describe('a hand in a headset', () => {
  let hub, sensor, browser, page, other;

  before(async () => {
    requireBuilt();
    hub = await startHub();
    sensor = startSensor(hub, 0, { fps: 2 });
    browser = await startBrowser({ width: 900, height: 450 });
    other = await openPage(browser.context, `${hub.page}?panel=0&mode=points&name=other`);
    await wearHeadsets(browser.context);
    page = await openPage(browser.context, `${hub.page}?panel=1&at=0.5,1.6,1.5&look=0.5,1.6,0&mode=points&name=wearer`);
    await untilAllShown(page, 1);
    await page.getByRole('button', { name: 'Enter VR' }).click();
    await untilHeadset('the tile', ({ panel, head }) => head && panel?.tile?.buttons[0]?.text === 'Menu');
  }, slow);

  after(async () => {
    await browser?.end();
    await sensor?.end();
    await hub?.end();
  }, slow);

  const headset = () => page.evaluate(() => window.roomcast.headset());
  const untilHeadset = (what, enough) => until(what, headset, enough);
  const press = (text) => pressOnBoard(page, async () => (await headset()).panel, text);
  const grip = (value) => page.evaluate((to) => window.device.controllers.right.updateButtonValue('squeeze', to), value);
  const pointerSeen = async () => {
    const { viewerId } = await stateOf(page);
    return (await other.evaluate(() => window.roomcast.otherPoses())).find((pose) => pose.viewerId === viewerId)?.pointsAt ?? null;
  };
  const own = ([x, y, z]) => [x - 0.5, y, z - 1.5]; // where the wearer has entered
  const left = [-0.6, 0, 0.2]; // on the floor
  const right = [-0.6, 0, -0.6];

  test('points while the grip is held, and the others see it', slow, async () => {
    assert.equal(await pointerSeen(), null);
    await pointAt(page, own(left));
    await grip(1);
    const at = await until('they see it', pointerSeen, (pointer) => pointer !== null);
    assert.ok(distance(at, left) < 0.15, `${at}`);
    await keepPicture(page, 'headset_laser');
    await grip(0);
    await until('it is gone', pointerSeen, (pointer) => pointer === null);
  });

  test('measures by two pulls of the trigger, for all if the wearer wants', slow, async () => {
    await press('Menu');
    await press('Measure');
    await untilHeadset('the words', ({ panel }) => /two points/.test(panel.tile?.texts.join(' ') ?? ''));
    const { standing } = await headset();
    for (const point of [left, right]) {
      await pointAt(page, own(point));
      await pullTrigger(page);
    }
    const { panel } = await untilHeadset('a distance', ({ panel: now }) => now.tile.texts.some((text) => / m$/.test(text)));
    const metres = Number(/([\d.]+) m$/.exec(panel.tile.texts.find((text) => / m$/.test(text)))[1]);
    assert.ok(Math.abs(metres - 0.8) < 0.15, `${metres} m`);
    assert.deepEqual((await headset()).standing, standing, 'the trigger has not teleported');
    await keepPicture(page, 'headset_measuring');
    await press('Leave it for everybody');
    const marks = await until('all have it', () => other.evaluate(() => window.roomcast.marks()), (list) => list.length === 1);
    assert.equal(marks[0].points.length, 6);
    await press('Done');
    await untilHeadset('it is over', ({ panel: now }) => now.tile?.buttons[0]?.text === 'Menu');
    assert.equal(await pointerSeen(), null);
    assert.deepEqual(page.complaints, []);
  });
});
