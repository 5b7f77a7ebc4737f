// SPDX-License-Identifier: Apache-2.0
// The page in a browser that denies it something: storage, scripts, its graphics context, colours of its own.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { openPage, startBrowser } from './browser.mjs';
import { requireBuilt, startHub, startSensor } from './programs.mjs';
import { panelText, slow, stateOf, until, untilAllShown } from './waiting.mjs';

describe('a browser that', () => {
  let hub, sensor, browser;
  before(async () => {
    requireBuilt();
    hub = await startHub();
    sensor = startSensor(hub, 0, { fps: 3 });
    browser = await startBrowser({ width: 700, height: 500 });
  }, slow);
  after(async () => {
    await browser?.end();
    await sensor?.end();
    await hub?.end();
  }, slow);

  test('blocks all storage shows the room', slow, async () => {
    const page = await browser.context.newPage();
    page.complaints = [];
    page.on('pageerror', (error) => page.complaints.push(error.message));
    await page.addInitScript(() => {
      for (const name of ['localStorage', 'sessionStorage']) {
        Object.defineProperty(window, name, {
          get() {
            throw new DOMException('Access is denied for this document.', 'SecurityError');
          },
        });
      }
    });
    await page.goto(`${hub.page}?panel=1`);
    await page.waitForFunction(() => window.roomcast !== undefined);
    await untilAllShown(page, 1);
    await page.getByText('Light', { exact: true }).click();
    await page.getByText('Running this room').click();
    await page.getByLabel('Token').fill('abc');
    await page.getByRole('button', { name: 'Use it' }).click();
    await until(
      'a reason',
      () => panelText(page),
      (text) => /cookies are blocked/.test(text),
    );
    assert.deepEqual(page.complaints, []);
    await page.close();
  });

  test('takes the graphics context away and gives it back shows the room again', slow, async () => {
    const page = await openPage(browser.context, `${hub.page}?panel=1`);
    await untilAllShown(page, 1);
    await page.evaluate(() => {
      window.context = document.getElementById('room').getContext('webgl2').getExtension('WEBGL_lose_context');
      window.context.loseContext();
    });
    await until(
      'the loss is reported',
      () => panelText(page),
      (text) => /The graphics card has stopped/.test(text),
    );
    page.complaints.length = 0;
    await page.evaluate(() => window.context.restoreContext());
    const { shownSets } = await until(
      'it is live',
      () => stateOf(page),
      (state) => state.phase === 'joined',
    );
    assert.doesNotMatch(await panelText(page), /graphics card/);
    await until(
      'three more sets',
      () => stateOf(page),
      (state) => state.shownSets >= shownSets + 3,
    );
    const colors = await page.evaluate(() => new Set(window.roomcast.picture().rgba).size);
    assert.ok(colors > 50, `a picture of ${colors} values`);
    assert.deepEqual(page.complaints, []);
    await page.close();
  });
});
