// SPDX-License-Identifier: Apache-2.0
// The keys that move the viewer while they are held: WASD walk, Q and E go down and up, the arrow keys turn the head.
import { look, walk, type ViewState } from './view_state';

export const walkSpeed_mPerS = 1.4;
const turnSpeed_radPerS = 1.2;
const runFactor = 2.5;

interface Motion {
  forward: number;
  right: number;
  up: number;
  yaw: number; // to the left
  pitch: number; // upwards
}

const stillness: Motion = { forward: 0, right: 0, up: 0, yaw: 0, pitch: 0 };

/** Of each key, by KeyboardEvent.code, in units of the speed. */
const motions: Record<string, Partial<Motion>> = {
  KeyW: { forward: 1 },
  KeyS: { forward: -1 },
  KeyA: { right: -1 },
  KeyD: { right: 1 },
  KeyE: { up: 1 },
  KeyQ: { up: -1 },
  ArrowLeft: { yaw: 1 },
  ArrowRight: { yaw: -1 },
  ArrowUp: { pitch: 1 },
  ArrowDown: { pitch: -1 },
};

export function isMotionKey(code: string): boolean {
  return code in motions;
}

function sumOf(keys: Iterable<string>): Motion {
  const sum = { ...stillness };
  for (const key of keys) {
    for (const [axis, amount] of Object.entries(motions[key] ?? {})) sum[axis as keyof Motion] += amount;
  }
  return sum;
}

/** The view after holding `keys` for `seconds`; the same view if they cancel out. */
export function movedByKeys(view: ViewState, keys: Iterable<string>, seconds: number, fast: boolean): ViewState {
  const { forward, right, up, yaw, pitch } = sumOf(keys);
  if (!forward && !right && !up && !yaw && !pitch) return view;
  const pace = seconds * (fast ? runFactor : 1);
  const [step_m, step_rad] = [pace * walkSpeed_mPerS, pace * turnSpeed_radPerS];
  return walk(look(view, yaw * step_rad, pitch * step_rad), forward * step_m, right * step_m, up * step_m);
}
