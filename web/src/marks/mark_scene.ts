// SPDX-License-Identifier: Apache-2.0
// Draws the room's marks, and those that this viewer is about to leave. World: metres.
import * as THREE from 'three';
import { MarkKind, type Mark } from '../gen/control_pb';
import { disposeTree } from '../view/dispose_tree';
import { pointsOf } from './points';
import { textLabel } from './text_label';
import { tube } from './tube';

const line_m = 0.006; // radius
const pin_m = 0.016;
const hidden = 0.3; // opacity of what a surface hides: depth is noisy, and a line on a wall must not vanish in it

/** What is drawn of a mark. */
export type Drawn = Pick<Mark, 'kind' | 'points' | 'text' | 'colorRgb'>;

export function inMetres(length_m: number): string {
  return `${length_m.toFixed(2)} m`;
}

function solid(geometry: THREE.BufferGeometry, color: number): THREE.Object3D {
  const seen = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ color }));
  const behind = new THREE.MeshBasicMaterial({ color, transparent: true, opacity: hidden, depthTest: false, depthWrite: false });
  const ghost = new THREE.Mesh(geometry, behind);
  [ghost.renderOrder, seen.renderOrder] = [1, 2];
  return new THREE.Group().add(ghost, seen);
}

function ball(at: THREE.Vector3, color: number): THREE.Object3D {
  const pin = solid(new THREE.SphereGeometry(pin_m, 16, 12), color);
  pin.position.copy(at);
  return pin;
}

function line(points: THREE.Vector3[], color: number): THREE.Object3D {
  return solid(tube(points, line_m), color);
}

function labelAt(at: THREE.Vector3, text: string, color: number): THREE.Sprite {
  const label = textLabel(text, color);
  label.position.copy(at);
  return label;
}

/** Nothing for places, which are in the panel, and for kinds of a later version. */
export function drawingOf(mark: Drawn): THREE.Object3D {
  const { kind, text, colorRgb: color } = mark;
  const drawing = new THREE.Group();
  const points = pointsOf(mark);
  const [first, last] = [points[0]!, points.at(-1)!];
  if (kind === MarkKind.NOTE) drawing.add(labelAt(first, text, color));
  if (kind === MarkKind.SKETCH) drawing.add(line(points, color));
  if (kind === MarkKind.DISTANCE) {
    drawing.add(ball(first, color), ball(last, color), line(points, color));
    drawing.add(labelAt(first.clone().lerp(last, 0.5), inMetres(first.distanceTo(last)), color));
  }
  return drawing;
}

export class MarkScene {
  readonly root = new THREE.Group();
  private readonly left = new THREE.Group();
  private readonly drawn = new Map<number, { mark: Mark; object: THREE.Object3D }>();
  private draft: THREE.Object3D[] = [];

  constructor() {
    this.root.add(this.left);
  }

  show(marks: readonly Mark[]): void {
    const present = new Map(marks.map((mark) => [mark.id, mark]));
    for (const [id, { mark, object }] of this.drawn) {
      if (present.get(id) === mark) continue;
      this.drawn.delete(id);
      this.discard(object);
    }
    for (const mark of marks) {
      if (this.drawn.has(mark.id)) continue;
      const object = drawingOf(mark);
      this.drawn.set(mark.id, { mark, object });
      this.left.add(object);
    }
  }

  /** What this viewer has not left yet; instead of what was drawn so before. */
  setDrafts(drafts: readonly Drawn[]): void {
    this.draft.forEach((object) => this.discard(object));
    this.draft = drafts.map(drawingOf);
    for (const object of this.draft) this.root.add(object);
  }

  /** Of marks that were left: on or off in this viewer's picture. */
  setShown(shown: boolean): void {
    this.left.visible = shown;
  }

  private discard(object: THREE.Object3D): void {
    object.removeFromParent();
    disposeTree(object);
  }
}
