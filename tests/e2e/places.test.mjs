// SPDX-License-Identifier: Apache-2.0
// Where one stands in the room: shared addresses, the first minute, going to a place, following a person, and the same
// with fingers on a phone. One room of one sensor for all.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { get } from 'node:http';
import { after, before, describe, test } from 'node:test';
import { seriousFindings } from './accessibility.mjs';
import { openPage, startBrowser } from './browser.mjs';
import { oneSensorRoom } from './one_sensor_room.mjs';
import { distance, panelText, slow, stateOf, until, untilAllShown, untilStill, viewOf } from './waiting.mjs';

const view = 'mode=mesh&at=0.2,1.7,2.6&look=0,0.9,-1';
const room = oneSensorRoom('places');

const open = (more = '') => openPage(room.browser.context, `${room.hub.page}?panel=1&${view}${more}`);
/** Bytes of a file as a browser gets it, compressed. */
function packedSize(url) {
  return new Promise((resolve, reject) => {
    get(url, { headers: { 'accept-encoding': 'gzip' } }, async (response) => {
      let size = 0;
      for await (const piece of response) size += piece.length;
      resolve(size);
    }).on('error', reject);
  });
}

const share = (page) => page.getByRole('button', { name: 'Share this view' }).click();
const sharedBy = (page) => page.getByLabel('Address of this view').inputValue();

describe('a shared view', () => {
  test('opens where its owner stood, and tells nobody their token', slow, async () => {
    const page = await open(`&name=Ada#token=${room.token}`);
    await until('it is live', () => stateOf(page), ({ phase }) => phase === 'joined');
    await page.evaluate(() => window.roomcast.setView([1, 1.5, 1.25], [0, 0.5, -2]));
    await page.evaluate(() => window.roomcast.setMode('points'));
    const there = await viewOf(page);
    await room.browser.context.grantPermissions(['clipboard-read', 'clipboard-write'], { origin: room.hub.page });
    await share(page);
    const address = await sharedBy(page);
    await until('it says so', () => panelText(page), (text) => /Copied.*Your token is not in it/.test(text));
    assert.equal(await page.evaluate(() => navigator.clipboard.readText()), address);
    assert.equal(address, `${room.hub.page}?room=room#at=1,1.5,1.25&look=0,0.5,-2&mode=points`);
    assert.ok(!page.url().includes(room.token) && page.url().endsWith('#at=1,1.5,1.25&look=0,0.5,-2&mode=points'), page.url());

    await page.reload();
    await page.waitForFunction(() => window.roomcast !== undefined);
    await page.getByRole('button', { name: 'Console', exact: true }).waitFor(); // the token was kept
    assert.ok(distance((await viewOf(page)).position, there.position) < 2e-3, 'a reload stays there');
    await page.close();

    const other = await openPage(room.browser.context, address);
    await untilAllShown(other, 1);
    const seen = await viewOf(other);
    assert.ok(distance(seen.position, there.position) < 2e-3 && Math.abs(seen.yaw - there.yaw) < 2e-3);
    assert.equal(await other.locator('input[name=mode]:checked').inputValue(), 'points');
    await other.getByRole('button', { name: 'Share this view' }).focus();
    await other.keyboard.press('Enter');
    await until('it says less', () => panelText(other), (text) => /Copied/.test(text) && !/token/.test(text));
    await other.close();
  });

  test('that is opened in the same tab moves one there, and a token beside it is used and not lost', slow, async () => {
    const page = await open();
    await until('it is live', () => stateOf(page), ({ phase }) => phase === 'joined');
    await page.evaluate(() => (location.hash = '#at=2,1.4,0&look=0,1,0&mode=points'));
    await until('it is there', () => viewOf(page), ({ position }) => distance(position, [2, 1.4, 0]) < 1e-6);
    await page.evaluate((secret) => (location.hash = `#at=1,1.4,0&look=0,1,0&token=${secret}`), room.token);
    await page.waitForFunction(() => location.hash === '#at=1,1.4,0&look=0,1,0' && window.roomcast !== undefined);
    await page.getByRole('button', { name: 'Console', exact: true }).waitFor();
    assert.ok(distance((await viewOf(page)).position, [1, 1.4, 0]) < 1e-6);
    await page.close();
  });

  test('that is broken or out of this world is ignored', slow, async () => {
    for (const fragment of ['#at=NaN,1,1&look=0,0,0', '#at=1e300,1,1&look=0,0,0', '#at=1,2&look=0,0,0', '#%00%at']) {
      const page = await open(fragment);
      await until('it is live', () => stateOf(page), ({ phase }) => phase === 'joined');
      assert.ok(distance((await viewOf(page)).position, [0.2, 1.7, 2.6]) < 1e-6, fragment);
      assert.ok(!page.url().includes('#'), page.url());
      assert.deepEqual(page.complaints, []);
      await page.close();
    }
    const far = await open('#at=9000,-50,0&look=0,1,0');
    await untilAllShown(far, 1);
    const { position } = await viewOf(far);
    assert.ok(distance(position, [0, 0, 0]) < 100 && position[1] >= 0.1, `brought back to the room: ${position}`);
    await far.close();
  });

  test('can be copied by hand where the browser gives no clipboard', slow, async () => {
    const page = await open();
    await page.evaluate(() => Object.defineProperty(navigator, 'clipboard', { value: undefined }));
    await share(page);
    await until('it says so', () => panelText(page), (text) => /Copy the address above/.test(text));
    const selected = await page.evaluate(() => {
      const { value, selectionStart, selectionEnd } = document.activeElement;
      return value.slice(selectionStart, selectionEnd);
    });
    assert.equal(selected, await sharedBy(page));
    assert.deepEqual(page.complaints, []);
    await page.close();
  });
});

