// SPDX-License-Identifier: Apache-2.0
// Maps thumbsticks to actions: the left one walks smoothly, the right one turns in steps; pushed forward it aims, and
// teleports when released. Pure state, one per session.

const dead = 0.2;
const pushed = 0.7;
const released = 0.4;
const turnStep_rad = Math.PI / 6;

export interface Stick {
  x: number; // right, -1 to 1
  y: number; // back, -1 to 1
}

export interface StickWishes {
  right: number; // share of full speed
  forward: number;
  turn_rad: number; // once, counter-clockwise
  aims: boolean;
  letsGo: boolean; // released after aiming
}

function live(value: number): number {
  return Math.abs(value) < dead ? 0 : (value - Math.sign(value) * dead) / (1 - dead);
}

export class Sticks {
  private turned = false; // the stick must return before the next step
  private aiming = false;

  read(left: Stick | undefined, right: Stick | undefined): StickWishes {
    const wasAiming = this.aiming;
    const y = right?.y ?? 0;
    this.aiming = y < (wasAiming ? -released : -pushed);
    return {
      right: live(left?.x ?? 0),
      forward: -live(left?.y ?? 0),
      turn_rad: this.turn(right?.x ?? 0),
      aims: this.aiming,
      letsGo: wasAiming && !this.aiming,
    };
  }

  private turn(x: number): number {
    if (this.turned) {
      this.turned = Math.abs(x) > released;
      return 0;
    }
    if (Math.abs(x) < pushed || this.aiming) return 0;
    this.turned = true;
    return -Math.sign(x) * turnStep_rad;
  }
}
