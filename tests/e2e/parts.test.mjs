// SPDX-License-Identifier: Apache-2.0
// Parts of panel and console in a browser, without a hub: what has the keyboard's focus, what is said, and how long.
import assert from 'node:assert/strict';
import { after, before, beforeEach, describe, test } from 'node:test';
import { startBrowser } from './browser.mjs';
import { openSourcePage } from './source_pages.mjs';
import { slow } from './waiting.mjs';

let browser, page;
before(async () => {
  browser = await startBrowser({ width: 700, height: 600 });
}, slow);
after(() => browser?.end(), slow);

const focused = () => page.evaluate(() => document.activeElement.getAttribute('aria-label') ?? document.activeElement.textContent);

/** Makes `window.rosterOf(names, change)`: the page's roster of sensors with poses that the aligner found. */
async function provideRosters() {
  await page.evaluate(async () => {
    window.rosterOf = (names, change = () => ({})) => ({
      viewers: [],
      sensors: names.map((name, id) => ({
        id,
        name,
        online: true,
        fps: 5,
        calibration: { depth: { width: 4, height: 3, fx: 4, fy: 4, cx: 2, cy: 1 } },
        pose: {
          worldFromDepth: [1, 0, 0, id, 0, 1, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1],
          source: 'estimated',
          state: 'valid',
          expectedErrorMm: 5,
          note: '',
          ...change(name),
        },
      })),
    });
  });
}

describe('the list of sensors', () => {
  before(async () => {
    page = await openSourcePage(browser.context, 'http://list.test');
    await provideRosters();
    await page.evaluate(async () => {
      const [{ SensorList }, { RoomState }] = await Promise.all([import('/panel/sensor_list'), import('/room_state')]);
      const state = new RoomState();
      window.list = new SensorList(state, () => undefined);
      window.follow = (names, change) => {
        state.follow(window.rosterOf(names, change));
        window.list.rebuild();
        window.list.refresh();
      };
      document.body.append(window.list.root);
    });
  }, slow);
  after(() => page?.close());

  test('keeps the focus when sensors come, change and go', slow, async () => {
    await page.evaluate(() => window.follow(['s1', 's2']));
    await page.getByLabel('Show sensor s2').focus();
    await page.evaluate(() => {
      window.follow(['s1', 's2', 's0']);
      window.follow(['s1', 's2', 's0'], () => ({ state: 'moved', note: 'turn it' }));
    });
    assert.equal(await focused(), 'Show sensor s2');
    assert.deepEqual(await page.locator('li .name').allInnerTexts(), ['s0moved', 's1moved', 's2moved']);
    await page.evaluate(() => window.follow(['s1', 's2']));
    assert.equal(await focused(), 'Show sensor s2');
    await page.evaluate(() => window.follow([]));
    assert.equal(await page.locator('li').innerText(), 'none yet');
  });

  test('keeps a sensor switched off that the hub has numbered anew', slow, async () => {
    await page.evaluate(() => window.follow(['s0', 's1']));
    await page.getByLabel('Show sensor s0').uncheck();
    await page.evaluate(() => window.follow(['s1']));
    await page.evaluate(() => window.follow(['s1', 's0']));
    assert.equal(await page.getByLabel('Show sensor s0').isChecked(), false);
    assert.equal(await page.getByLabel('Show sensor s1').isChecked(), true);
  });
});

describe('the list of people', () => {
  test('keeps the focus on a button while figures change and others come', slow, async () => {
    page = await openSourcePage(browser.context, 'http://people.test');
    await page.evaluate(async () => {
      const { PeopleView } = await import('/console/people_view');
      const view = new PeopleView(() => undefined);
      document.body.append(view.root);
      const people = (...ids) => ids.map((id) => ({ id, name: `p${id}` }));
      const facts = (fps) => [1, 2, 3].map((id) => ({ id, shown_fps: fps, sets_dropped: 0 }));
      view.show(people(1, 2), facts(5), 1);
      [...view.root.querySelectorAll('button')].at(-1).focus();
      view.show(people(1, 2, 3), facts(6), 1);
    });
    assert.equal(await focused(), 'Send away: p2');
    assert.match(await page.locator('table').innerText(), /p3\s+6.0 fps/);
    await page.close();
  });
});

describe('the list of rooms', () => {
  test('keeps the focus on a link while others come and counts change', slow, async () => {
    page = await openSourcePage(browser.context, 'http://rooms.test');
    await page.evaluate(async () => {
      const { RoomList } = await import('/panel/room_list');
      const list = new RoomList();
      document.body.append(list.root);
      const room = (name, viewers) => ({ name, title: '', sensors: 1, viewers, view: 'anyone' });
      list.show([room('a', 1), room('b', 1)], 'a');
      list.root.querySelector('a[href="?room=b"]').focus();
      list.show([room('0', 0), room('a', 1), room('b', 2)], 'b');
    });
    assert.equal(await focused(), 'b');
    assert.match(await page.locator('ul').innerText(), /b\s*1 sensor, 2 people/);
    assert.equal(await page.locator('[aria-current]').innerText(), 'b');
    await page.close();
  });
});

