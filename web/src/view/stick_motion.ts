// SPDX-License-Identifier: Apache-2.0
// How far a walking stick on the screen is pushed. Pure.

const dead = 0.15; // of the radius: a resting thumb does not walk

/** Shares of the walking speed, -1 to 1 together at most 1. */
export interface StickPush {
  forward: number;
  right: number;
}

/** `dx` to the right and `dy` down from the stick's middle, in the unit of `radius`. */
export function pushOf(dx: number, dy: number, radius: number): StickPush {
  const length = Math.hypot(dx, dy) / radius;
  if (!(length > dead)) return { forward: 0, right: 0 };
  const share = (Math.min(1, length) - dead) / (1 - dead) / length / radius;
  return { forward: -dy * share || 0, right: dx * share || 0 };
}
