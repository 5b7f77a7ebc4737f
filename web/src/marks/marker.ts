// SPDX-License-Identifier: Apache-2.0
// Leaves marks, and draws and lists those of the room. Loaded when the room has marks, or when a tool is chosen for the
// first time (marking.ts).
import './marks.css';
import type { Vector3 } from 'three';
import { MarkKind, type Mark } from '../gen/control_pb';
import type { NewMark } from '../stream/protocol';
import { markTexts as texts } from '../mark_texts';
import type { Stage } from '../view/stage';
import type { SurfacePick } from '../view/surface_pick';
import { MarkList } from './mark_list';
import { inMetres, MarkScene, type Drawn } from './mark_scene';
import { NoteForm } from './note_form';
import { MeasureTool, NoteTool } from './point_tools';
import { pointsOf } from './points';
import { SketchTool } from './sketch_tool';
import type { Tool, ToolHand, ToolRoom } from './tool';

const towardsEye = 0.004; // of the distance: a line on a surface is drawn in front of its noise

/** A sentence, and what one can do about it. */
export interface Said {
  sentence: string;
  action?: { label: string; run(): void };
}

export interface MarkerParts {
  stage: Stage;
  pick: SurfacePick;
  root: HTMLElement; // for the list and the form
}

export interface MarkerEvents {
  /** False where there is no connection: the mark is not left. */
  leave(mark: NewMark): boolean;
  remove(ids: number[]): void;
  say(said: Said): void;
  goTo(point: Vector3): void;
  color(): number; // this viewer's own
  mayLeave(): boolean;
  mayRemove(mark: Mark): boolean;
}

export class Marker {
  private readonly scene = new MarkScene();
  private readonly list: MarkList;
  private readonly form: NoteForm;
  private readonly hands: Record<Exclude<Tool, 'point'>, ToolHand>;
  private chosen: ToolHand | undefined;

  constructor(
    private readonly parts: MarkerParts,
    private readonly events: MarkerEvents,
  ) {
    const room = this.room();
    this.form = new NoteForm(() => this.closed());
    this.list = new MarkList({
      go: (mark) => events.goTo(pointsOf(mark)[0]!),
      remove: (ids) => events.remove(ids),
      shown: (shown) => this.setShown(shown),
    });
    this.hands = {
      note: new NoteTool(room, (point) => this.askFor(point), () => this.form.close()),
      sketch: new SketchTool(room, (sketches) => this.leaveSketches(sketches)),
      measure: new MeasureTool(room, (from, to) => this.measured(from, to)),
    };
    parts.stage.room.scene.add(this.scene.root);
    parts.root.append(this.form.root, this.list.root);
  }

  /** What takes presses on the room from now on. */
  choose(tool: Exclude<Tool, 'point'> | undefined): ToolHand | undefined {
    this.chosen?.end();
    this.chosen = tool && this.hands[tool];
    return this.chosen;
  }

  update(): void {
    this.chosen?.update();
  }

  /** The room's marks; places are shown by the panel. */
  show(marks: readonly Mark[]): void {
    const drawn = marks.filter(({ kind }) => [MarkKind.NOTE, MarkKind.SKETCH, MarkKind.DISTANCE].includes(kind));
    this.scene.show(drawn);
    this.list.show(drawn, (mark) => this.events.mayRemove(mark));
    this.parts.stage.touch();
  }

  toggleList(): boolean {
    this.list.root.hidden = !this.list.root.hidden;
    return !this.list.root.hidden;
  }

  private room(): ToolRoom {
    const { stage, pick } = this.parts;
    const { events } = this;
    return {
      pick: (x, y) => pick.at(x, y),
      pickMany: () => {
        const at = pick.many();
        return (x, y) => at(x, y)?.lerp(stage.camera.position, towardsEye);
      },
      get viewStamp() {
        return [...stage.camera.position, ...stage.camera.quaternion].join();
      },
      get color() {
        return events.color();
      },
      show: (drafts) => this.setDrafts(drafts),
      say: (sentence) => events.say({ sentence }),
    };
  }

  private setDrafts(drafts: readonly Drawn[]): void {
    this.scene.setDrafts(drafts);
    this.parts.stage.touch();
  }

  private setShown(shown: boolean): void {
    this.scene.setShown(shown);
    this.parts.stage.touch();
  }

  private askFor(point: Vector3): void {
    this.form.ask((text) => {
      const isLeft = this.leave([{ kind: MarkKind.NOTE, points: point.toArray(), text }]);
      return isLeft ? '' : texts.notConnected;
    });
  }

  private closed(): void {
    this.setDrafts([]);
    this.parts.stage.canvas.focus({ preventScroll: true });
  }

  private leaveSketches(sketches: number[][]): void {
    this.leave(sketches.map((points) => ({ kind: MarkKind.SKETCH, points, text: '' })));
  }

  private measured(from: Vector3, to: Vector3): void {
    const sentence = texts.measured(inMetres(from.distanceTo(to)));
    const points = [...from.toArray(), ...to.toArray()];
    const run = () => {
      if (this.leave([{ kind: MarkKind.DISTANCE, points, text: '' }])) this.setDrafts([]);
    };
    const action = { label: texts.leaveIt, run };
    this.events.say(this.events.mayLeave() ? { sentence, action } : { sentence });
  }

  private leave(marks: NewMark[]): boolean {
    const isLeft = marks.every((mark) => this.events.leave(mark));
    if (!isLeft) this.events.say({ sentence: texts.notConnected });
    return isLeft;
  }
}