describe('the first minute', () => {
  test('says on the room how to move until one has, once a visit', slow, async () => {
    const page = await open();
    await untilAllShown(page, 1);
    const hint = page.locator('#hint');
    await hint.waitFor();
    assert.match(await hint.innerText(), /Drag to turn.*W A S D/);
    assert.deepEqual(await seriousFindings(page), []);
    await page.mouse.move(700, 300);
    await page.mouse.down();
    await page.mouse.up();
    assert.ok(await hint.isVisible(), 'a click does not move');
    await page.keyboard.press('ArrowLeft');
    await hint.waitFor({ state: 'hidden' });
    await page.reload();
    await page.waitForFunction(() => window.roomcast !== undefined);
    await untilAllShown(page, 1);
    await page.waitForTimeout(600);
    assert.ok(await hint.isHidden(), 'it is remembered');
    await page.close();
  });

  test('has the hint also where the browser keeps nothing', slow, async () => {
    const page = await room.browser.context.newPage();
    page.complaints = [];
    page.on('pageerror', (error) => page.complaints.push(error.message));
    await page.addInitScript(() => {
      for (const name of ['localStorage', 'sessionStorage'])
        Object.defineProperty(window, name, {
          get() {
            throw new DOMException('Access is denied for this document.', 'SecurityError');
          },
        });
    });
    await page.goto(`${room.hub.page}?panel=1&${view}`);
    await page.locator('#hint').waitFor();
    await page.locator('#room').focus();
    await page.keyboard.press('KeyW');
    await page.locator('#hint').waitFor({ state: 'hidden' });
    assert.deepEqual(page.complaints, []);
    await page.close();
  });
});

describe('one’s name', () => {
  test('is asked for where none was given, shown to the others at once, and remembered', slow, async () => {
    const other = await open('&name=Bob');
    const page = await open();
    await untilAllShown(page, 1);
    const field = page.getByLabel('Your name, as the others see it');
    await field.fill('  Ada ');
    await page.keyboard.press('Enter');
    await other.getByRole('button', { name: 'Follow Ada' }).waitFor();
    await until('it is one’s own', () => panelText(page), (text) => /Ada \(you\)/.test(text));
    assert.equal(await page.evaluate(() => document.activeElement.textContent), 'Change your name');
    assert.doesNotMatch(await panelText(page), /connection to the hub/);
    assert.deepEqual((await stateOf(page)).viewers.map(({ name }) => name).sort(), ['Ada', 'Bob']);
    await untilAllShown(page, 1);
    await page.reload();
    await page.waitForFunction(() => window.roomcast !== undefined);
    await until('it is remembered', () => panelText(page), (text) => /Ada \(you\)/.test(text));
    await page.getByRole('button', { name: 'Change your name' }).click();
    assert.equal(await field.inputValue(), 'Ada');
    assert.deepEqual(await seriousFindings(page), []);
    await page.keyboard.press('Escape');
    assert.ok(await field.isHidden());
    await page.evaluate(() => localStorage.clear());
    assert.deepEqual(page.complaints, []);
    await page.close();
    await other.close();
  });
});

