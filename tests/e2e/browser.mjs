// SPDX-License-Identifier: Apache-2.0
// Starts Chromium without a window and with software rendering, through playwright-core from web/node_modules.
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const { chromium } = createRequire(new URL('../../web/package.json', import.meta.url))('playwright-core');

const executablePath = process.env.ROOMCAST_CHROMIUM ?? '/usr/bin/chromium';
const patience_ms = 60_000;
const args = [
  '--no-sandbox',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--use-gl=angle',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
];

/** Sets the browser's size of text, as a person does in its settings. */
function setFont(profile, font_px) {
  mkdirSync(join(profile, 'Default'));
  const preferences = { webkit: { webprefs: { default_font_size: font_px } } };
  writeFileSync(join(profile, 'Default', 'Preferences'), JSON.stringify(preferences));
}

/**
 * `more` are arguments of the browser. `ignoreHTTPSErrors`: accept certificates without a trusted issuer. `phone`: fingers
 * instead of a mouse. `font_px`: size of text, usually 16.
 */
export async function startBrowser({
  width = 640,
  height = 400,
  ignoreHTTPSErrors = false,
  phone = false,
  more = [],
  font_px = 0,
} = {}) {
  const profile = mkdtempSync(join(tmpdir(), 'roomcast-e2e-'));
  if (font_px) setFont(profile, font_px);
  const context = await chromium.launchPersistentContext(profile, {
    executablePath,
    headless: true,
    chromiumSandbox: false,
    viewport: { width, height },
    ignoreHTTPSErrors,
    hasTouch: phone,
    isMobile: phone,
    timeout: patience_ms,
    args: [...args, ...more],
  });
  context.setDefaultTimeout(patience_ms);
  const end = async () => {
    await context.close();
    rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  };
  return { context, end };
}

/**
 * What a page logs while its hub is gone. A request that the hub's end cuts fails in one of several ways, by how far it
 * had come: a connection that is reset before the browser has looked at it is "not connected", one of which all was read
 * has an "empty response".
 */
export const withoutHub =
  /WebSocket connection to .* failed|net::ERR_(CONNECTION_(REFUSED|RESET|CLOSED|ABORTED)|SOCKET_NOT_CONNECTED|EMPTY_RESPONSE)/;

/** With the address that the text of a failed request leaves out. */
const said = (message) => [message.text(), /^Failed to load/.test(message.text()) ? message.location().url : ''].join(' ').trim();

/** Opens a page of the hub; its errors and warnings are collected in `page.complaints`. */
export async function openPage(context, url) {
  const page = await context.newPage();
  page.complaints = [];
  page.on('pageerror', (error) => page.complaints.push(error.message));
  page.on('console', (message) => message.type() === 'error' && page.complaints.push(said(message)));
  await page.goto(url);
  await page.waitForFunction(() => window.roomcast !== undefined);
  return page;
}

/** Keeps a picture of the page in the folder $ROOMCAST_SHOTS, to be looked at. */
export async function keepPicture(page, name) {
  const folder = process.env.ROOMCAST_SHOTS;
  if (folder) await page.screenshot({ path: `${folder}/${name}.png` });
}
