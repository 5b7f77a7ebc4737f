// SPDX-License-Identifier: Apache-2.0
// What people show each other in the room: pointing, notes, drawings, distances, places for everybody, being shown around,
// by mouse, key and finger. One room of one sensor for all.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { seriousFindings } from './accessibility.mjs';
import { openPage, startBrowser } from './browser.mjs';
import { oneSensorRoom } from './one_sensor_room.mjs';
import { startHub, startSensor } from './programs.mjs';
import { distance, panelText, slow, stateOf, until, untilAllShown, viewOf } from './waiting.mjs';

const view = 'mode=mesh&at=0.2,1.7,2.6&look=0,0.9,-1';
const [middle, side] = [{ x: 600, y: 320 }, { x: 700, y: 330 }];
const room = oneSensorRoom('marks');

const open = (more = '', { context } = room.browser) => openPage(context, `${room.hub.page}?panel=0&${view}${more}`);
/** What `of`, another page's viewer, points at; null while they do not. */
async function pointOf(of, page) {
  const { viewerId } = await stateOf(of);
  return (await page.evaluate(() => window.roomcast.otherPoses())).find((pose) => pose.viewerId === viewerId)?.pointsAt ?? null;
}

describe('pointing', () => {
  let ada, bob;
  before(async () => {
    ada = await open('&name=Ada');
    bob = await open('&name=Bob');
    await untilAllShown(ada, 1);
    await untilAllShown(bob, 1);
  }, slow);
  after(() => Promise.all([ada?.close(), bob?.close()]));

  test('by a long press shows the others the surface under the mouse, until it is let go; the view stays', slow, async () => {
    await ada.bringToFront();
    const before = await viewOf(ada);
    await ada.mouse.move(middle.x, middle.y);
    await ada.mouse.down();
    const first = await until('Bob sees it', () => pointOf(ada, bob), (point) => point !== null);
    await ada.mouse.move(side.x, side.y);
    const second = await until('it follows', () => pointOf(ada, bob), (point) => point && distance(point, first) > 0.05);
    assert.ok(second.every(Number.isFinite) && second[1] > -0.2 && second[2] < before.position[2], `${second}`);
    await ada.mouse.up();
    await until('it is off', () => pointOf(ada, bob), (point) => point === null);
    assert.deepEqual(await viewOf(ada), before);
    assert.deepEqual(ada.complaints, []);
  });

  test('by the key L works with the mouse and without it', slow, async () => {
    await ada.bringToFront();
    await ada.locator('#room').focus();
    await ada.keyboard.down('KeyL');
    const there = await until('Bob sees it', () => pointOf(ada, bob), (point) => point !== null);
    await ada.mouse.move(middle.x, middle.y);
    await until('it follows', () => pointOf(ada, bob), (point) => point && distance(point, there) > 0.05);
    await ada.keyboard.up('KeyL');
    await until('it is off', () => pointOf(ada, bob), (point) => point === null);
    const typing = await open('&name=Eve');
    await typing.getByRole('button', { name: 'Open the panel' }).click();
    await typing.getByRole('button', { name: 'Change your name' }).click();
    await typing.keyboard.down('KeyL');
    await typing.waitForTimeout(400);
    assert.equal(await pointOf(typing, bob), null, 'a letter of a name points at nothing');
    await typing.close();
  });

  test('does not begin where one drags', slow, async () => {
    await ada.bringToFront();
    await ada.mouse.move(middle.x, middle.y);
    await ada.mouse.down();
    await ada.mouse.move(middle.x + 60, middle.y, { steps: 3 });
    await ada.waitForTimeout(900);
    assert.equal(await pointOf(ada, bob), null);
    await ada.mouse.up();
  });
});

const marksOf = (page) => page.evaluate(() => window.roomcast.marks());
const tool = (page, name) => page.getByRole('button', { name, exact: true });
const kinds = { note: 1, sketch: 2, distance: 3, place: 4 };
const ofKind = async (page, kind) => (await marksOf(page)).filter((mark) => mark.kind === kinds[kind]);
const count = (page, kind, wanted) => until(`${wanted} of ${kind}`, () => ofKind(page, kind), ({ length }) => length === wanted);
const words = 'Note for everybody in the room';

