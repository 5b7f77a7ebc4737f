// SPDX-License-Identifier: Apache-2.0
// The page in a browser that denies it something: storage, scripts, its graphics context, colours of its own.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { openPage, startBrowser } from './browser.mjs';
import { requireBuilt, startHub, startSensor } from './programs.mjs';
import { panelText, sensorsOf, slow, stateOf, until, untilAllShown } from './waiting.mjs';

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
});
