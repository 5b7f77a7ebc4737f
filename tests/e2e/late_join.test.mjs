// SPDX-License-Identifier: Apache-2.0
// A late viewer of a room with three sensors sees all of it within a second.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { openPage, startBrowser } from './browser.mjs';
import { untilQuiet } from './processor.mjs';
import { requireBuilt, startHub, startSensor } from './programs.mjs';
import { slow, stateOf, until, untilAllShown } from './waiting.mjs';

const sensorCount = 3;
const fps = 4;
const view = 'panel=0&at=0.2,1.7,2.6&look=0,0.9,-1';
const within_ms = 1000;
const softwareDrawing_ms = 1000; // a graphics card needs only a few milliseconds
const fewestArrivals = 3;
const mostArrivals = 10;

describe('a late viewer', () => {
  let hub, sensors, browser;
  before(async () => {
    requireBuilt();
    hub = await startHub();
    sensors = Array.from({ length: sensorCount }, (_, n) => startSensor(hub, n, { fps }));
    browser = await startBrowser();
    const first = await openPage(browser.context, `${hub.page}?${view}`);
    await untilAllShown(first, sensorCount); // the room is running
    await first.close(); // no other viewer may draw in software next to the late one
  }, slow);
  after(async () => {
    await browser?.end();
    await Promise.all([...(sensors ?? []), hub].map((program) => program?.end()));
  }, slow);

  async function arrive() {
    const free = await untilQuiet();
    const page = await openPage(browser.context, `${hub.page}?${view}`);
    const isSeen = (state) => state.firstShown_ms !== null;
    const { firstDecoded_ms, firstShown_ms } = await until('all drawn', () => stateOf(page), isSeen);
    await page.close();
    return { firstDecoded_ms, firstShown_ms, free };
  }

  // Other load on the machine is not the room's fault, so the fastest of several joins counts.
  test('sees all sensors within a second', { timeout: 600_000 }, async (t) => {
    const arrivals = [];
    const isInTime = ({ firstDecoded_ms, firstShown_ms }) =>
      firstDecoded_ms <= within_ms && firstShown_ms <= within_ms + softwareDrawing_ms;
    while (arrivals.length < fewestArrivals || (arrivals.length < mostArrivals && !arrivals.some(isInTime))) {
      arrivals.push(await arrive());
    }
    const listed = arrivals.map(
      ({ firstDecoded_ms, firstShown_ms, free }) =>
        `decoded ${Math.round(firstDecoded_ms)}, drawn ${Math.round(firstShown_ms)} (${free.toFixed(1)} cores free before)`,
    );
    t.diagnostic(`ms after asking for the socket: ${listed.join('; ')}`);
    assert.ok(arrivals.some(isInTime), listed.join('; '));
  });
});