describe('going somewhere', () => {
  test('a double click goes to the surface that is there, smoothly; G to what is ahead', slow, async () => {
    const page = await open();
    await untilAllShown(page, 1);
    const start = await viewOf(page);
    const goBack = () => page.evaluate(() => window.roomcast.setView([0.2, 1.7, 2.6], [0, 0.9, -1]));
    await page.evaluate(() => setInterval(() => window.way?.add(window.roomcast.view().position.join()), 10));
    const placesOnTheWay = async () => {
      await goBack();
      await page.evaluate(() => (window.way = new Set()));
      await page.mouse.dblclick(660, 300);
      const there = await until('it has come nearer', () => viewOf(page), ({ position }) => distance(position, start.position) > 0.5);
      assert.equal(there.position[1], start.position[1], 'the height stays');
      await untilStill(page);
      return page.evaluate(() => window.way.size);
    };
    // On a busy machine a picture may take longer than the whole way.
    await until('there were places between', placesOnTheWay, (places) => places > 2);
    await goBack();
    await page.keyboard.press('KeyG');
    await until('it goes ahead', () => viewOf(page), ({ position }) => distance(position, start.position) > 0.5);
    assert.deepEqual(page.complaints, []);
    await page.close();
  });

  test('is at once for those who prefer less motion', slow, async () => {
    const page = await open();
    await untilAllShown(page, 1);
    await page.emulateMedia({ reducedMotion: 'reduce' });
    await page.evaluate(() => {
      window.way = new Set();
      const note = () => (window.way.add(window.roomcast.view().position.join()), requestAnimationFrame(note));
      note();
    });
    await page.locator('#room').focus();
    await page.keyboard.press('KeyG');
    const places = () => page.evaluate(() => window.way.size);
    await until('it is elsewhere', places, (count) => count > 1);
    await untilStill(page);
    assert.equal(await places(), 2);
    await page.close();
  });

  test('neither dragging nor zooming gets lost', slow, async () => {
    const page = await open();
    await untilAllShown(page, 1);
    await page.mouse.move(700, 300);
    for (let i = 0; i < 60; i++) await page.mouse.wheel(0, 300);
    const { position } = await viewOf(page);
    assert.ok(distance(position, [0, 1, 0]) < 40 && position[1] >= 0.1, `${position}`);
    await page.close();
  });
});

describe('one’s own view', () => {
  test('fills the screen by button and by key', slow, async () => {
    const page = await open();
    await page.getByRole('button', { name: 'Full screen (F)', exact: true }).click();
    await page.getByRole('button', { name: 'Leave full screen (F)' }).waitFor();
    assert.ok(await page.evaluate(() => document.fullscreenElement !== null));
    await page.locator('#room').focus();
    await page.keyboard.press('KeyF');
    await page.getByRole('button', { name: 'Full screen (F)', exact: true }).waitFor();
    await page.close();
  });

  test('is saved as a PNG of the canvas’s size, with the date in its name', slow, async () => {
    const page = await open();
    await untilAllShown(page, 1);
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: 'Take a picture' }).click(),
    ]);
    assert.match(download.suggestedFilename(), /^roomcast-room-20\d\d-\d\d-\d\d-\d\d-\d\d-\d\d\.png$/);
    const file = readFileSync(await download.path());
    assert.equal(file.subarray(1, 4).toString(), 'PNG');
    assert.deepEqual([file.readUInt32BE(16), file.readUInt32BE(20)], [1000, 640]);
    const facts = await page.evaluate(async (base64) => {
      const image = new Image();
      image.src = `data:image/png;base64,${base64}`;
      const { data } = await image.decode().then(() => {
        const paint = new OffscreenCanvas(image.width, image.height).getContext('2d');
        paint.drawImage(image, 0, 0);
        return paint.getImageData(0, 0, image.width, image.height);
      });
      return { colors: new Set(data).size, opaque: data.every((value, i) => i % 4 < 3 || value === 255) };
    }, file.toString('base64'));
    assert.ok(facts.colors > 50 && facts.opaque, JSON.stringify(facts));
    assert.match(await panelText(page), /Saved as roomcast-room-/);
    await page.close();
  });
});

