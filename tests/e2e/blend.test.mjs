// SPDX-License-Identifier: Apache-2.0
// Blending and the background model, on synthetic pictures: a sensor in front of a wall, and an object that appears
// between them and disappears again.
import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import { startBrowser } from './browser.mjs';
import { openSourcePage } from './source_pages.mjs';
import { slow } from './waiting.mjs';

/** Runs in the page. Makes a room of sensors of 64x48 pixels that look along -z, at the origin or to its side. */
async function makeRoom() {
  const THREE = await import('three');
  const { RoomScene } = await import('/view/room_scene');
  const { qualities } = await import('/view/quality_ladder');
  const [width, height] = [64, 48];
  const lens = { width, height, fx: 60, fy: 60, cx: 31.5, cy: 23.5, k1: 0, k2: 0, k3: 0, p1: 0, p2: 0 };
  const renderer = new THREE.WebGLRenderer({ canvas: document.querySelector('canvas') });
  const room = new RoomScene(renderer);
  const camera = new THREE.PerspectiveCamera(40, width / height, 0.05, 100);
  camera.updateMatrixWorld();
  const at = (x) => [1, 0, 0, x, 0, -1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1]; // y down, z forward -> the world
  const opposite = [-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, -3, 0, 0, 0, 1]; // 3 m in front of the eye, and looks back at it
  const place = (...xs) => placeAt(...xs.map(at));
  const placeAt = (...poses) => {
    const sensors = poses.map((worldFromDepth, id) => ({
      id,
      name: `s${id}`,
      online: true,
      calibration: { depth: lens },
      pose: { worldFromDepth, source: 'given', state: 'valid', expectedErrorMm: 0, note: '' },
    }));
    room.follow({ sensors, viewers: [] }, -1);
    room.setMode('blend');
    room.setQuality(qualities[0], camera.position, 60);
  };
  /** `pixelOf(u, v)` gives [depth_mm, r, g, b]. */
  const see = (sensor, pixelOf, capture_ms = undefined, flow = undefined) => {
    const depth_mm = new Uint16Array(width * height);
    const rgba = new Uint8Array(4 * width * height);
    for (let i = 0; i < depth_mm.length; i++) {
      const [depth, ...color] = pixelOf(i % width, Math.floor(i / width));
      depth_mm[i] = depth;
      rgba.set([...color, depth > 0 ? 255 : 0], 4 * i); // pixels without a reading have an arbitrary colour
    }
    room.show([{ sensor, width, height, depth_mm, flow, rgba, capture_ms }]);
    draw();
  };
  const size = 96;
  const target = new THREE.WebGLRenderTarget(size, size);
  const draw = () => {
    renderer.setRenderTarget(target);
    room.render(camera, size, size);
    renderer.setRenderTarget(null);
  };
  /** All that is nearer than 2 m moves to the right. */
  const rightwards = (metresPerSecond) => {
    const flow = new Float32Array(4 * (width / 4) * (height / 4));
    for (let cell = 0; cell < flow.length; cell += 4) flow.set([metresPerSecond, 0, 0, 2], cell);
    return flow;
  };
  /** The colour in the middle of the picture, or `right` pixels to the right of it. */
  const middle = (right = 0) => {
    draw();
    const rgba = new Uint8Array(4);
    renderer.readRenderTargetPixels(target, size / 2 + right, size / 2, 1, 1, rgba);
    return [...rgba];
  };
  const inBox = (u, v) => Math.abs(u - 31.5) < 8 && Math.abs(v - 23.5) < 8;
  const take = (model) => room.model.take(model);
  const setMode = (mode) => room.setMode(mode);
  window.room = { place, placeAt, opposite, see, rightwards, middle, take, setMode, inBox, red: [200, 20, 20], green: [20, 200, 20], blue: [20, 20, 200] };
}

const isNear = (color, wanted) => wanted.every((value, i) => Math.abs(color[i] - value) < 25);