describe('marks', () => {
  let ada, bob, bobsBrowser;
  before(async () => {
    ada = await open('&name=Ada');
    bobsBrowser = await startBrowser({ width: 1000, height: 640 }); // another person: keys are a browser's
    bob = await open('&name=Bob', bobsBrowser);
    await untilAllShown(ada, 1);
    await untilAllShown(bob, 1);
    await ada.bringToFront();
  }, slow);
  after(() => Promise.all([ada?.close(), bobsBrowser?.end()]));

  test('a note is pinned to a surface, and everybody has it, newcomers, too', slow, async () => {
    await tool(ada, 'Note').click();
    await ada.locator('#room.aiming').waitFor(); // the tools are loaded with the first one
    await ada.mouse.click(middle.x, middle.y + 120);
    await ada.getByLabel(words).fill('Mind the step <b>');
    assert.deepEqual(await seriousFindings(ada), []);
    await ada.keyboard.press('Enter');
    const [note] = await count(bob, 'note', 1);
    assert.deepEqual([note.text, note.author, note.points.length], ['Mind the step <b>', 'Ada', 3]);
    const newcomer = await open('&name=Eve');
    await count(newcomer, 'note', 1);
    await newcomer.close();
    await ada.getByRole('button', { name: 'Undo' }).click();
    await count(bob, 'note', 0);
    assert.deepEqual(ada.complaints, []);
  });

  test('a note without words or with too many is not left, and its words are not lost', slow, async () => {
    await ada.mouse.click(middle.x, middle.y + 120);
    const field = ada.getByLabel(words);
    await ada.getByRole('button', { name: 'Leave it', exact: true }).click();
    await ada.getByText('Write something first.').waitFor();
    await field.fill('é'.repeat(200));
    await ada.keyboard.press('Enter');
    await ada.getByText(/at most 280 letters/).waitFor();
    assert.equal((await field.inputValue()).length, 200);
    await ada.keyboard.press('Escape');
    assert.ok(await field.isHidden());
    assert.equal((await marksOf(ada)).length, 0);
  });

  test('a drawing follows the surface, and the view stays', slow, async () => {
    const before = await viewOf(ada);
    await tool(ada, 'Draw').click();
    await ada.mouse.move(middle.x, middle.y + 100);
    await ada.mouse.down();
    for (let i = 1; i <= 12; i++) await ada.mouse.move(middle.x + 10 * i, middle.y + 100 + 3 * i);
    await ada.mouse.up();
    const [sketch] = await count(bob, 'sketch', 1);
    assert.ok(sketch.points.length >= 12 && sketch.points.every(Number.isFinite), `${sketch.points}`);
    assert.deepEqual(await viewOf(ada), before);
  });

  test('a distance is measured with two presses, and left if one likes', slow, async () => {
    await tool(ada, 'Measure').click();
    await ada.mouse.click(middle.x, middle.y + 120);
    await ada.getByText('Press where the distance ends.').waitFor();
    await ada.mouse.click(middle.x + 100, middle.y + 120);
    const said = await ada.getByText(/It is \d+\.\d\d m\./).innerText();
    assert.equal((await ofKind(bob, 'distance')).length, 0, 'it is one’s own until then');
    await ada.getByRole('button', { name: 'Leave it for everybody' }).click();
    const [mark] = await count(bob, 'distance', 1);
    const length = distance(mark.points.slice(0, 3), mark.points.slice(3));
    assert.ok(Math.abs(length - Number(/[\d.]+ /.exec(said)[0])) < 0.006 && length > 0.1 && length < 5, `${length}: ${said}`);
  });

  test('what a tool says stays while the hub confirms an earlier mark', slow, async () => {
    const again = await open('&name=Ada'); // another tab of the same person, whose marks are hers, too
    await again.bringToFront();
    await tool(again, 'Draw').click();
    await again.locator('#room.aiming').waitFor();
    await ada.bringToFront();
    await ada.getByRole('button', { name: 'Measure', exact: true }).click();
    if ((await tool(ada, 'Measure').getAttribute('aria-pressed')) === 'false') await tool(ada, 'Measure').click();
    await ada.mouse.click(middle.x, middle.y + 120);
    await ada.getByText('Press where the distance ends.').waitFor();
    const [before] = [(await ofKind(ada, 'sketch')).length];
    await again.bringToFront();
    await again.mouse.move(middle.x, middle.y + 100);
    await again.mouse.down();
    await again.mouse.move(middle.x + 40, middle.y + 100, { steps: 8 });
    await again.mouse.up();
    await until('the drawing is there', () => ofKind(ada, 'sketch'), ({ length }) => length > before);
    assert.ok(await ada.getByText('Press where the distance ends.').isVisible());
    await again.getByRole('button', { name: 'Undo' }).click();
    await count(ada, 'sketch', before);
    await ada.keyboard.press('Escape');
    await again.close();
  });

  test('by keyboard alone: a note in the middle of the view, and Escape puts the tool away', slow, async () => {
    await tool(ada, 'Note').focus();
    await ada.keyboard.press('Enter');
    await until('the room has the focus', () => ada.evaluate(() => document.activeElement.id), (id) => id === 'room');
    assert.equal(await ada.evaluate(() => getComputedStyle(document.getElementById('aim')).visibility), 'visible');
    await ada.keyboard.press('Enter');
    await ada.getByLabel(words).waitFor();
    await ada.keyboard.type('by key');
    await ada.keyboard.press('Enter');
    await count(bob, 'note', 1);
    await ada.keyboard.press('Escape');
    assert.equal(await tool(ada, 'Note').getAttribute('aria-pressed'), 'false');
  });

  test('are listed, removed by their author, and by nobody else', slow, async () => {
    for (const page of [ada, bob]) await page.getByRole('button', { name: /^Marks/ }).click();
    await bob.getByRole('button', { name: /^Distance/ }).waitFor();
    assert.deepEqual(await seriousFindings(bob), []);
    assert.equal(await bob.getByRole('button', { name: /^Remove/ }).count(), 0);
    const start = await viewOf(bob);
    await bob.getByRole('button', { name: /^Distance/ }).click();
    await until('it has gone there', () => viewOf(bob), ({ position }) => distance(position, start.position) > 0.2);
    await ada.getByRole('button', { name: 'Remove: by key' }).click();
    await count(bob, 'note', 0);
    await ada.getByRole('button', { name: 'Remove these 2' }).click();
    await ada.getByRole('button', { name: 'Really remove 2 marks for everybody?' }).click();
    await until('all are gone', () => marksOf(bob), ({ length }) => length === 0);
    await ada.getByText('Nobody has left anything yet.').waitFor();
    await ada.getByRole('button', { name: /^Marks/ }).click();
  });

  test('a place for everybody is gone to by a press', slow, async () => {
    await ada.getByRole('button', { name: 'Open the panel' }).click();
    await ada.getByText('Places', { exact: true }).click();
    await ada.getByLabel('Name of where you are now').fill('desk');
    await ada.getByRole('button', { name: 'For everybody' }).click();
    await until('it is said', () => panelText(ada), (text) => /“desk” is a place of this room now/.test(text));
    const there = await viewOf(ada);
    await bob.getByRole('button', { name: 'Open the panel' }).click();
    await bob.getByText('Places', { exact: true }).click();
    await bob.getByRole('button', { name: /^desk/ }).click();
    await until('Bob is there', () => viewOf(bob), ({ position }) => distance(position, there.position) < 0.01);
    assert.deepEqual(await seriousFindings(bob), []);
    assert.ok(await bob.getByRole('button', { name: 'Remove the place desk for everybody' }).isHidden());
    await ada.getByRole('button', { name: 'Remove the place desk for everybody' }).click();
    await count(bob, 'place', 0);
    assert.deepEqual([...ada.complaints, ...bob.complaints], []);
  });

  test('stay when the hub starts again, and their author is still known', slow, async () => {
    await ada.getByRole('button', { name: 'Close the panel' }).click();
    await tool(ada, 'Note').click();
    await ada.mouse.click(middle.x, middle.y + 120);
    await ada.getByLabel(words).fill('for long');
    await ada.keyboard.press('Enter');
    await count(bob, 'note', 1);
    await room.sensor.end();
    await room.hub.end();
    for (const page of [ada, bob]) await until('it is noticed', () => stateOf(page), ({ phase }) => phase !== 'joined');
    room.hub = await startHub(room.hub.port, { data: room.data });
    room.sensor = startSensor(room.hub, 0, { fps: 3 });
    for (const page of [ada, bob]) await until('it is back', () => stateOf(page), ({ phase }) => phase === 'joined');
    assert.equal((await count(bob, 'note', 1))[0].text, 'for long');
    await ada.getByRole('button', { name: /^Marks/ }).click();
    await ada.getByRole('button', { name: 'Remove: for long' }).click();
    await count(bob, 'note', 0);
    await untilAllShown(ada, 1);
  });
});

