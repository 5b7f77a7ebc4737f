// SPDX-License-Identifier: Apache-2.0
// What a press on the room is for while one of the tools is chosen.
import type { Vector3 } from 'three';
import type { CanvasHand } from '../view/canvas_hand';
import type { Drawn } from './mark_scene';

export const tools = ['point', 'note', 'sketch', 'measure'] as const;
export type Tool = (typeof tools)[number];

export interface ToolHand extends CanvasHand {
  /** Once per screen refresh. */
  update(): void;
  /** Another tool was chosen, or none. */
  end(): void;
}

/** What a tool sees of the room, and does to it. Pixels are CSS pixels of the canvas. */
export interface ToolRoom {
  /** The surface at a pixel; undefined where there is nothing. */
  pick(x: number, y: number): Vector3 | undefined;
  /** The same, for many pixels of one picture. */
  pickMany(): (x: number, y: number) => Vector3 | undefined;
  /** Changes whenever the view does. */
  readonly viewStamp: string;
  readonly color: number;
  show(drafts: readonly Drawn[]): void;
  say(sentence: string): void;
}