describe('blended surfaces', () => {
  let browser, page;
  before(async () => {
    browser = await startBrowser({ width: 200, height: 150 });
  }, slow);
  after(() => browser?.end(), slow);

  const freshRoom = async (t) => {
    page = await openSourcePage(browser.context, 'https://blend.test');
    t.after(() => page.close());
    await page.evaluate(makeRoom);
  };

  test(
    'background fills lost readings, and never shows through an object in front of it',
    slow,
    async (t) => {
      await freshRoom(t);
      const colors = await page.evaluate(() => {
        const { place, see, middle, inBox, red, green } = window.room;
        place(0);
        for (let i = 0; i < 10; i++) see(0, () => [3000, ...red]);
        const wall = middle();
        see(0, (u, v) => (inBox(u, v) ? [1500, ...green] : [3000, ...red]));
        const box = middle();
        see(0, (u, v) => (inBox(u, v) ? [0, ...green] : [3000, ...red]));
        return { wall, box, lost: middle() };
      });
      assert.ok(isNear(colors.wall, [200, 20, 20]), `the wall: ${colors.wall}`);
      assert.ok(isNear(colors.box, [20, 200, 20]), `in front of it: ${colors.box}`);
      assert.ok(isNear(colors.lost, [200, 20, 20]), `remembered: ${colors.lost}`);
      assert.deepEqual(page.complaints, []);
    },
  );

  test('a removed object is forgotten as soon as the sensor reads the surface behind it', slow, async (t) => {
    await freshRoom(t);
    const color = await page.evaluate(() => {
      const { place, see, middle, red, blue } = window.room;
      place(0);
      for (let i = 0; i < 10; i++) see(0, () => [2000, ...red]);
      for (let i = 0; i < 4; i++) see(0, () => [4000, ...blue]);
      return middle();
    });
    assert.ok(isNear(color, [20, 20, 200]), String(color));
  });

  test('what a late sensor saw is gone where another one sees through it, until its next picture', slow, async (t) => {
    await freshRoom(t);
    const colors = await page.evaluate(() => {
      const { place, see, middle, inBox, red, green } = window.room;
      place(0, 0.01);
      const box = (u, v) => (inBox(u, v) ? [1500, ...green] : [3000, ...red]);
      for (let i = 0; i < 10; i++) see(0, () => [3000, ...red], 100 * i);
      see(0, box, 1000);
      const inTime = middle();
      see(1, () => [3000, ...red], 1250);
      const early = middle();
      see(1, () => [3000, ...red], 1350);
      const late = middle();
      see(0, box, 1380);
      return { inTime, early, late, again: middle() };
    });
    const [boxColor, wallColor] = [[20, 200, 20], [200, 20, 20]];
    assert.ok(isNear(colors.inTime, boxColor) && isNear(colors.early, boxColor), JSON.stringify(colors));
    assert.ok(isNear(colors.late, wallColor), JSON.stringify(colors));
    assert.ok(isNear(colors.again, boxColor), JSON.stringify(colors));
    assert.deepEqual(page.complaints, []);
  });

  test('what moves is drawn where it is between the pictures of two sensors', slow, async (t) => {
    await freshRoom(t);
    const colors = await page.evaluate(() => {
      const { place, see, rightwards, middle, inBox, red, green } = window.room;
      place(0, 0.01);
      const box = (u, v) => (inBox(u, v) ? [1500, ...green] : [3000, ...red]);
      for (let i = 0; i < 10; i++) see(0, () => [3000, ...red], 100 * i);
      const beside = 22; // pixels of the picture: right of the box, which is about 34 wide
      see(0, box, 1000, rightwards(6));
      const seen = [middle(), middle(beside)];
      see(1, () => [0, ...red], 1080); // sees nothing, 80 ms later: the box is 24 cm farther, about 20 pixels
      const later = [middle(-14), middle(beside)];
      see(0, box, 1080);
      return { seen, later, still: [middle(), middle(beside)] };
    });
    const [boxColor, wallColor] = [[20, 200, 20], [200, 20, 20]];
    const areNear = (found, wanted) => assert.ok(found.every((color, i) => isNear(color, wanted[i])), JSON.stringify(colors));
    areNear(colors.seen, [boxColor, wallColor]);
    areNear(colors.later, [wallColor, boxColor]);
    areNear(colors.still, [boxColor, wallColor]);
    assert.deepEqual(page.complaints, []);
  });

  test('the back of what moves is seen although nothing is known of what is behind it', slow, async (t) => {
    await freshRoom(t);
    const colors = await page.evaluate(() => {
      const { placeAt, opposite, see, rightwards, middle, inBox, green } = window.room;
      placeAt(opposite);
      const box = (u, v) => (inBox(u, v) ? [1500, ...green] : [0, 0, 0, 0]);
      for (let i = 0; i < 3; i++) see(0, box, 100 * i);
      const still = middle();
      see(0, box, 300, rightwards(0.1));
      const slow = middle();
      see(0, box, 400, rightwards(1));
      return { still, slow, moving: middle() };
    });
    assert.ok(isNear(colors.moving, [20, 200, 20]), JSON.stringify(colors));
    assert.ok(!isNear(colors.still, [20, 200, 20]) && !isNear(colors.slow, [20, 200, 20]), JSON.stringify(colors));
    assert.deepEqual(page.complaints, []);
  });

  test('background that another sensor sees through is removed', slow, async (t) => {
    await freshRoom(t);
    const color = await page.evaluate(() => {
      const { place, see, middle, red, blue } = window.room;
      place(0, 0.1);
      see(1, () => [0, 0, 0, 0]);
      for (let i = 0; i < 10; i++) see(0, () => [2000, ...red]);
      see(0, () => [0, 0, 0, 0]); // the first sensor loses all readings; the other one sees that the object is gone
      for (let i = 0; i < 8; i++) see(1, () => [4000, ...blue]);
      for (let i = 0; i < 8; i++) see(0, () => [0, 0, 0, 0]);
      return middle();
    });
    assert.ok(isNear(color, [20, 20, 200]), String(color));
  });

  test('a surface that two sensors see has the mean of their colours', slow, async (t) => {
    await freshRoom(t);
    const color = await page.evaluate(() => {
      const { place, see, middle } = window.room;
      place(-0.1, 0.1);
      see(0, () => [2000, 200, 0, 100]);
      see(1, () => [2005, 0, 200, 100]);
      return middle();
    });
    assert.ok(isNear(color, [100, 100, 100]), String(color));
  });

  test('areas that no sensor sees take the colour of their surroundings', slow, async (t) => {
    await freshRoom(t);
    const color = await page.evaluate(() => {
      const { place, see, middle, inBox, green } = window.room;
      place(0);
      see(0, (u, v) => (inBox(u, v) ? [0, ...green] : [3000, ...green]));
      return middle();
    });
    assert.ok(isNear(color, [20, 200, 20]), String(color));
  });

  test('the room’s model fills what no sensor shows, and nothing else', slow, async (t) => {
    await freshRoom(t);
    const colors = await page.evaluate(() => {
      const { place, see, middle, take, setMode, inBox, green } = window.room;
      place(0);
      see(0, (u, v) => (inBox(u, v) ? [3000, ...green] : [0, 0, 0, 0]));
      const without = middle(40);
      const wall = { positions: [-9, -9, -2, 9, -9, -2, 0, 9, -2], colors: [200, 20, 20, 200, 20, 20, 200, 20, 20] };
      const geometry = {
        positions: new Float32Array(wall.positions),
        colors: new Uint8Array(wall.colors),
        indices: new Uint32Array([0, 1, 2]),
      };
      take({ isWhole: true, pieces: [{ key: 'wall', geometry }] });
      const withModel = { middle: middle(), beside: middle(40) };
      setMode('still');
      const alone = middle();
      setMode('blend');
      take({ isWhole: false, pieces: [{ key: 'wall', geometry: undefined }] });
      return { without, withModel, alone, gone: middle(40) };
    });
    assert.ok(isNear(colors.without, [20, 200, 20]), `smeared: ${colors.without}`);
    assert.ok(isNear(colors.withModel.middle, [20, 200, 20]), `what a sensor shows, though the model is nearer: ${colors.withModel.middle}`);
    assert.ok(isNear(colors.withModel.beside, [200, 20, 20]), `filled: ${colors.withModel.beside}`);
    assert.ok(isNear(colors.alone, [200, 20, 20]), `the still room alone: ${colors.alone}`);
    assert.ok(isNear(colors.gone, [20, 200, 20]), `after its piece has gone: ${colors.gone}`);
    assert.deepEqual(page.complaints, []);
  });
});
