// SPDX-License-Identifier: Apache-2.0
// The model of what stands still in a running room: the hub makes it of what sensors send, the page gets and draws it,
// and it stays when the sensors leave and when the hub starts again.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { openPage, startBrowser } from './browser.mjs';
import { requireBuilt, startHub, startSensor } from './programs.mjs';
import { sensorsOf, slow, stateOf, until, untilAllShown } from './waiting.mjs';

const sensors = 2;
const leastTriangles = 5000;

/** Runs in the page. How many different colours the picture has, in steps of 16 levels. */
function colors() {
  const { rgba } = window.roomcast.picture();
  const seen = new Set();
  for (let i = 0; i < rgba.length; i += 4) seen.add(`${rgba[i] >> 4} ${rgba[i + 1] >> 4} ${rgba[i + 2] >> 4}`);
  return seen.size;
}

const untilModelled = (page) =>
  until('the model', () => stateOf(page), ({ modelTriangles }) => modelTriangles > leastTriangles);

test('the still room is there without its sensors, and after a restart of the hub', slow, async (t) => {
  requireBuilt();
  const data = mkdtempSync(join(tmpdir(), 'roomcast-model-'));
  let hub = await startHub(0, { data });
  t.after(async () => {
    await hub.end();
    rmSync(data, { recursive: true, force: true });
  });
  const running = Array.from({ length: sensors }, (_, n) => startSensor(hub, n));
  t.after(() => Promise.all(running.map((sensor) => sensor.end())));
  const browser = await startBrowser({ width: 320, height: 240 });
  t.after(() => browser.end());
  const page = await openPage(browser.context, `${hub.page}?panel=0&at=0.2,1.7,2.2&look=0,0.9,-1`);
  await untilAllShown(page, sensors);
  const { modelTriangles } = await untilModelled(page);
  t.diagnostic(`${modelTriangles} triangles`);
  await Promise.all(running.map((sensor) => sensor.end()));
  await until('no sensor', () => sensorsOf(page), (all) => all.every(({ online }) => !online));
  await page.evaluate(() => window.roomcast.setMode('still'));
  const shown = await page.evaluate(colors);
  assert.ok(shown > 8, `${shown} colours: a picture of a room`);
  await page.evaluate((count) => {
    for (let id = 0; id < count; ++id) window.roomcast.setVisible(id, false);
    window.roomcast.setMode('blend');
  }, sensors);
  const filled = await page.evaluate(colors);
  const { quality } = await stateOf(page);
  t.diagnostic(quality.mixes ? 'blends' : 'is too slow to blend');
  assert.ok(filled > 8, `${filled} colours: the model fills what no sensor shows, also where blending is too slow`);
  assert.deepEqual(page.complaints, []);

  await hub.end();
  hub = await startHub(0, { data });
  const address = `http://127.0.0.1:${hub.port}/api/v1/rooms/room/model`;
  const model = await until('the model again', () => fetch(address), ({ status }) => status === 200);
  const bytes = Buffer.from(await model.arrayBuffer());
  assert.equal(bytes.subarray(0, 3).toString(), 'RCM');
  t.diagnostic(`${bytes.length} bytes`);
  const version = bytes.readBigUInt64LE(8);
  assert.equal((await fetch(`${address}/after/${version}`)).status, 204);
});
