// SPDX-License-Identifier: Apache-2.0
// A phone that is turned (as Chromium’s tools pretend it): the view turns with it, and fingers still work.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { seriousFindings } from './accessibility.mjs';
import { openPage, startBrowser } from './browser.mjs';
import { requireBuilt, startHub } from './programs.mjs';
import { slow, until, viewOf } from './waiting.mjs';

const upright = 90;
const name = 'Look by turning the phone';
let hub;

before(async () => {
  requireBuilt();
  hub = await startHub();
}, slow);
after(() => hub?.end(), slow);

describe('a phone', () => {
  test('turns the view when it is turned', slow, async () => {
    const phone = await startBrowser({ width: 390, height: 844, phone: true });
    const page = await openPage(phone.context, `${hub.page}?panel=1&at=0,1.6,3&look=0,1.6,0`);
    const tools = await phone.context.newCDPSession(page);
    const turn = (alpha, beta) => tools.send('DeviceOrientation.setDeviceOrientationOverride', { alpha, beta, gamma: 0 });
    const { yaw, pitch } = await viewOf(page);
    const button = page.getByRole('button', { name, exact: true });
    await turn(100, upright);
    await button.tap();
    await until('it is on', () => button.getAttribute('aria-pressed'), (pressed) => pressed === 'true');
    await turn(100, upright);
    await turn(120, upright + 15);
    const turned = await until('the view has turned', () => viewOf(page), (view) => Math.abs(view.yaw - yaw) > 0.1);
    assert.ok(Math.abs(turned.yaw - yaw - (20 * Math.PI) / 180) < 0.01, `${turned.yaw - yaw}`);
    assert.ok(Math.abs(turned.pitch - pitch - (15 * Math.PI) / 180) < 0.01, `${turned.pitch - pitch}`);
    assert.deepEqual(await seriousFindings(page), []);
    await button.tap();
    await until('it is off', () => button.getAttribute('aria-pressed'), (pressed) => pressed === 'false');
    await turn(200, upright);
    assert.ok(Math.abs((await viewOf(page)).yaw - turned.yaw) < 0.01, 'off');
    await phone.end();
  });

  test('that tells nothing says so', slow, async () => {
    const phone = await startBrowser({ width: 390, height: 844, phone: true });
    const page = await openPage(phone.context, `${hub.page}?panel=1`);
    await page.getByRole('button', { name, exact: true }).tap();
    await page.getByText('This device does not tell how it is turned.').waitFor();
    await phone.end();
  });
});

describe('a computer', () => {
  test('is not offered to be turned', slow, async () => {
    const browser = await startBrowser();
    const page = await openPage(browser.context, `${hub.page}?panel=1`);
    await page.getByRole('button', { name: 'Share this view' }).waitFor();
    assert.equal(await page.getByRole('button', { name, exact: true }).count(), 0);
    await browser.end();
  });
});
