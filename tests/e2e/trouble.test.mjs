// SPDX-License-Identifier: Apache-2.0
// The page's messages when something is missing, and navigation in the room.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { openPage, startBrowser } from './browser.mjs';
import { requireBuilt, startHub, startSensor } from './programs.mjs';
import { distance, panelText, sensorsOf, slow, stateOf, until, untilAllShown } from './waiting.mjs';

// (module (func 0xff))
const moduleWithUnknownInstruction = Buffer.from('0061736d01000000010401600000030201000a05010300ff0b', 'hex');
let hub, sensor, browser;

describe('a room of one sensor, or none', () => {
  before(async () => {
    requireBuilt();
    hub = await startHub();
    browser = await startBrowser({ width: 400, height: 700 });
  }, slow);

  after(async () => {
    await browser?.end();
    await sensor?.end();
    await hub?.end();
  }, slow);

  const untilPanelSays = (page, pattern) =>
    until(
      `the panel says ${pattern}`,
      () => panelText(page),
      (text) => pattern.test(text),
    );

  test('a room without sensors shows how to add one, and then the first one that joins', slow, async () => {
    const page = await openPage(browser.context, `${hub.page}?panel=1`);
    await untilPanelSays(page, new RegExp(`No sensor is in the room yet.*--hub ws://127.0.0.1:${hub.port}`));
    sensor = startSensor(hub, 0, { fps: 4 });
    await untilAllShown(page, 1);
    const [only] = await sensorsOf(page);
    await untilPanelSays(page, new RegExp(only.name));
    assert.doesNotMatch(await panelText(page), /No sensor/);
    await page.close();
  });

  test('a decoder that cannot be loaded is reported, and nothing is drawn', slow, async () => {
    const page = await browser.context.newPage();
    await browser.context.route('**/*.wasm', (route) => route.abort());
    await page.goto(`${hub.page}?panel=1`);
    await untilPanelSays(page, /The depth decoder could not be loaded/);
    assert.equal((await stateOf(page)).phase, 'broken');
    await browser.context.unroute('**/*.wasm');
    await page.close();
  });

  test('a browser without WebAssembly SIMD decodes with the plain module', slow, async () => {
    const loaded = [];
    await browser.context.route('**/*.wasm', (route) => {
      loaded.push(route.request().url());
      // Simulates a browser without SIMD, for which SIMD code is an unknown instruction.
      if (/roomcast_codec-/.test(route.request().url())) return route.fulfill({ body: moduleWithUnknownInstruction });
      return route.continue();
    });
    const page = await openPage(browser.context, `${hub.page}?panel=0`);
    await untilAllShown(page, 1);
    assert.equal(loaded.length, 2);
    assert.match(loaded[1], /roomcast_codec_plain-/);
    await browser.context.unroute('**/*.wasm');
    await page.close();
  });

  test('keys and mouse move the view, R goes back', slow, async () => {
    const page = await openPage(browser.context, `${hub.page}?panel=0`);
    await untilAllShown(page, 1);
    const viewOf = () => page.evaluate(() => window.roomcast.view());
    const start = await viewOf();
    await page.keyboard.down('KeyW');
    await until('it walks', viewOf, (view) => distance(view.position, start.position) > 0.2);
    await page.keyboard.up('KeyW');
    const ahead = await viewOf();
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('ArrowUp');
    assert.ok((await viewOf()).yaw > ahead.yaw + 0.03, 'an arrow key turns');
    assert.ok((await viewOf()).pitch > ahead.pitch + 0.03, 'an arrow key tilts');
    const walked = await viewOf();
    await page.mouse.move(200, 300);
    await page.mouse.down();
    await page.mouse.move(260, 300, { steps: 3 });
    await page.mouse.up();
    assert.ok(Math.abs((await viewOf()).yaw - walked.yaw) > 0.1, 'a drag turns');
    const turned = await viewOf();
    await page.mouse.wheel(0, -300);
    await until('the wheel goes nearer', viewOf, (view) => distance(view.position, turned.position) > 0.1);
    await page.keyboard.press('KeyR');
    assert.ok(distance((await viewOf()).position, start.position) < 1e-6);
    await page.close();
  });

  test('one finger turns the head, two fingers zoom', slow, async () => {
    const page = await openPage(browser.context, `${hub.page}?panel=0&at=0,1.6,2&look=0,1,-1`);
    const screen = await browser.context.newCDPSession(page);
    const touch = (type, ...places) =>
      screen.send('Input.dispatchTouchEvent', { type, touchPoints: places.map(([x, y], id) => ({ x, y, id })) });
    const viewOf = () => page.evaluate(() => window.roomcast.view());
    const start = await viewOf();
    await touch('touchStart', [200, 300]);
    await touch('touchMove', [280, 300]);
    await touch('touchEnd');
    const turned = await until('it turns', viewOf, (view) => Math.abs(view.yaw - start.yaw) > 0.1);
    assert.ok(distance(turned.position, start.position) < 1e-6);
    await touch('touchStart', [180, 300], [220, 300]);
    await touch('touchMove', [120, 300], [280, 300]);
    await touch('touchEnd');
    await until('it goes nearer', viewOf, (view) => distance(view.position, turned.position) > 0.5);
    await page.close();
  });
});
