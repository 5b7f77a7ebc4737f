// SPDX-License-Identifier: Apache-2.0
// The page where something is denied: storage, scripts, the graphics context, colours of its own, entry, the hub.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { openPage, startBrowser } from './browser.mjs';
import { adminsToken, requireBuilt, startHub, startSensor } from './programs.mjs';
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
    await until('the panel no longer reports it', () => panelText(page), (text) => !/graphics card/.test(text));
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

  test('has the system’s own colours shows what is chosen and the sensors’ colours', slow, async () => {
    const page = await openPage(browser.context, `${hub.page}?panel=1&mode=mesh`);
    await untilAllShown(page, 1);
    await page.emulateMedia({ forcedColors: 'active' });
    const backOf = (selector) => page.locator(selector).first().evaluate((part) => getComputedStyle(part).backgroundColor);
    const plain = await backOf('#panel');
    for (const group of ['mode', 'theme']) {
      const chosen = await backOf(`input[name=${group}]:checked + span`);
      assert.notEqual(chosen, await backOf(`input[name=${group}]:not(:checked) + span`), group);
    }
    assert.notEqual(await backOf('#panel .sensors .swatch'), plain);
    assert.notEqual(await backOf('#panel .people .swatch'), plain);
    assert.notEqual(await backOf('#panel .dot'), plain);
    await page.emulateMedia({ forcedColors: 'none' });
    await page.close();
  });

  test('runs no scripts, or has not loaded them yet, shows words', slow, async () => {
    const page = await browser.context.newPage();
    await page.emulateMedia({ colorScheme: 'light' });
    await page.route('**/*.js', (route) => route.abort());
    await page.goto(hub.page);
    assert.equal((await page.locator('#progress').innerText()).trim(), 'Loading the page …');
    const back = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    assert.equal(back, 'rgb(233, 237, 242)');
    await page.close();

    const html = await (await fetch(hub.page)).text();
    assert.match(html, /<section id="progress"[^]*<noscript><p>This page draws the room with JavaScript[^]*<\/section>/);
  });

  test('is too slow to blend says so', slow, async () => {
    const page = await openPage(browser.context, `${hub.page}?panel=1&mode=blend`);
    await untilAllShown(page, 1);
    await until(
      'a note exactly while it does not blend',
      async () => [await panelText(page), (await stateOf(page)).quality.mixes],
      ([text, mixes]) => /too slow to blend/.test(text) === !mixes,
    );
    await page.getByLabel('Quality').selectOption('coarse');
    await until('it says what is drawn', () => panelText(page), (text) => /Every 5th reading, the nearest surface, the only sensor, 60 % of/.test(text));
    assert.equal((await stateOf(page)).quality.step, 5);
    await page.reload();
    await untilAllShown(page, 1);
    assert.equal((await stateOf(page)).quality.step, 5, 'it is remembered');
    await page.getByLabel('Quality').selectOption('auto');
    await page.close();
  });
});

describe('a room for which one needs a token', () => {
  let hub, browser;
  const data = mkdtempSync(join(tmpdir(), 'roomcast-closed-'));
  before(async () => {
    hub = await startHub(0, { data });
    const token = await adminsToken(data);
    const headers = { Authorization: `Bearer ${token}` };
    await fetch(`${hub.page}api/v1/rooms`, { method: 'POST', headers, body: '{"name":"closed","view":"token"}' });
    browser = await startBrowser({ width: 500, height: 600 });
  }, slow);
  after(async () => {
    await browser?.end();
    await hub?.end();
    rmSync(data, { recursive: true, force: true });
  }, slow);

  test('asks for it in the message, and does not try again by itself', slow, async () => {
    const page = await openPage(browser.context, `${hub.page}?panel=0&room=closed`);
    const said = await until(
      'the refusal',
      () => panelText(page),
      (text) => /requires a token/.test(text),
    );
    assert.doesNotMatch(said, /Trying again/);
    assert.ok(await page.getByLabel('Token').isVisible(), 'although the panel is closed');
    assert.ok(await page.getByRole('button', { name: 'Try again' }).isVisible());
    await page.close();
  });

  test('whose hub is gone is announced once, not with every second or every try', slow, async () => {
    const page = await openPage(browser.context, `${hub.page}?panel=1&room=room`);
    const says = (pattern) => until(`it says ${pattern}`, () => panelText(page), (text) => pattern.test(text));
    await says(/live/);
    await page.evaluate(() => {
      window.announced = [];
      for (const region of document.querySelectorAll('[aria-live], [role=status], [role=alert]')) {
        const heard = () => window.announced.push(region.textContent);
        new MutationObserver(heard).observe(region, { childList: true, characterData: true, subtree: true });
      }
    });
    await hub.end();
    await says(/does not answer. Trying again in [345] s/);
    const before = await page.evaluate(() => window.announced.length);
    await says(/Trying again in 2 s/);
    await says(/Trying again in [45] s/);
    const announced = await page.evaluate(() => window.announced);
    assert.ok(announced.some((text) => /hub/.test(text)), 'it is announced');
    assert.deepEqual(announced.slice(before), []);
    await page.close();
  });
});
