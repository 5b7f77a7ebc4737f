// SPDX-License-Identifier: Apache-2.0
// The page gets no frames of a sensor that shows nothing that it can see, and gets them again when it turns round.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';
import { openPage } from './browser.mjs';
import { oneSensorRoom } from './one_sensor_room.mjs';
import { panelText, sensorsOf, slow, until, untilAllShown } from './waiting.mjs';

const room = oneSensorRoom('looking');
const silent_ms = 3500; // the panel calls a sensor silent after 3 s

/** Puts the page where the sensor is, looking where it looks, or the other way. */
async function look(page, { worldFromDepth: m }, ahead) {
  const at = [m[3], m[7], m[11]];
  const sign = ahead ? 1 : -1;
  const target = [m[2], m[6], m[10]].map((forward, axis) => at[axis] + sign * forward);
  await page.evaluate(([from, to]) => window.roomcast.setView(from, to), [at, target]);
}

test('frames that nobody looks at are not sent', slow, async (t) => {
  const page = await openPage(room.browser.context, `${room.hub.page}?panel=1`);
  t.after(() => page.close());
  await untilAllShown(page, 1);
  const [sensor] = await sensorsOf(page);
  const frames = async () => (await sensorsOf(page))[0].frames;

  await look(page, sensor, true);
  const seen = await frames();
  await until('frames of what is seen', frames, (count) => count > seen + 3);

  await look(page, sensor, false);
  let before = -1;
  await until('no more frames', async () => {
    const last = before;
    before = await frames();
    await delay(1500);
    return before === last;
  }, Boolean);
  await delay(silent_ms);
  assert.equal(await frames(), before);
  assert.doesNotMatch(await panelText(page), /silent/, 'the page knows why nothing comes');

  await look(page, sensor, true);
  await until('frames again', frames, (count) => count > before + 3);
});
