// SPDX-License-Identifier: Apache-2.0
// Moves a sensor's pose by hand: shifts it, turns it about the vertical and tilts it, or sets it to the user's view.
// Row-major 4x4 world_from_depth, metres, radians, y up. Pure.
import { direction, type ViewState } from './view_state';

export interface Push {
  x: number; // along the world's axes
  y: number;
  z: number;
  turn: number; // about the vertical through the sensor, counter-clockwise seen from above
  tilt: number; // about the sensor's own horizontal axis, upwards
}

/** A push relative to the user's viewing direction. */
export interface HandStep {
  right: number;
  up: number;
  forward: number;
  turn: number;
  tilt: number;
}

/** The sensor's axes after tilting it upwards. */
function tilted(m: readonly number[], tilt: number): number[] {
  const c = Math.cos(tilt);
  const s = Math.sin(tilt);
  const row = (i: number) => [m[i]!, c * m[i + 1]! + s * m[i + 2]!, c * m[i + 2]! - s * m[i + 1]!, m[i + 3]!];
  return [...row(0), ...row(4), ...row(8), ...m.slice(12)];
}

/** The pose after the push: tilted and turned in place, then shifted. */
export function pushed(worldFromDepth: readonly number[], push: Push): number[] {
  const c = Math.cos(push.turn);
  const s = Math.sin(push.turn);
  const m = tilted(worldFromDepth, push.tilt);
  const rotated = [0, 1, 2].map((column) => {
    const x = m[column]!;
    const z = m[8 + column]!;
    return [c * x + s * z, m[4 + column]!, -s * x + c * z] as const;
  });
  const row = (axis: 0 | 1 | 2, shift: number) => [...rotated.map((column) => column[axis]), shift];
  return [
    ...row(0, m[3]! + push.x),
    ...row(1, m[7]! + push.y),
    ...row(2, m[11]! + push.z),
    ...[0, 0, 0, 1],
  ];
}

/** `heading` is the user's viewing direction, radians about the vertical, 0 along -z. */
export function alongView({ right, up, forward, turn, tilt }: HandStep, heading: number): Push {
  const c = Math.cos(heading);
  const s = Math.sin(heading);
  return { x: right * c - forward * s, y: up, z: -right * s - forward * c, turn, tilt };
}

/** A sensor pose with the viewer's position and direction. */
export function standingLike(view: Pick<ViewState, 'position' | 'yaw' | 'pitch'>): number[] {
  const { x, y, z } = view.position;
  const ahead = direction(view);
  const right = { x: Math.cos(view.yaw), z: -Math.sin(view.yaw) };
  const down = [ahead.y * right.z, ahead.z * right.x - ahead.x * right.z, -ahead.y * right.x] as const;
  return [right.x, down[0], ahead.x, x, 0, down[1], ahead.y, y, right.z, down[2], ahead.z, z, 0, 0, 0, 1];
}
