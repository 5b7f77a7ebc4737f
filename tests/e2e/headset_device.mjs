// SPDX-License-Identifier: Apache-2.0
// A WebXR device implemented in JavaScript (iwer), which pages of a browser find, its right hand, and the wearer's own room.
import { createRequire } from 'node:module';
import { setTimeout as delay } from 'node:timers/promises';
import { stateOf, until } from './waiting.mjs';

const iwer = createRequire(new URL('../../web/package.json', import.meta.url)).resolve('iwer/build/iwer.min.js');

/**
 * Runs before the page's own scripts and installs a headset with two controllers. (iwer 2.5 expects a matrix where
 * WebXR specifies a transform; without this it would ignore the wearer's position.)
 */
const plugIn = `
  window.device = new IWER.XRDevice(IWER.metaQuest3);
  window.device.installRuntime({ forceInstall: true });
  const offset = XRReferenceSpace.prototype.getOffsetReferenceSpace;
  XRReferenceSpace.prototype.getOffsetReferenceSpace = function (transform) {
    return offset.call(this, transform.matrix);
  };
  window.device.stereoEnabled = true;
  window.device.position.set(0, 1.7, 0);
  window.device.quaternion.set(0, 0, 0, 1);

  // The wearer's own room: a floor, a table, and a wall 4 m away. A pose's y axis is the surface's normal. Columns first.
  const upright = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];
  const wall = [1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0];
  window.device.installSEM(class {
    environmentCanvas = document.createElement('canvas');
    trackedPlanes = new Set();
    trackedMeshes = new Set();
    render() {}
    computeHitTestResults(ray) {
      const [dx, dy, dz] = [-ray[8], -ray[9], -ray[10]];
      const meets = (length, axes, isOn) => {
        const at = [ray[12] + length * dx, ray[13] + length * dy, ray[14] + length * dz];
        return length > 0 && isOn(at) ? [{ length, matrix: new Float32Array([...axes, ...at, 1]) }] : [];
      };
      const isOnTable = ([x, , z]) => Math.abs(x - 1) < 0.4 && Math.abs(z + 1) < 0.4;
      const found = [
        ...meets((0.75 - ray[13]) / dy, upright, isOnTable),
        ...meets(-ray[13] / dy, upright, ([, , z]) => z > -4),
        ...meets((-4 - ray[14]) / dz, wall, ([, y]) => y > 0 && y < 2.5),
      ];
      return found.sort((a, b) => a.length - b.length).map(({ matrix }) => matrix);
    }
  });
`;

export async function wearHeadsets(context) {
  await context.addInitScript({ path: iwer });
  await context.addInitScript({ content: plugIn });
}

/** Points the right hand, which is at the head, at a place in the wearer's own room. */
export async function pointAt(page, target) {
  await page.evaluate(([x, y, z]) => {
    const { position } = window.device;
    const [dx, dy, dz] = [x - position.x, y - position.y, z - position.z];
    const [yaw, pitch] = [Math.atan2(-dx, -dz) / 2, Math.atan2(dy, Math.hypot(dx, dz)) / 2];
    const { right } = window.device.controllers;
    right.position.set(position.x, position.y, position.z);
    const [cy, sy, cp, sp] = [Math.cos(yaw), Math.sin(yaw), Math.cos(pitch), Math.sin(pitch)];
    right.quaternion.set(cy * sp, sy * cp, -sy * sp, cy * cp);
  }, target);
  await pictures(page, 3);
}

export async function pullTrigger(page) {
  await page.evaluate(() => window.device.controllers.right.updateButtonValue('trigger', 1));
  await pictures(page, 2);
  await page.evaluate(() => window.device.controllers.right.updateButtonValue('trigger', 0));
  await pictures(page, 2);
}

const pictures = async (page, count) => {
  const before = (await stateOf(page)).pictures;
  await until('pictures', () => stateOf(page), (now) => now.pictures >= before + count);
};

/** Points the right hand at the button with this text, on the panel that `panelOf` tells of, and pulls the trigger. */
export async function pressOnBoard(page, panelOf, text) {
  const buttons = async () => {
    const panel = await panelOf();
    return [...(panel?.board?.buttons ?? []), ...(panel?.tile?.buttons ?? [])];
  };
  const found = await until(`the button ${text}`, buttons, (all) => all.some((button) => button.text === text));
  const { at } = found.find((button) => button.text === text);
  const target = await page.evaluate(([x, y, z]) => {
    // The wearer's own space differs from the room by where they stand.
    const { head } = window.roomcast.headset();
    const { position, quaternion } = window.device;
    const heading = Math.atan2(2 * (head.qw * head.qy), 1 - 2 * head.qy * head.qy);
    const ownHeading = Math.atan2(2 * (quaternion.w * quaternion.y), 1 - 2 * quaternion.y * quaternion.y);
    const turn = ownHeading - heading;
    const [dx, dy, dz] = [x - head.x, y - head.y, z - head.z];
    const [sin, cos] = [Math.sin(turn), Math.cos(turn)];
    return [position.x + cos * dx + sin * dz, position.y + dy, position.z - sin * dx + cos * dz];
  }, at);
  await pointAt(page, target);
  await pullTrigger(page);
  await delay(50);
}