describe('following a person', () => {
  let ada, bob;
  const follow = () => ada.getByRole('button', { name: 'Follow Bob' });
  const isBeside = async () => distance((await viewOf(ada)).position, (await viewOf(bob)).position);
  before(async () => {
    ada = await open('&name=Ada');
    bob = await open('&name=Bob');
    await untilAllShown(ada, 1);
    await follow().waitFor();
  }, slow);
  after(() => Promise.all([ada?.close(), bob?.close()]));

  test('moves one’s view with theirs until one moves', slow, async () => {
    await follow().click();
    assert.equal(await follow().getAttribute('aria-pressed'), 'true');
    await ada.getByText('You see what Bob sees.').waitFor();
    assert.deepEqual(await seriousFindings(ada), []);
    for (const at of [[1, 1.6, 1], [-1, 1.4, 1.5]]) {
      await bob.evaluate((place) => window.roomcast.setView(place, [0, 1, -1]), at);
      await until('it is with Bob', isBeside, (apart) => apart < 0.01);
    }
    await ada.locator('#room').focus();
    await ada.keyboard.press('KeyS');
    await ada.getByText('You see what Bob sees.').waitFor({ state: 'hidden' });
    assert.equal(await follow().getAttribute('aria-pressed'), 'false');
    await untilStill(ada);
    const stays = await viewOf(ada);
    await bob.evaluate(() => window.roomcast.setView([1, 1.6, 1], [0, 1, -1]));
    await ada.waitForTimeout(600);
    assert.deepEqual(await viewOf(ada), stays);
  });

  test('ends by Escape and by its button', slow, async () => {
    await follow().focus();
    await ada.keyboard.press('Enter');
    await ada.getByText('You see what Bob sees.').waitFor();
    await ada.keyboard.press('Escape');
    await ada.getByText('You see what Bob sees.').waitFor({ state: 'hidden' });
    assert.equal(await ada.evaluate(() => document.activeElement.getAttribute('aria-label')), 'Follow Bob');
    await follow().click();
    await ada.getByRole('button', { name: 'Stop (Esc)' }).click();
    await ada.getByText('You see what Bob sees.').waitFor({ state: 'hidden' });
  });

  test('leaves an Escape to an open console', slow, async () => {
    const admin = await open(`&name=Eve#token=${room.token}`);
    await admin.getByRole('button', { name: 'Console', exact: true }).click();
    await admin.getByRole('button', { name: 'Follow Bob' }).click();
    await admin.getByRole('tab', { name: 'Sensors' }).focus();
    await admin.keyboard.press('Escape');
    assert.ok(await admin.locator('#console').isHidden());
    assert.ok(await admin.getByText('You see what Bob sees.').isVisible());
    await admin.keyboard.press('Escape');
    await admin.getByText('You see what Bob sees.').waitFor({ state: 'hidden' });
    assert.deepEqual(admin.complaints, []);
    await admin.close();
  });

  test('keeps the focus while others come, and ends with a sentence when the person leaves', slow, async () => {
    await follow().focus();
    await ada.keyboard.press('Enter');
    const eve = await open('&name=Eve');
    await ada.getByRole('button', { name: 'Follow Eve' }).waitFor();
    assert.equal(await ada.evaluate(() => document.activeElement.getAttribute('aria-label')), 'Follow Bob');
    await bob.close();
    await ada.getByText('Bob has left. You stay where you are.').waitFor();
    await eve.close();
    assert.deepEqual(ada.complaints, []);
  });
});