describe('an admin', () => {
  test('shows everybody around, until each moves or the admin ends it', slow, async () => {
    const admin = await open(`&name=Eve#token=${room.token}`);
    const ada = await open('&name=Ada');
    await untilAllShown(ada, 1);
    await admin.bringToFront();
    await admin.getByRole('button', { name: 'Open the panel' }).click();
    await admin.getByRole('button', { name: 'Show everybody around' }).click();
    await admin.getByText('Everybody sees what you see').waitFor();
    assert.deepEqual(await seriousFindings(admin), []);
    await ada.bringToFront();
    await ada.getByText('Eve shows everybody around.').waitFor();
    const apart = async () => distance((await viewOf(ada)).position, (await viewOf(admin)).position);
    await admin.evaluate(() => window.roomcast.setView([1, 1.6, 1], [0, 1, -1]));
    await admin.bringToFront(); // a page that is not seen sends no poses
    await admin.waitForTimeout(500);
    await ada.bringToFront();
    await until('Ada is with her', apart, (metres) => metres < 0.01);
    const late = await open('&name=Bob');
    await late.getByText('Eve shows everybody around.').waitFor();
    await ada.bringToFront();
    await ada.locator('#room').focus();
    await ada.keyboard.press('KeyS');
    await ada.getByText('Eve shows everybody around.').waitFor({ state: 'hidden' });
    await admin.bringToFront();
    await admin.getByRole('button', { name: 'Stop (Esc)' }).click();
    await late.getByText('Eve no longer shows everybody around.').waitFor();
    const pressed = () => admin.getByRole('button', { name: 'Show everybody around' }).getAttribute('aria-pressed');
    await until('the button is up', pressed, (state) => state === 'false');
    assert.deepEqual([...admin.complaints, ...ada.complaints], []);
    await Promise.all([admin.close(), ada.close(), late.close()]);
  });
});

