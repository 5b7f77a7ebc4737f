// SPDX-License-Identifier: Apache-2.0
// Decides when to send this viewer's head and hand poses to the hub: after a movement, or when it sees more or less, at
// most 20 times a second, always including the final pose, and again when a new viewer joins.
import type { Body, ViewAngles } from './stream/protocol';
import { orientation, type ViewState } from './view/view_state';

const interval_ms = 50;

/** The body of a viewer at a screen: a head without hands. */
export function bodyOf(view: ViewState): Body {
  const { x, y, z } = view.position;
  const turn = orientation(view);
  const head = { x, y, z, qx: turn.x, qy: turn.y, qz: turn.z, qw: turn.w };
  return { head, leftHand: undefined, rightHand: undefined };
}

function isSame(a: ViewAngles | undefined, b: ViewAngles | undefined): boolean {
  return a?.halfAngle === b?.halfAngle && a?.halfWidth === b?.halfWidth && a?.halfHeight === b?.halfHeight;
}

export class PosePublisher {
  private sent_ms = -Infinity;
  private body: Body | undefined;
  private isUnsent = false;
  private view: ViewAngles | undefined; // as sent

  constructor(private readonly send: (body: Body) => void) {}

  moved(body: Body): void {
    this.body = body;
    this.isUnsent = true;
  }

  /** Call once per screen refresh. `view` as in Body. */
  update(now_ms: number, view: ViewAngles | undefined): void {
    const isUnsent = this.isUnsent || !isSame(view, this.view);
    if (!this.body || !isUnsent || now_ms - this.sent_ms < interval_ms) return;
    this.send({ ...this.body, view });
    this.sent_ms = now_ms;
    this.isUnsent = false;
    this.view = view;
  }
}
