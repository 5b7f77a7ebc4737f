// SPDX-License-Identifier: Apache-2.0
// An admin's use of the console, and its accessibility for users of a keyboard or a screen reader (axe).
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { seriousFindings } from './accessibility.mjs';
import { openPage, startBrowser } from './browser.mjs';
import { adminsToken, binary, requireBuilt, startHub, startSensor } from './programs.mjs';
import { slow, until, untilAllShown } from './waiting.mjs';

const view = 'panel=1&mode=points&at=0.2,1.7,2.6&look=0,0.9,-1';

describe('the console', () => {
  const data = mkdtempSync(join(tmpdir(), 'roomcast-console-'));
  let hub, sensors, browser, token;

  before(async () => {
    requireBuilt();
    hub = await startHub(0, { data });
    token = await adminsToken(data);
    sensors = [0, 1].map((n) => startSensor(hub, n, { fps: 2 }));
    browser = await startBrowser({ width: 1000, height: 640 });
  }, slow);

  after(async () => {
    await browser?.end();
    await Promise.all([...(sensors ?? []), hub].map((program) => program?.end()));
    rmSync(data, { recursive: true, force: true });
  }, slow);

  const open = (page) => page.getByRole('button', { name: 'Console', exact: true }).click();
  const tab = (page, name) => page.getByRole('tab', { name }).click();

  test('is offered only with an admin’s token', slow, async () => {
    const page = await openPage(browser.context, `${hub.page}?${view}`);
    await untilAllShown(page, 2);
    assert.equal(await page.getByRole('button', { name: 'Console', exact: true }).count(), 0);
    assert.deepEqual(await seriousFindings(page), []);
    const loaded = await page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name));
    assert.ok(loaded.every((name) => !/console/.test(name)), 'nor is it loaded');
    await page.close();
  });

  test('that could not be loaded is explained, and loaded at the next click', slow, async () => {
    const page = await browser.context.newPage();
    await page.route('**/console-*.js', (route) => route.abort());
    await page.goto(`${hub.page}?${view}#token=${token}`);
    await page.getByText('The console could not be loaded.').first().waitFor();
    await page.unroute('**/console-*.js');
    await open(page);
    await page.getByRole('tab', { name: 'Alignment' }).waitFor();
    await page.getByText('The console could not be loaded.').first().waitFor({ state: 'hidden' });
    await page.close();
  });

  describe('of an admin who places sensors', () => {
    let page;
    before(async () => {
      page = await openPage(browser.context, `${hub.page}?${view}#token=${token}`);
      await untilAllShown(page, 2);
      await open(page);
    }, slow);
    after(() => page?.close());

    test('shows each sensor’s picture and rates, and the token is not in the address', slow, async () => {
      assert.ok(!page.url().includes('#'), page.url());
      const figures = () => page.locator('#console .card').allInnerTexts();
      const cards = await until(
        'two cards with figures',
        figures,
        (texts) => texts.length === 2 && texts.every((text) => /\d fps/.test(text)),
      );
      assert.match(cards[0], /MB\/s/);
      const isPainted = () =>
        page
          .locator('.thumbnail')
          .first()
          .evaluate((canvas) => {
            const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
            return new Set(data).size > 20;
          });
      await until('a live thumbnail', isPainted, (painted) => painted);
      assert.deepEqual(await seriousFindings(page), []);
    });

    test('makes a picture larger, and tells the value of a time in a chart', slow, async () => {
      const card = page.locator('#console .card').first();
      const width = async () => (await card.locator('.thumbnail').boundingBox()).width;
      const small = await width();
      await card.getByRole('button', { name: 'What s0 sees' }).press('Enter');
      assert.ok((await width()) > 1.8 * small, `${await width()} after ${small}`);
      await until('every pixel', () => card.locator('.thumbnail').evaluate((canvas) => canvas.width), (px) => px >= 320);
      assert.deepEqual(await seriousFindings(page), []);
      await card.getByRole('button', { name: 'What s0 sees' }).press('Enter');
      const chart = card.locator('.chart').first();
      assert.match(await chart.innerText(), /frames\s+[\d.–]+[^]*10 fps[^]*3 min ago\s+now/);
      const plot = await chart.locator('.plot').boundingBox();
      await page.mouse.move(plot.x + 0.5 * plot.width, plot.y + plot.height / 2);
      assert.match(await chart.innerText(), /, (89|90) s ago/);
      await page.mouse.move(0, 0);
    });

    test('shows the gaps of pairs, and that these sensors supplied their poses', slow, async () => {
      await tab(page, 'Alignment');
      await until(
        'the pair',
        () => page.locator('.pairs').innerText(),
        (text) => /s0 and s1\s+\d+ mm over \d+ points/.test(text),
      );
      assert.match(await page.locator('.places').innerText(), /s0[^]*supplied its pose, so it cannot be moved by hand/);
      assert.equal(await page.getByRole('button', { name: 'Move by hand' }).count(), 0);
      await page.locator('.alignment .map [data-sensor]').last().click();
      assert.match(await page.evaluate(() => document.activeElement.innerText), /s1/, 'a press on the map shows its row');
      assert.deepEqual(await seriousFindings(page), []);
    });

    test('works with the keyboard alone', slow, async () => {
      await page.getByRole('tab', { name: 'Alignment' }).focus();
      await page.keyboard.press('ArrowRight');
      assert.equal(await page.evaluate(() => document.activeElement.textContent), 'People');
      await page.getByRole('cell', { name: /fps/ }).first().waitFor();
      await page.keyboard.press('Escape');
      assert.ok(await page.locator('#console').isHidden());
      assert.equal(
        await page.evaluate(() => document.activeElement.textContent),
        'Console',
        'back where one came from',
      );
      assert.deepEqual(page.complaints, []);
    });
  });

  describe('of an admin', () => {
    let page, link;
    const asked = [];
    const askHub = async (path, init) => {
      const headers = { Authorization: `Bearer ${token}` };
      return (await fetch(`${hub.page}api/v1${path}`, { headers, ...init })).json();
    };
    const inRoom = () => askHub('/rooms/room');
    before(async () => {
      page = await openPage(browser.context, `${hub.page}?${view}#token=${token}`);
      page.on('request', (request) => asked.push(request.url()));
      await open(page);
    }, slow);
    after(() => page?.close());

    test('makes a link with its QR code, and a token that it can revoke', slow, async () => {
      await tab(page, 'Access');
      await page.getByLabel('Name of its user').fill('Ada');
      await page.getByRole('button', { name: 'Make it' }).click();
      await page.getByRole('img', { name: 'The link as a QR code' }).waitFor();
      link = await page.getByLabel('Link', { exact: true }).inputValue();
      assert.ok(link.startsWith(`${hub.page}#room=room&code=`), link);

      await page.locator('.access select').first().selectOption('sensor');
      await page.getByLabel('Name of its user').fill('left');
      await page.getByLabel('One-time link').uncheck();
      await page.getByRole('button', { name: 'Make it' }).click();
      const command = await until(
        'a command',
        () => page.getByLabel('Command').inputValue(),
        (text) => text !== '',
      );
      assert.match(command, /^roomcast sensor .*--hub ws:.* --room room --token [\w-]+\.[\w-]+\.[\w-]+$/);
      assert.deepEqual(await seriousFindings(page), []);
      await page.getByRole('button', { name: 'Revoke: left' }).click();
      await page.keyboard.press('Escape');
      assert.ok(await page.locator('#console').isVisible(), 'only the question is gone');
      await page.getByRole('button', { name: 'Revoke: left' }).click();
      await page.getByRole('button', { name: 'Revoke for good?: left' }).click();
      await until(
        'it is revoked',
        () => page.locator('.tokens').innerText(),
        (text) => /revoked/.test(text),
      );
      assert.ok(
        asked.length > 0 && asked.every((url) => !/token=|code=/.test(url) && !url.includes(token)),
        'no token is in an address',
      );
    });

    test('changes the room’s settings and opens another room', slow, async () => {
      await tab(page, 'Room');
      await page.getByLabel('Maximum viewers').fill('64');
      await page.getByLabel('Who may view').selectOption('token');
      await page.getByRole('button', { name: 'Save' }).click();
      await until(
        'it is saved',
        () => page.locator('.room-settings').innerText(),
        (text) => /Saved/.test(text),
      );
      assert.equal((await inRoom()).max_viewers, 64);
      assert.equal((await inRoom()).view, 'token');
      await page.getByLabel('New room').fill('studio');
      await page.getByRole('button', { name: 'Open it' }).click();
      const studio = page.getByRole('link', { name: 'studio' });
      await studio.waitFor();
      assert.equal(await studio.getAttribute('href'), '?room=studio');
      assert.deepEqual(await seriousFindings(page), []);
    });

    test('records the room from a click to the next one', slow, async () => {
      const bar = page.locator('#console .recording');
      await bar.getByRole('button', { name: 'Start recording' }).click();
      const name = /roomcast-room-0001\.mcap, 0:0[2-9]/;
      await until(
        'two seconds of it',
        () => bar.innerText(),
        (text) => /The hub is recording this room/.test(text) && name.test(text),
      );
      assert.deepEqual(await seriousFindings(page), []);
      await bar.getByRole('button', { name: 'Stop recording' }).click();
      await bar.getByRole('button', { name: 'Start recording', disabled: false }).waitFor();
      const file = join(data, 'recordings', 'roomcast-room-0001.mcap');
      const { sensors: kept } = JSON.parse(execFileSync(binary, ['info', file, '--json'], { encoding: 'utf8' }));
      assert.deepEqual(kept.map(({ id }) => id).sort(), ['s0', 's1']);
      assert.ok(kept.every(({ frames }) => frames >= 2), JSON.stringify(kept));
    });

    test('shows the hub’s reason for a refusal', slow, async () => {
      await page.getByLabel('New room').fill('studio');
      await page.getByRole('button', { name: 'Open it' }).click();
      await until(
        'the sentence',
        () => page.locator('.room-settings').innerText(),
        (text) => /there is a room of this name already/.test(text),
      );
    });

    test('chooses where people enter, by standing there', slow, async () => {
      await tab(page, 'Room');
      await page.evaluate(() => window.roomcast.setView([1.25, 1.5, -0.5], [5, 1.5, -0.5]));
      await page.getByRole('button', { name: 'Add where I stand' }).click();
      await page.getByText('1: 1.3 m, -0.5 m, looking to 90°').waitFor();
      assert.deepEqual((await inRoom()).start_positions, [{ x: 1.25, z: -0.5, eye_height: 1.5, yaw_deg: -90 }]);
      const visitor = await openPage(browser.context, `${hub.page}?panel=0#room=room&token=${token}`);
      await until('the visitor stands there', () => visitor.evaluate(() => window.roomcast?.view().position), (at) =>
        at && Math.abs(at[0] - 1.25) < 0.01 && Math.abs(at[2] + 0.5) < 0.01);
      await visitor.close();
      await page.getByRole('button', { name: 'Remove place 1' }).click();
      await page.getByText('Next to the sensors.').waitFor();
      assert.deepEqual(await seriousFindings(page), []);
    });

    const panelSays = (visitor, pattern) =>
      until(
        `the panel says ${pattern}`,
        () => visitor.locator('#panel').innerText(),
        (text) => pattern.test(text),
      );

    test('has admitted others by a one-time link', slow, async () => {
      const visitor = await openPage(browser.context, link);
      await panelSays(visitor, /live/);
      await visitor.reload();
      await panelSays(visitor, /live/); // admitted by the token received in exchange for the code
      await visitor.close();
      const late = await openPage(browser.context, link);
      await panelSays(late, /one-time link has been used/);
      await late.close();
    });

    test('has opened a second room, and viewers without a room’s name choose one', slow, async () => {
      await askHub('/rooms/studio', { method: 'PATCH', body: '{"view":"anyone"}' });
      const visitor = await openPage(browser.context, `${hub.page}?panel=1`);
      await panelSays(visitor, /several rooms: choose one/);
      await panelSays(visitor, /room\s+2 sensors, \d (person|people) · with a link only/);
      assert.deepEqual(await seriousFindings(visitor), []);
      await visitor.getByRole('link', { name: 'studio' }).click();
      await panelSays(visitor, /studio[^]*live/);
      await until(
        'it is marked',
        () => visitor.getByRole('link', { name: 'studio' }).getAttribute('aria-current'),
        (current) => current === 'page',
      );
      await visitor.close();
    });

    test('closes a room after a question', slow, async () => {
      const studio = await openPage(browser.context, `${hub.page}?${view}&room=studio#token=${token}`);
      const guest = await openPage(browser.context, `${hub.page}?panel=1&room=studio`);
      await panelSays(guest, /studio[^]*live/);
      await open(studio);
      await tab(studio, 'Room');
      await studio.getByRole('button', { name: 'Close this room: studio' }).click();
      await studio.getByRole('button', { name: 'Close it, for all?: studio' }).click();
      await panelSays(guest, /this room was closed|no room of that name/);
      const { rooms } = await askHub('/rooms');
      assert.deepEqual(rooms.map(({ name }) => name), ['room']);
      await Promise.all([studio.close(), guest.close()]);
    });
  });
});