describe('text of twice the usual size', () => {
  for (const [what, width, height] of [['a window', 1280, 800], ['a phone', 390, 844]]) {
    test(`fits into ${what}, and everything can be used`, slow, async () => {
      const phone = width < 500;
      const large = await startBrowser({ width, height, phone, font_px: 32 });
      const page = await open('&name=Ada', large);
      await untilAllShown(page, 1);
      const press = (button) => (phone ? button.tap() : button.click());
      await press(page.getByRole('button', { name: 'Open the panel' }));
      const sizesNow = () =>
        page.evaluate(() =>
          [...document.querySelectorAll('#panel *, #tools *, #hint *')]
            .filter((part) => part.checkVisibility() && [...part.childNodes].some(({ nodeType, data }) => nodeType === 3 && data.trim()))
            .map((part) => [parseFloat(getComputedStyle(part).fontSize), part.textContent]),
        );
      const sizes = await until('the panel is open', sizesNow, ({ length }) => length > 15);
      assert.ok(sizes.every(([size]) => size >= 22), JSON.stringify(sizes.filter(([size]) => size < 22)));
      const outside = () =>
        page.evaluate(() =>
          [...document.querySelectorAll('#panel, #tools .bar, #tools .said, #tools button, #hint')]
            .filter((part) => part.checkVisibility() && getComputedStyle(part).clipPath === 'none')
            .filter((part) => {
              const { left, right, width } = part.getBoundingClientRect();
              return width > 0 && (left < 0 || right > innerWidth + 0.5);
            })
            .map((part) => part.outerHTML.slice(0, 80)),
        );
      assert.deepEqual(await outside(), []);
      await press(page.getByRole('button', { name: 'Close the panel' }));
      await press(tool(page, 'Note'));
      await until('the tool is there', () => page.locator('#room.aiming').count(), (there) => there === 1);
      if (phone) await page.touchscreen.tap(195, 560);
      else await page.mouse.click(800, 560);
      await page.getByLabel(words).fill('large');
      assert.deepEqual(await outside(), []);
      assert.deepEqual(await seriousFindings(page), []);
      await press(page.getByRole('button', { name: 'Leave it', exact: true }));
      await count(page, 'note', 1);
      await press(page.getByRole('button', { name: 'Undo' }));
      await count(page, 'note', 0);
      assert.deepEqual(page.complaints, []);
      await large.end();
    });
  }
});

