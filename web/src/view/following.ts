// SPDX-License-Identifier: Apache-2.0
// One's view goes along with another person's: it moves towards theirs quickly, but not with a jerk. Pure.
import { between, viewFromBody, type ViewState } from './view_state';
import type { Pose } from '../gen/control_pb';

const easing_perS = 9;
const distance_m = 3; // to what the person looks at
const arrived_m = 1e-4;
const arrived_rad = 1e-4;

function isSame(a: ViewState, b: ViewState): boolean {
  const turn = Math.abs(Math.atan2(Math.sin(b.yaw - a.yaw), Math.cos(b.yaw - a.yaw)));
  return a.position.distanceTo(b.position) < arrived_m && turn < arrived_rad && Math.abs(a.pitch - b.pitch) < arrived_rad;
}

/**
 * The view `seconds` later when it follows the person with this head; the same object when it is there already.
 * `atOnce`: without a way there.
 */
export function followed(view: ViewState, head: Pose, seconds: number, atOnce: boolean): ViewState {
  const theirs = viewFromBody(head, distance_m);
  if (isSame(view, theirs)) return view;
  return between(view, theirs, atOnce ? 1 : 1 - Math.exp(-easing_perS * seconds));
}
