// SPDX-License-Identifier: Apache-2.0
// npm run screenshots [-- desktop phone headset console]: the pictures of the page in docs/images, of a recording of a
// simulated room in which nobody moves. Drawn in software at the best quality, so it takes some minutes.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { openPage, startBrowser } from '../../tests/e2e/browser.mjs';
import { wearHeadsets } from '../../tests/e2e/headset_device.mjs';
import { adminsToken, requireBuilt, run, startHub, startSensor } from '../../tests/e2e/programs.mjs';
import { stateOf, until, untilAllShown } from '../../tests/e2e/waiting.mjs';

const images = fileURLToPath(new URL('../../docs/images/', import.meta.url));
const sensors = 3;
const view = 'quality=best&name=Ada&at=0.3,1.7,2.7&look=0,0.8,-1';
const enoughSets = 14; // the background is remembered after eight
const patience_ms = 240_000;

async function settled(page) {
  await untilAllShown(page, sensors);
  await until(
    'a well drawn room',
    () => stateOf(page),
    ({ shownSets }) => shownSets >= enoughSets,
    patience_ms,
  );
}

async function picture(page, name) {
  await page.screenshot({ path: `${images}${name}.jpg`, type: 'jpeg', quality: 86, timeout: patience_ms });
  console.log(`docs/images/${name}.jpg`);
}

async function withBrowser(options, use) {
  const browser = await startBrowser(options);
  try {
    await use(browser.context);
  } finally {
    await browser.end();
  }
}

const asked = process.argv.slice(2);
const wanted = (name) => asked.length === 0 || asked.includes(name);

async function desktop(hub) {
  await withBrowser({ width: 1280, height: 760 }, async (context) => {
    const page = await openPage(context, `${hub.page}?${view}`);
    await page.emulateMedia({ colorScheme: 'dark' });
    await settled(page);
    await picture(page, 'web-desktop');
  });
}

async function phone(hub) {
  await withBrowser({ width: 390, height: 780, phone: true }, async (context) => {
    const page = await openPage(context, `${hub.page}?${view}`);
    await page.emulateMedia({ colorScheme: 'dark' });
    await settled(page);
    await picture(page, 'web-phone');
  });
}

async function headset(hub) {
  await withBrowser({ width: 1100, height: 560 }, async (context) => {
    const other = await openPage(
      context,
      `${hub.page}?panel=0&mode=points&name=Grace&at=-0.9,1.6,-0.3&look=0.6,1.5,2.6`,
    );
    await wearHeadsets(context);
    await context.addInitScript({ content: pose });
    const page = await openPage(context, `${hub.page}?${view}&panel=1`);
    await settled(page);
    await page.getByRole('button', { name: 'Enter VR' }).click();
    const before = (await stateOf(page)).shownSets;
    await until(
      'pictures',
      () => stateOf(page),
      ({ shownSets }) => shownSets >= before + 3,
      patience_ms,
    );
    await picture(page, 'web-headset');
    await other.close();
  });
}

async function consoleTabs(hub, token) {
  await withBrowser({ width: 1280, height: 800 }, async (context) => {
    const page = await openPage(context, `${hub.page}?mode=mesh&name=Ada&at=0.3,1.7,2.7&look=0,0.8,-1#token=${token}`);
    await untilAllShown(page, sensors);
    await page.getByRole('button', { name: 'Console', exact: true }).click();
    await page.waitForTimeout(90_000); // for charts that say something
    await picture(page, 'web-console-sensors');
    await page.emulateMedia({ colorScheme: 'dark' });
    await page.getByRole('tab', { name: 'Alignment' }).click();
    await page.waitForTimeout(8000);
    await picture(page, 'web-console-alignment');
  });
}

/** Where the wearer's head and hands are: they are in the picture. */
const pose = `
  window.device.position.set(0, 1.65, 0);
  window.device.quaternion.set(-0.12, 0, 0, 0.993);
  window.device.controllers.right.position.set(0.22, 1.35, -0.42);
  window.device.controllers.left.position.set(-0.22, 1.3, -0.42);
`;

requireBuilt();
const folder = mkdtempSync(join(tmpdir(), 'roomcast-screenshots-'));
const rig = join(folder, 'rig');
const still = ['--fps', '2', '--seconds', '2', '--speed', '0', '--drops', '0', '--views', '0'];
await run('simulate', rig, '--sensors', String(sensors), ...still);
const data = join(folder, 'hub');
const hub = await startHub(0, { data });
const programs = Array.from({ length: sensors }, (_, n) => startSensor(hub, n, { rig }));
try {
  if (wanted('desktop')) await desktop(hub);
  if (wanted('phone')) await phone(hub);
  if (wanted('headset')) await headset(hub);
  if (wanted('console')) await consoleTabs(hub, await adminsToken(data));
} finally {
  await Promise.all([...programs, hub].map((program) => program.end()));
  rmSync(folder, { recursive: true, force: true });
}