describe('a phone', () => {
  let phone, page, other;
  before(async () => {
    phone = await startBrowser({ width: 390, height: 844, phone: true });
    page = await open('&name=Ada', phone);
    other = await open('&name=Bob');
    await untilAllShown(page, 1);
  }, slow);
  after(() => Promise.all([phone?.end(), other?.close()]));

  test('points by press and hold, and a second finger ends it', slow, async () => {
    const screen = await phone.context.newCDPSession(page);
    const touch = (type, ...places) =>
      screen.send('Input.dispatchTouchEvent', { type, touchPoints: places.map(([x, y], id) => ({ x, y, id })) });
    await touch('touchStart', [195, 330]);
    await until('Bob sees it', () => pointOf(page, other), (point) => point !== null);
    await touch('touchStart', [195, 330], [260, 400]);
    await until('it is off', () => pointOf(page, other), (point) => point === null);
    await touch('touchEnd');
    assert.deepEqual(page.complaints, []);
  });

  test('draws with one finger, measures and leaves a note', slow, async () => {
    const screen = await phone.context.newCDPSession(page);
    const touch = (type, ...places) =>
      screen.send('Input.dispatchTouchEvent', { type, touchPoints: places.map(([x, y], id) => ({ x, y, id })) });
    await tool(page, 'Draw').tap();
    await until('the tool is there', () => page.locator('#room.aiming').count(), (there) => there === 1);
    await touch('touchStart', [150, 480]);
    for (let i = 1; i < 10; i++) await touch('touchMove', [150 + 8 * i, 480 + 2 * i]);
    await touch('touchEnd');
    // Where the finger crosses an edge, another line begins.
    await until('the drawing is left', () => ofKind(other, 'sketch'), ({ length }) => length > 0);
    // The finger is on the room before the browser has reported the tap on the tool.
    await touch('touchStart', [150, 480]);
    await tool(page, 'Measure').evaluate((button) => button.click());
    await touch('touchEnd');
    await page.getByText('Press where the distance ends.').waitFor();
    await page.touchscreen.tap(230, 500);
    await page.getByText(/It is \d+\.\d\d m\./).waitFor();
    await tool(page, 'Note').tap();
    await until('the tool is chosen', () => tool(page, 'Note').getAttribute('aria-pressed'), (pressed) => pressed === 'true');
    await page.touchscreen.tap(190, 490);
    await page.getByLabel(words).fill('from a phone');
    await page.getByRole('button', { name: 'Leave it', exact: true }).tap();
    await count(other, 'note', 1);
    await page.getByRole('button', { name: /^Marks/ }).tap();
    await page.getByRole('button', { name: 'Remove: from a phone' }).waitFor();
    assert.deepEqual(await seriousFindings(page), []);
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'nothing sticks out');
    assert.deepEqual(page.complaints, []);
  });
});
