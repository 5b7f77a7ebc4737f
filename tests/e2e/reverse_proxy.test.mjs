// SPDX-License-Identifier: Apache-2.0
// The page through an HTTPS reverse proxy: Chromium, nginx, hub and sensor.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

import { makeCertificate } from '../network/certificate.mjs';
import { nginxIsMissing, startNginx } from '../network/nginx.mjs';
import { openPage, startBrowser } from './browser.mjs';
import { requireBuilt, startHub, startSensor } from './programs.mjs';
import { slow, untilAllShown } from './waiting.mjs';

test('page behind an HTTPS reverse proxy shows the room', { ...slow, skip: nginxIsMissing }, async (t) => {
  requireBuilt();
  const folder = mkdtempSync(join(tmpdir(), 'roomcast-proxy-'));
  t.after(() => rmSync(folder, { recursive: true, force: true }));
  const certificate = await makeCertificate(t, folder);
  const hub = await startHub();
  t.after(() => hub.end());
  const sensor = startSensor(hub, 0, { fps: 4 });
  t.after(() => sensor.end());
  const proxy = await startNginx(t, folder, hub.port, certificate.file);
  const browser = await startBrowser({ width: 400, height: 300, ignoreHTTPSErrors: true });
  t.after(() => browser.end());
  const page = await openPage(browser.context, `https://127.0.0.1:${proxy.port}/?panel=0`);
  await untilAllShown(page, 1);
  assert.deepEqual(page.complaints, []);
});
