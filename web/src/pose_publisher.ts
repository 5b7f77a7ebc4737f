// SPDX-License-Identifier: Apache-2.0
// Decides when to send this viewer's head and hand poses to the hub: after a movement, or when it sees more or less, at
// most 20 times a second, always including the final pose, and again when a new viewer joins.
import type { Body } from './stream/protocol';
import { orientation, type ViewState } from './view/view_state';

const interval_ms = 50;

/** The body of a viewer at a screen: a head without hands. */
export function bodyOf(view: ViewState): Body {
  const { x, y, z } = view.position;
  const turn = orientation(view);
  const head = { x, y, z, qx: turn.x, qy: turn.y, qz: turn.z, qw: turn.w };
  return { head, leftHand: undefined, rightHand: undefined };
}

export class PosePublisher {
  private sent_ms = -Infinity;
  private body: Body | undefined;
  private isUnsent = false;
  private viewHalfAngle = 0; // as sent

  constructor(private readonly send: (body: Body) => void) {}

  moved(body: Body): void {
    this.body = body;
    this.isUnsent = true;
  }

  /** Call once per screen refresh. `viewHalfAngle` as in Body. */
  update(now_ms: number, viewHalfAngle: number): void {
    const isUnsent = this.isUnsent || viewHalfAngle !== this.viewHalfAngle;
    if (!this.body || !isUnsent || now_ms - this.sent_ms < interval_ms) return;
    this.send({ ...this.body, viewHalfAngle });
    this.sent_ms = now_ms;
    this.isUnsent = false;
    this.viewHalfAngle = viewHalfAngle;
  }
}
