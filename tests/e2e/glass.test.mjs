// SPDX-License-Identifier: Apache-2.0
// How old what the page shows is: a sensor draws the time of capture into its pictures as black and white squares, and the
// time is read back from the pixels of the page's canvas (bench/latency/capture_clock.h describes the squares). The test
// requires that times can be read; the ages are for the report, since this machine draws in software.
// ROOMCAST_GLASS_SECONDS asks for a longer measurement.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openPage, startBrowser } from './browser.mjs';
import { requireBuilt, startClockSensors, startHub } from './programs.mjs';
import { sensorsOf, slow, until, untilAllShown } from './waiting.mjs';

const sensors = 3;
const size = [640, 480];
const seconds = Number(process.env.ROOMCAST_GLASS_SECONDS ?? 8);

/**
 * Runs in the page: looks at every picture right after it was drawn. Returns the ages, ms, of the times that were seen,
 * each when it was seen first, and how many pictures were drawn and how many of them showed no time.
 */
function watchCanvas({ view, seconds }) {
  const dark = 100; // of 255
  const leastMore = 0.2; // share of dark pixels by which a black square differs from a white one
  const around_px = 10; // of a square of 36
  const canvas = document.querySelector('canvas');
  const gl = canvas.getContext('webgl2'); // the page's own
  const minus = (a, b) => a.map((v, i) => v - b[i]);
  const dot = (a, b) => a.reduce((sum, v, i) => sum + v * b[i], 0);
  const unit = (a) => a.map((v) => v / Math.sqrt(dot(a, a)));
  const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
  const forward = unit(minus(view.look, view.at));
  const right = unit(cross(forward, [0, 1, 0]));
  const up = cross(right, forward);
  const halfField = Math.tan(Math.PI / 6);

  /** From the bottom left, as WebGL counts. */
  function pixelOf(point, width, height) {
    const ray = minus(point, view.at);
    const scale = height / 2 / halfField / dot(ray, forward);
    return [Math.round(width / 2 + scale * dot(ray, right)), Math.round(height / 2 + scale * dot(ray, up))];
  }

  /**
   * The share of dark pixels in each square: holes of the surface are bright, in black squares as in white ones. Undefined where
   * nothing was drawn since the last picture.
   */
  function squares() {
    const [width, height] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
    const bound = gl.getParameter(gl.FRAMEBUFFER_BINDING);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    const side = 2 * around_px + 1;
    const rgba = new Uint8Array(4 * side * side);
    let drawn = 0;
    const shares = view.squares.map((point) => {
      const [x, y] = pixelOf(point, width, height);
      gl.readPixels(x - around_px, y - around_px, side, side, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
      let pixels = 0;
      for (let i = 0; i < rgba.length; i += 4) {
        if (rgba[i + 1] < dark) pixels++;
        drawn += rgba[i + 3];
      }
      return pixels / side / side;
    });
    gl.bindFramebuffer(gl.FRAMEBUFFER, bound);
    return drawn > 0 ? shares : undefined;
  }

  function timeOf(shares) {
    let time_ms = 0;
    for (let i = 0; i < shares.length; i += 2) {
      const difference = shares[i + 1] - shares[i];
      if (Math.abs(difference) < leastMore) return undefined;
      if (difference > 0) time_ms |= 1 << (i / 2);
    }
    return time_ms;
  }

  return new Promise((resolve) => {
    const result = { ages_ms: [], pictures: 0, unread: 0 };
    const end = performance.now() + 1000 * seconds;
    let last;
    let before = '';
    function look() {
      const shares = squares();
      const now = Date.now();
      const same = shares?.join() === before;
      before = shares?.join() ?? before;
      if (shares && !same) {
        result.pictures++;
        const time_ms = timeOf(shares);
        if (time_ms === undefined) result.unread++;
        else if (time_ms !== last) result.ages_ms.push((((now - time_ms) & 0xffff) << 16) >> 16);
        last = time_ms ?? last;
      }
      if (performance.now() < end) requestAnimationFrame(look);
      else resolve(result);
    }
    requestAnimationFrame(look);
  });
}

const percentile = (sorted, share) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];

test('the age of what the canvas shows can be read', slow, async (t) => {
  requireBuilt();
  const hub = await startHub();
  t.after(() => hub.end());
  const clock = await startClockSensors(hub);
  t.after(() => clock.end());
  const browser = await startBrowser({ width: size[0], height: size[1] });
  t.after(() => browser.end());
  const page = await openPage(browser.context, `${hub.page}?panel=0`);
  await untilAllShown(page, sensors);
  await page.evaluate((view) => {
    window.roomcast.setMode('mesh');
    window.roomcast.setView(view.at, view.look);
  }, clock.view);
  for (const { id, name } of await sensorsOf(page))
    if (name !== clock.view.sensor) await page.evaluate((id) => window.roomcast.setVisible(id, false), id);
  await until('a readable time', () => page.evaluate(watchCanvas, { view: clock.view, seconds: 2 }), (seen) => seen.ages_ms.length > 0);
  const seen = await page.evaluate(watchCanvas, { view: clock.view, seconds });
  const ages_ms = seen.ages_ms.sort((a, b) => a - b);
  t.diagnostic(
    `glass: page, p50 ${percentile(ages_ms, 0.5)} ms, p95 ${percentile(ages_ms, 0.95)} ms, ` +
      `${(seen.pictures / seconds).toFixed(1)} different pictures/s, ${((100 * seen.unread) / seen.pictures).toFixed(0)} % show no time`,
  );
  assert.ok(ages_ms.length >= 3, `${ages_ms.length} times were seen`);
  assert.ok(ages_ms[0] > 0, `an age of ${ages_ms[0]} ms: the clock was read wrongly`);
});