describe('moving a sensor by hand', () => {
  before(async () => {
    page = await openSourcePage(browser.context, 'http://nudge.test');
    await provideRosters();
    await page.evaluate(async () => {
      const { AlignmentView } = await import('/console/alignment_view');
      window.happened = [];
      window.answer = 'sent';
      window.wasMoved = true;
      const view = new AlignmentView({
        push: (sensor, { right }) => window.happened.push(`push ${sensor} ${right}`),
        putHere: () => undefined,
        tryIt: () => window.answer,
        putBack: () => (window.happened.push('back'), window.wasMoved),
      });
      document.body.append(view.root);
      view.setMayNudge(true);
      window.view = view;
      window.fields = ['aligned', 'fixed'];
      window.show = (note = '') =>
        view.show(window.rosterOf(window.fields, (name) => (name === 'fixed' ? { source: 'given' } : { note })).sensors, []);
      window.show();
    });
  }, slow);
  after(() => page?.close());
  beforeEach(() => page.evaluate(() => (window.happened = [])));

  const item = (name) => page.locator('.places li', { hasText: name });
  const happened = () => page.evaluate(() => window.happened);

  test('is not offered for a sensor that supplied its pose, and says why', slow, async () => {
    assert.equal(await item('fixed').getByRole('button').count(), 0);
    assert.match(await item('fixed').innerText(), /supplied its pose, so it cannot be moved by hand/);
    assert.equal(await item('aligned').getByRole('button', { name: 'Move by hand' }).count(), 1);
  });

  test('gives the focus to its buttons, which keep it when the aligner answers', slow, async () => {
    await page.getByRole('button', { name: 'Move by hand' }).click();
    assert.equal(await focused(), 'Tilt up (Y)');
    await page.getByRole('button', { name: 'To the left (J)' }).focus();
    await page.evaluate(() => window.show('It was refused.'));
    assert.equal(await focused(), 'To the left (J)');
    await page.keyboard.press('KeyL');
    assert.deepEqual(await happened(), ['push 0 0.05']);
  });

  test('says what becomes of a try', slow, async () => {
    const says = (words) => page.waitForFunction((text) => document.querySelector('.nudge').innerText.includes(text), words);
    const tryIt = page.getByRole('button', { name: 'Try (Enter)' });
    await page.evaluate(() => (window.answer = 'notMoved'));
    await tryIt.click();
    await says('Move the sensor first');
    await page.evaluate(() => (window.answer = 'notConnected'));
    await tryIt.click();
    await says('no connection');
    await page.evaluate(() => (window.answer = 'sent'));
    await tryIt.click();
    await says('Trying …');
    await page.evaluate(() => window.show('It was refused again.'));
    assert.doesNotMatch(await page.locator('.nudge').innerText(), /Trying/);
  });

  test('takes Escape while there is something to put back, and leaves it to the console then', slow, async () => {
    const passedOn = () =>
      page.evaluate(() => {
        const event = new KeyboardEvent('keydown', { code: 'Escape', key: 'Escape', bubbles: true, cancelable: true });
        return document.querySelector('.pad button').dispatchEvent(event);
      });
    assert.equal(await passedOn(), false);
    await page.evaluate(() => (window.wasMoved = false));
    assert.equal(await passedOn(), true);
    assert.deepEqual(await happened(), ['back', 'back']);
  });

  test('takes keys from the room, but none from other controls, and none while it is not on the screen', slow, async () => {
    const press = (selector, code) =>
      page.evaluate(
        ([at, key]) => {
          document.querySelector(at).dispatchEvent(new KeyboardEvent('keydown', { code: key, bubbles: true, cancelable: true }));
        },
        [selector, code],
      );
    await press('canvas', 'KeyL');
    assert.deepEqual(await happened(), ['push 0 0.05']);
    await page.evaluate(() => document.body.append(document.createElement('button')));
    await press('body > button', 'KeyL');
    await page.evaluate(() => (window.view.root.hidden = true));
    await press('canvas', 'KeyL');
    await page.keyboard.press('KeyL');
    assert.deepEqual(await happened(), ['push 0 0.05']);
    assert.deepEqual(page.complaints, []);
  });
});

describe('the recording', () => {
  test('that was refused is explained until the next click', slow, async () => {
    page = await openSourcePage(browser.context, 'http://recording.test');
    const said = await page.evaluate(async () => {
      const { RecordingView } = await import('/console/recording_view');
      const nothing = { state: 'off', seconds: 0, frames: 0, bytes: 0 };
      let refuses = true;
      let changes = 0;
      const view = new RecordingView(
        {
          recording: async () => nothing,
          startRecording: async () => {
            if (refuses) throw new Error('this hub has no folder to keep recordings in.');
            return { ...nothing, state: 'on' };
          },
        },
        () => 'room',
        () => changes++,
      );
      const [button, words] = [view.root.querySelector('button'), view.root.querySelector('[role=status]')];
      const settled = () => new Promise((resolve) => setTimeout(resolve, 0));
      button.click();
      await settled();
      const atOnce = words.textContent;
      await view.refresh();
      await view.refresh();
      const later = words.textContent;
      refuses = false;
      button.click();
      await settled();
      return { atOnce, later, isEnabled: !button.disabled, then: words.textContent, changes };
    });
    assert.match(said.atOnce, /no folder to keep recordings in/);
    assert.equal(said.later, said.atOnce);
    assert.ok(said.isEnabled);
    assert.equal(said.then, 'The hub is recording this room.');
    assert.equal(said.changes, 1, 'the list of recordings is asked for anew when one begins');
    await page.close();
  });
});
