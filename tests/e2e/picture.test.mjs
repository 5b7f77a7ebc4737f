// SPDX-License-Identifier: Apache-2.0
// Compares the page's pixels with those of `roomcast view`, of the same room from the same viewpoint: a recording of a
// simulated static room. Both blend surfaces by the same rules; `roomcast view` also matches the cameras' colours and
// sharpens.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { openPage, startBrowser } from './browser.mjs';
import { requireBuilt, run, startHub, startSensor } from './programs.mjs';
import { sensorsOf, slow, stateOf, until, untilAllShown } from './waiting.mjs';

const sensors = 2;
const size = [400, 300];
const at = '0.2,1.7,2.2';
const look = '0,0.9,-1';
const still = ['--fps', '2', '--seconds', '1', '--speed', '0', '--drops', '0', '--half-color', '--views', '0'];
const enoughFrames = 12; // a background is drawn after eight readings
const leastAlike_dB = 28;
const leastBlendGain_dB = 1; // compared with the nearest surface alone

/** Runs in the page. Peak signal-to-noise ratio of the room as drawn now against a PNG. */
async function likeness(png) {
  const image = new Image();
  image.src = `data:image/png;base64,${png}`;
  await image.decode();
  const paint = new OffscreenCanvas(image.width, image.height).getContext('2d');
  paint.drawImage(image, 0, 0);
  const wanted = paint.getImageData(0, 0, image.width, image.height).data;
  const { rgba, width, height } = window.roomcast.picture();
  let squares = 0;
  for (let i = 0; i < rgba.length; i++) if (i % 4 < 3) squares += (rgba[i] - wanted[i]) ** 2;
  const same = width === image.width && height === image.height;
  return { same, psnr_dB: 10 * Math.log10((255 ** 2 * 3 * width * height) / squares) };
}

test('the page draws the same picture as roomcast view', slow, async (t) => {
  requireBuilt();
  const folder = mkdtempSync(join(tmpdir(), 'roomcast-picture-'));
  t.after(() => rmSync(folder, { recursive: true, force: true }));
  const rig = join(folder, 'rig');
  await run('simulate', rig, '--sensors', String(sensors), ...still);
  const hub = await startHub(0, { more: ['--no-model'] }); // the window has none
  t.after(() => hub.end());
  for (let n = 0; n < sensors; n++) {
    const sensor = startSensor(hub, n, { rig });
    t.after(() => sensor.end());
  }
  const png = join(folder, 'view.png');
  const place = ['--at', at, '--look', look, '--size', size.join(',')];
  await run('view', '--hub', `ws://127.0.0.1:${hub.port}`, '--headless', '--png', png, ...place, '--seconds', '8');

  const browser = await startBrowser({ width: size[0], height: size[1] });
  t.after(() => browser.end());
  const loaded = [];
  browser.context.on('response', (response) => loaded.push(response.url()));
  const page = await openPage(browser.context, `${hub.page}?panel=0&quality=best&at=${at}&look=${look}`);
  await untilAllShown(page, sensors);
  await until(
    'enough frames',
    () => stateOf(page),
    ({ shownSets }) => shownSets > enoughFrames,
  );
  const wanted = readFileSync(png).toString('base64');
  const blend = await page.evaluate(likeness, wanted);
  await page.evaluate(() => window.roomcast.setMode('mesh'));
  const mesh = await page.evaluate(likeness, wanted);
  t.diagnostic(
    `PSNR against roomcast view: blended ${blend.psnr_dB.toFixed(2)} dB, mesh ${mesh.psnr_dB.toFixed(2)} dB`,
  );
  assert.ok(blend.same, 'of the same size');
  assert.ok(blend.psnr_dB >= leastAlike_dB, `blended ${blend.psnr_dB} dB`);
  assert.ok(blend.psnr_dB >= mesh.psnr_dB + leastBlendGain_dB, `blended ${blend.psnr_dB} dB, mesh ${mesh.psnr_dB} dB`);
  assert.equal((await sensorsOf(page)).length, sensors);
  assert.ok(loaded.some((url) => /roomcast_flow-.*\.wasm/.test(url)), `motion of several sensors: ${loaded}`);
  assert.deepEqual(page.complaints, []);
});
