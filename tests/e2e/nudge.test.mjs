// SPDX-License-Identifier: Apache-2.0
// A user places by hand a sensor that cannot be aligned automatically: the console reports the problem, the user walks
// to the sensor's position, looks in its direction and tries; the aligner refines the pose or explains why not.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';
import { openPage, startBrowser } from './browser.mjs';
import { writeLoneSensor } from './lone_sensor.mjs';
import { adminsToken, requireBuilt, startHub, startSensor } from './programs.mjs';
import { distance, sensorsOf, slow, until, untilAllShown } from './waiting.mjs';

const off_m = 0.08; // error of the pose that the user sets
const exact_m = 0.04;
const solved_ms = 150_000; // drawing by software leaves the aligner, which is niced, a tenth of a core

describe('an unplaced sensor', () => {
  const folder = mkdtempSync(join(tmpdir(), 'roomcast-nudge-'));
  let hub, sensors, browser, page, truth;

  before(async () => {
    requireBuilt();
    const rig = join(folder, 'rig');
    truth = await writeLoneSensor(rig);
    const data = join(folder, 'data');
    hub = await startHub(0, { data });
    const token = await adminsToken(data);
    browser = await startBrowser({ width: 1000, height: 700 });
    page = await openPage(browser.context, `${hub.page}?panel=0&mode=points&${standingAtTruth()}#token=${token}`);
    sensors = [startSensor(hub, 1, { fps: 2, rig })];
    // A lone sensor defines a world frame of its own, which is dropped when a sensor with a given pose joins.
    await until('placed alone', lone, (sensor) => sensor?.source === 'estimated', solved_ms);
    sensors.push(startSensor(hub, 0, { fps: 2, rig }));
    await untilAllShown(page, 2);
  }, slow);

  after(async () => {
    await browser?.end();
    await Promise.all([...(sensors ?? []), hub].map((program) => program?.end()));
    rmSync(folder, { recursive: true, force: true });
  }, slow);

  /** A view slightly off the sensor's true position, in the sensor's direction. */
  function standingAtTruth() {
    const eye = [truth[3] + off_m, truth[7], truth[11]];
    const target = [2, 6, 10].map((i, axis) => eye[axis] + truth[i]);
    return `at=${eye.join()}&look=${target.join()}`;
  }

  const button = (name) => page.getByRole('button', { name, exact: true });
  const places = () => page.locator('.places').innerText();
  const lone = async () => (await sensorsOf(page)).find(({ name }) => name === 's1');
  const fromTruth_m = ({ worldFromDepth: m }) => Math.hypot(...[3, 7, 11].map((i) => m[i] - truth[i]));

  test('the console shows it as unplaced, and advice', slow, async () => {
    await button('Console').click();
    await page.getByRole('tab', { name: 'Alignment' }).click();
    const text = await until('why', places, (said) => /not placed[\s\S]*hardly any texture/.test(said), solved_ms);
    assert.match(text, /What helps/);
  });

  test('a nudge that does not fit is refused with a reason', slow, async () => {
    await page.locator('.places li', { hasText: 's1' }).getByRole('button', { name: 'Move by hand' }).click();
    await button('Tilt up (Y)').click();
    await button('Try (Enter)').click();
    await until('the refusal', places, (said) => /The proposed pose was refused/.test(said), solved_ms);
  });

  test('keys move it while its buttons are on the screen, and Escape puts it back', slow, async () => {
    const place = async () => (await lone()).drawnAt;
    const start = await place();
    await button('Turn left (U)').click();
    await button('To the right (L)').click();
    await page.keyboard.press('KeyL');
    assert.ok(Math.abs(distance(await place(), start) - 0.1) < 1e-3, 'two steps of 5 cm, shown here only');
    await button('Close the console').click();
    await page.keyboard.press('KeyL');
    assert.ok(Math.abs(distance(await place(), start) - 0.1) < 1e-3, 'the console is closed');
    await button('Console').click();
    await button('To the right (L)').focus();
    await page.keyboard.press('Escape');
    assert.ok(distance(await place(), start) < 1e-6, 'it is back');
    assert.ok(await page.locator('#console').isVisible());
    await page.keyboard.press('Escape');
    assert.ok(await page.locator('#console').isHidden());
    await button('Console').click();
  });

  test('a nudge to a viewpoint near its pose places it', slow, async () => {
    await button('Where I stand and look').click();
    assert.ok(distance((await lone()).drawnAt, [truth[3] + off_m, truth[7], truth[11]]) < 1e-3, 'shown there at once');
    await button('Try (Enter)').click();
    const said = await until('placed', places, (text) => /s1[\s\S]*placed, expected error/.test(text), solved_ms);
    const left_m = fromTruth_m(await lone());
    assert.ok(left_m < exact_m, `${left_m} m from where it stands: ${said}`);
    assert.deepEqual(page.complaints, []);
  });
});
