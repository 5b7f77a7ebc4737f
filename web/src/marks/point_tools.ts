// SPDX-License-Identifier: Apache-2.0
// Tools that need single points of surfaces: a note's place, and the two ends of a distance. The point is where the
// button or the finger is let go, so that one can correct it.
import type { Vector3 } from 'three';
import { MarkKind } from '../gen/control_pb';
import { markTexts as texts } from '../mark_texts';
import type { Drawn } from './mark_scene';
import type { ToolHand, ToolRoom } from './tool';

abstract class PointTool implements ToolHand {
  private pixel: { x: number; y: number } | undefined;

  constructor(protected readonly room: ToolRoom) {}

  protected abstract chosen(point: Vector3): void;
  abstract end(): void;

  press(x: number, y: number): void {
    this.pixel = { x, y };
  }

  drag(x: number, y: number): void {
    this.pixel = { x, y };
  }

  release(): void {
    const { pixel } = this;
    this.pixel = undefined;
    if (!pixel) return;
    const point = this.room.pick(pixel.x, pixel.y);
    if (point) this.chosen(point);
    else this.room.say(texts.nothingThere);
  }

  cancel(): void {
    this.pixel = undefined;
  }

  update(): void {}
}

export class NoteTool extends PointTool {
  constructor(
    room: ToolRoom,
    private readonly ask: (point: Vector3) => void,
    private readonly close: () => void,
  ) {
    super(room);
  }

  protected chosen(point: Vector3): void {
    this.room.show([{ kind: MarkKind.NOTE, points: point.toArray(), text: '…', colorRgb: this.room.color }]);
    this.ask(point);
  }

  end(): void {
    this.room.show([]);
    this.close();
  }
}

export class MeasureTool extends PointTool {
  private ends: Vector3[] = [];

  /** `measured` gets both ends. */
  constructor(
    room: ToolRoom,
    private readonly measured: (from: Vector3, to: Vector3) => void,
  ) {
    super(room);
  }

  protected chosen(point: Vector3): void {
    this.ends = this.ends.length === 1 ? [this.ends[0]!, point] : [point];
    const [from, to] = this.ends;
    const first: Drawn = { kind: MarkKind.NOTE, points: from!.toArray(), text: texts.from, colorRgb: this.room.color };
    if (!to) {
      this.room.show([first]);
      return this.room.say(texts.measureTo);
    }
    const points = [...from!.toArray(), ...to.toArray()];
    this.room.show([{ kind: MarkKind.DISTANCE, points, text: '', colorRgb: this.room.color }]);
    this.measured(from!, to);
  }

  end(): void {
    this.ends = [];
    this.room.show([]);
  }
}
