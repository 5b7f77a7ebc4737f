// SPDX-License-Identifier: Apache-2.0
// The page does not grow while it streams: the numbers of textures and geometries stay constant, and so does the memory
// of Chromium's processes apart from caches. ROOMCAST_SOAK_S sets the duration (`npm run soak`: five minutes).
import assert from 'node:assert/strict';
import { setTimeout as delay } from 'node:timers/promises';
import { after, before, describe, test } from 'node:test';
import { openPage, startBrowser } from './browser.mjs';
import { processesOf, residentMb } from './chromium_processes.mjs';
import { requireBuilt, startHub, startSensor } from './programs.mjs';
import { stateOf, until, untilAllShown } from './waiting.mjs';

const seconds = Number(process.env.ROOMCAST_SOAK_S ?? 20);
const warmUpSets = 20;
const warmUpWithin_ms = 240_000; // with software rendering at full quality
const readings = 10;
const mostGrowth_mb = 40; // from the first third of the readings to the last
const timeout = { timeout: 2 * (warmUpWithin_ms + 1000 * seconds) };

function mean(values) {
  return values.reduce((sum, value) => sum + value, 0) / values.length;
}

describe('a page that streams', () => {
  let hub, sensors, browser;
  before(async () => {
    requireBuilt();
    hub = await startHub(0, { more: ['--no-model'] }); // a model's pieces come and go
    sensors = [0, 1].map((n) => startSensor(hub, n, { fps: 5 }));
    browser = await startBrowser({ width: 320, height: 240 });
  }, timeout);
  after(async () => {
    await browser?.end();
    await Promise.all([...(sensors ?? []), hub].map((program) => program?.end()));
  }, timeout);

  test(`does not grow in ${seconds} s`, timeout, async (t) => {
    // Otherwise the page would begin to blend surfaces, and allocate for it, whenever the machine happened to be fast
    // enough.
    const page = await openPage(browser.context, `${hub.page}?panel=1&quality=best`);
    await untilAllShown(page, 2);
    const warm = await until(
      'some sets',
      () => stateOf(page),
      ({ shownSets }) => shownSets >= warmUpSets,
      warmUpWithin_ms,
    );
    const processes = (await processesOf(browser.context)).filter(({ type }) => type === 'renderer' || type === 'GPU');
    const used = [];
    for (let i = 0; i < readings; i++) {
      await page.requestGC();
      used.push(processes.reduce((sum, { pid }) => sum + residentMb(pid), 0));
      await delay((1000 * seconds) / readings);
      await until('another set', () => stateOf(page), ({ shownSets }) => shownSets > warm.shownSets + i);
    }
    const third = Math.floor(readings / 3);
    const growth_mb = mean(used.slice(-third)) - mean(used.slice(0, third));
    const now = await stateOf(page);
    t.diagnostic(
      `${now.shownSets - warm.shownSets} sets; ${used.map(Math.round).join(', ')} MB; growth ${growth_mb.toFixed(1)} MB`,
    );
    assert.deepEqual(now.kept, warm.kept, 'textures and geometries');
    assert.ok(growth_mb < mostGrowth_mb, `${growth_mb} MB`);
    assert.deepEqual(page.complaints, []);
  });
});
