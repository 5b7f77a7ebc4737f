// SPDX-License-Identifier: Apache-2.0
// When to tell the hub where this viewer's head is: when it has moved, at most 20 times a second, and the last place
// always, also when somebody new has come in.
import type { PlainPose } from './stream/protocol';
import { orientation, type ViewState } from './view/view_state';

const interval_ms = 50;

export class OwnPose {
  private sent_ms = -Infinity;
  private pending: ViewState | undefined;

  constructor(private readonly send: (head: PlainPose) => void) {}

  moved(view: ViewState): void {
    this.pending = view;
  }

  /** Once per screen refresh. */
  update(now_ms: number): void {
    if (!this.pending || now_ms - this.sent_ms < interval_ms) return;
    const { x, y, z } = this.pending.position;
    const turn = orientation(this.pending);
    this.send({ x, y, z, qx: turn.x, qy: turn.y, qz: turn.z, qw: turn.w });
    this.sent_ms = now_ms;
    this.pending = undefined;
  }
}