describe('the map', () => {
  test('shows sensors and people from above, and a click goes there', slow, async () => {
    const page = await open('&name=Ada');
    const other = await openPage(room.browser.context, `${room.hub.page}?panel=0&name=Bob&at=0.5,1.6,1&look=0,1,-1`);
    await untilAllShown(page, 1);
    const map = page.getByRole('img', { name: /The room from above: 1 sensor, another person, and you/ });
    await map.waitFor();
    const place = (selector) =>
      map.locator(selector).evaluate((drop) => /translate\(([-\d.]+) ([-\d.]+)\)/.exec(drop.getAttribute('transform')).slice(1).map(Number));
    await until('Bob is where he stands', () => place('.person'), ([x, z]) => Math.hypot(x - 0.5, z - 1) < 0.02);
    assert.deepEqual(await map.locator('.person title, .self title').allTextContents(), ['Bob', 'you']);
    const { left, top } = await map.locator('.person').evaluate((drop) => {
      const { e, f } = drop.getScreenCTM();
      return { left: e, top: f };
    });
    const before = await viewOf(page);
    await page.mouse.click(left, top);
    const there = await until('it is with Bob', () => viewOf(page), ({ position }) => Math.hypot(position[0] - 0.5, position[2] - 1) < 0.05);
    assert.deepEqual([there.position[1], there.yaw, there.pitch], [before.position[1], before.yaw, before.pitch]);
    await until('the map follows', () => place('.self'), ([mine, own]) => Math.hypot(mine - 0.5, own - 1) < 0.05);
    assert.deepEqual(await seriousFindings(page), []);
    assert.deepEqual(page.complaints, []);
    await other.close();
    await page.getByRole('img', { name: /no other people/ }).waitFor();
    await page.close();
  });
});

describe('named places', () => {
  test('are kept in this browser, gone to by a press, and forgotten', slow, async () => {
    const page = await open('&name=Ada');
    await untilAllShown(page, 1);
    await page.getByText('Places', { exact: true }).click();
    const field = page.getByLabel('Name of where you are now');
    await page.getByRole('button', { name: 'Keep it' }).click();
    await until('it wants a name', () => panelText(page), (text) => /It needs a name/.test(text));
    await field.fill('desk <b>');
    await page.keyboard.press('Enter');
    await until('it is kept', () => panelText(page), (text) => /“desk <b>” is kept/.test(text));
    assert.deepEqual(await seriousFindings(page), []);
    const isAt = (what, place) => until(what, () => viewOf(page), ({ position }) => distance(position, place) < 0.01);
    await page.getByRole('button', { name: 'Look from above' }).click();
    await until('it is above', () => viewOf(page), ({ position, pitch }) => position[1] > 3 && pitch < -1.5);
    await page.getByRole('button', { name: 'As s0 sees it' }).click();
    const { worldFromDepth: m } = (await page.evaluate(() => window.roomcast.sensors()))[0];
    await isAt('it is at the sensor', [m[3], m[7], m[11]]);
    await page.reload();
    await page.waitForFunction(() => window.roomcast !== undefined);
    await untilAllShown(page, 1);
    await page.evaluate(() => window.roomcast.setView([1, 1.5, 1], [0, 1, -1]));
    await page.getByText('Places', { exact: true }).click();
    await page.getByRole('button', { name: 'desk <b>', exact: true }).click();
    await isAt('it is at the desk', [0.2, 1.7, 2.6]);
    await page.getByRole('button', { name: 'Forget the place desk <b>' }).click();
    assert.equal(await page.evaluate(() => document.activeElement === document.querySelector('.place-list input')), true);
    assert.equal(await page.getByRole('button', { name: 'desk <b>', exact: true }).count(), 0);
    assert.equal(await page.evaluate(() => localStorage.getItem('roomcast.places.room')), '[]');
    assert.deepEqual(page.complaints, []);
    await page.close();
  });
});

test('the first visit loads at most 270 kB', slow, async () => {
  const { context, end } = await startBrowser();
  const page = await context.newPage();
  const files = [];
  context.on('response', (response) => files.push(response.url()));
  await page.goto(`${room.hub.page}?panel=1`);
  await page.waitForFunction(() => window.roomcast !== undefined);
  await untilAllShown(page, 1);
  const loaded = [...new Set(files)].filter((url) => !url.startsWith('data:'));
  assert.ok(loaded.some((url) => /worker-.*\.js/.test(url)) && loaded.some((url) => /codec-.*\.wasm/.test(url)), loaded.join());
  const bytes = await Promise.all(loaded.map(packedSize));
  const total = bytes.reduce((sum, size) => sum + size, 0);
  assert.ok(total > 100_000 && total <= 270_000, `${total} bytes: ${loaded.map((url, i) => `${url} ${bytes[i]}`).join(', ')}`);
  await page.goto(`${room.hub.page}?panel=1&quality=best`); // blended, for longer
  await untilAllShown(page, 1);
  await page.waitForTimeout(2500);
  assert.deepEqual(files.filter((url) => /flow/.test(url)), [], 'the surfaces of one sensor need no motion');
  await end();
});

