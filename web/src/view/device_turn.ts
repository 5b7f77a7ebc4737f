// SPDX-License-Identifier: Apache-2.0
// How a phone is turned, from the angles of the browser's deviceorientation event (W3C Device Orientation, intrinsic z-x'-y'')
// and the orientation of its screen: the direction in which its back looks. Degrees in, radians out. Pure.
import { Euler, MathUtils, Quaternion, Vector3 } from 'three';

const screenFromDevice = new Quaternion(-Math.SQRT1_2, 0, 0, Math.SQRT1_2); // the camera looks out of the back, not the top
const axis = new Vector3(0, 0, 1);

export interface Gaze {
  yaw: number;
  pitch: number;
}

export function gazeOf(alpha: number, beta: number, gamma: number, screen: number): Gaze {
  const [a, b, g, s] = [alpha, beta, gamma, screen].map((degrees) => MathUtils.degToRad(degrees)) as [number, number, number, number];
  const turn = new Quaternion()
    .setFromEuler(new Euler(b, a, -g, 'YXZ'))
    .multiply(screenFromDevice)
    .multiply(new Quaternion().setFromAxisAngle(axis, -s));
  const { x, y, z } = new Vector3(0, 0, -1).applyQuaternion(turn);
  return { yaw: Math.atan2(-x, -z), pitch: Math.asin(MathUtils.clamp(y, -1, 1)) };
}

/** From `before` to `now`, the shorter way round. */
export function turnBetween(before: Gaze, now: Gaze): Gaze {
  const yaw = now.yaw - before.yaw;
  return { yaw: Math.atan2(Math.sin(yaw), Math.cos(yaw)), pitch: now.pitch - before.pitch };
}
