// SPDX-License-Identifier: Apache-2.0
// Draws on surfaces while the button or the finger is down, or, by keyboard, with what is in the middle of the view.
import { MarkKind } from '../gen/control_pb';
import { markTexts as texts } from '../mark_texts';
import type { Drawn } from './mark_scene';
import { Stroke } from './stroke';
import type { ToolHand, ToolRoom } from './tool';

export class SketchTool implements ToolHand {
  private stroke: Stroke | undefined;
  private points: { stamp: string; at: ReturnType<ToolRoom['pickMany']> } | undefined;
  private changed = false;

  /** `leave` gets x, y, z of each point of each line of a stroke. */
  constructor(
    private readonly room: ToolRoom,
    private readonly leave: (sketches: number[][]) => void,
  ) {}

  press(x: number, y: number): void {
    this.stroke = new Stroke();
    this.points = undefined;
    this.drag(x, y);
  }

  drag(x: number, y: number): void {
    const { stroke, room } = this;
    if (!stroke) return;
    const stamp = room.viewStamp;
    if (this.points?.stamp !== stamp) this.points = { stamp, at: room.pickMany() };
    const point = this.points.at(x, y);
    if (point && stroke.add(point)) this.changed = true;
  }

  release(): void {
    const sketches = this.stroke?.sketches ?? [];
    const wasMeant = this.stroke !== undefined;
    this.cancel();
    if (sketches.length > 0) this.leave(sketches);
    else if (wasMeant) this.room.say(texts.nothingDrawn);
  }

  cancel(): void {
    this.stroke = this.points = undefined;
    this.room.show([]);
  }

  update(): void {
    if (!this.changed || !this.stroke) return;
    this.changed = false;
    this.room.show(this.stroke.sketches.map((points) => sketchOf(points, this.room.color)));
  }

  end(): void {
    this.cancel();
  }
}

function sketchOf(points: number[], colorRgb: number): Drawn {
  return { kind: MarkKind.SKETCH, points, text: '', colorRgb };
}