test('with colours of the system’s own one sees whom one follows, and where all are', slow, async () => {
  const other = await openPage(room.browser.context, `${room.hub.page}?panel=0&name=Bob`);
  const page = await open('&name=Ada');
  await untilAllShown(page, 1);
  await page.emulateMedia({ forcedColors: 'active' });
  const follow = page.getByRole('button', { name: 'Follow Bob' });
  const back = () => follow.evaluate((button) => getComputedStyle(button).backgroundColor);
  const plain = await back();
  await follow.click();
  assert.notEqual(await back(), plain);
  await page.locator('.map .person').waitFor({ state: 'attached' });
  // In one go: the map is drawn anew while one's view moves, and what it has dropped has no colour.
  const fills = await page.evaluate(() => ['person', 'self'].map((who) => getComputedStyle(document.querySelector(`.map .${who}`)).fill));
  assert.ok(fills.every((fill) => fill !== '') && fills[0] !== fills[1], `${fills}`);
  await page.emulateMedia({ forcedColors: 'none' });
  await page.close();
  await other.close();
});

describe('a phone', () => {
  let phone, page;
  before(async () => {
    phone = await startBrowser({ width: 390, height: 844, phone: true });
    page = await openPage(phone.context, `${room.hub.page}?panel=0&${view}`);
    await untilAllShown(page, 1);
  }, slow);
  after(() => phone?.end());
  const fingers = async () => {
    const screen = await phone.context.newCDPSession(page);
    return (type, ...places) =>
      screen.send('Input.dispatchTouchEvent', { type, touchPoints: places.map(([x, y], id) => ({ x, y, id })) });
  };
  const middleOf = async (selector) => {
    const { x, y, width, height } = await page.locator(selector).boundingBox();
    return [x + width / 2, y + height / 2];
  };

  test('has a hint for fingers and a stick that walks until it is let go, while another finger looks around', slow, async () => {
    assert.match(await page.locator('#hint').innerText(), /one finger.*stick/);
    const touch = await fingers();
    const [x, y] = await middleOf('#stick');
    const start = await viewOf(page);
    await touch('touchStart', [x, y]);
    await touch('touchMove', [x, y - 60]);
    await until('it walks', () => viewOf(page), ({ position }) => distance(position, start.position) > 0.3);
    const ahead = await viewOf(page);
    assert.equal(ahead.position[1], start.position[1]);
    await touch('touchStart', [x, y - 60], [150, 300]);
    await touch('touchMove', [x, y - 60], [230, 300]);
    await until('it turns as well', () => viewOf(page), ({ yaw }) => Math.abs(yaw - ahead.yaw) > 0.1);
    await touch('touchEnd');
    await until('it stops', async () => {
      const before = await viewOf(page);
      await page.waitForTimeout(150);
      return distance((await viewOf(page)).position, before.position);
    }, (moved) => moved < 1e-9);
    assert.ok(await page.locator('#hint').isHidden());
    assert.deepEqual(await seriousFindings(page), []);
    assert.deepEqual(page.complaints, []);
  });

  test('goes to a place by a double tap', slow, async () => {
    await page.evaluate(() => window.roomcast.setView([0.2, 1.7, 2.6], [0, 0.9, -1]));
    await page.touchscreen.tap(195, 330);
    await page.touchscreen.tap(195, 330);
    await until('it has come nearer', () => viewOf(page), ({ position }) => distance(position, [0.2, 1.7, 2.6]) > 0.5);
  });

  test('has the stick out of the way of an open panel, with which one can share and follow', slow, async () => {
    await page.getByRole('button', { name: 'Open the panel' }).click();
    assert.ok(await page.locator('#stick').isHidden());
    await page.getByRole('button', { name: 'Share this view' }).scrollIntoViewIfNeeded();
    assert.ok(await page.getByRole('button', { name: 'Share this view' }).isVisible());
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'nothing sticks out');
  });
});
