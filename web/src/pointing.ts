// SPDX-License-Identifier: Apache-2.0
// The laser pointer of this page's viewer: from beside the head to the surface under the mouse or the finger, for as long
// as one presses and holds there, or holds the key L. The others see it with one's name and colour (docs/spec/wire.md,
// ViewerPose).
import { Vector3 } from 'three';
import type { PlainBeam } from './stream/protocol';
import type { CanvasHand } from './view/canvas_hand';
import { disposeTree } from './view/dispose_tree';
import { beamOf, shine } from './view/pointer_beam';
import type { Stage } from './view/stage';
import type { SurfacePick } from './view/surface_pick';

const fromHead_m = new Vector3(0.18, -0.22, -0.1); // as in viewer/desktop_state.cpp
const farthest_m = 8;
const interval_ms = 50; // poses are sent no more often
const restPerPick = 3; // a slow machine spends no more than a quarter of its time on this

export class Pointing implements CanvasHand {
  private pixel: { x: number; y: number } | undefined;
  private beam: PlainBeam | undefined;
  private drawn: ReturnType<typeof beamOf> | undefined;
  private next_ms = 0;
  private hover: { x: number; y: number } | undefined; // the mouse on the canvas
  private byKey = false;

  /** `color` is this viewer's own, as the others see it; `changed` is called when `current` has. */
  constructor(
    private readonly stage: Stage,
    private readonly pick: SurfacePick,
    private readonly color: () => number,
    private readonly changed: () => void,
  ) {
    const { canvas } = stage;
    canvas.addEventListener('pointermove', (event) => this.hovered(event));
    canvas.addEventListener('pointerleave', () => (this.hover = undefined));
    window.addEventListener('keydown', (event) => this.keyDown(event));
    window.addEventListener('keyup', (event) => event.code === 'KeyL' && this.byKey && this.release());
    window.addEventListener('blur', () => this.release());
  }

  get current(): PlainBeam | undefined {
    return this.beam;
  }

  press(x: number, y: number): void {
    this.pixel = { x, y };
    this.next_ms = 0;
  }

  drag(x: number, y: number): void {
    this.pixel = { x, y };
  }

  release(): void {
    this.pixel = undefined;
    this.byKey = false;
    if (!this.beam) return;
    this.beam = undefined;
    this.show();
  }

  cancel(): void {
    this.release();
  }

  /** Call once per screen refresh: what is under the pointer changes while the room does. */
  update(now_ms: number): void {
    if (!this.pixel || now_ms < this.next_ms) return;
    const began_ms = performance.now();
    const { camera } = this.stage;
    const to = this.pick.orAhead(this.pixel.x, this.pixel.y, farthest_m);
    const from = fromHead_m.clone().applyQuaternion(camera.quaternion).add(camera.position);
    this.beam = { from: { x: from.x, y: from.y, z: from.z }, to: { x: to.x, y: to.y, z: to.z } };
    this.next_ms = now_ms + Math.max(interval_ms, restPerPick * (performance.now() - began_ms));
    this.show();
  }

  private show(): void {
    const { scene } = this.stage.room;
    if (this.drawn && !this.beam) {
      scene.remove(this.drawn);
      disposeTree(this.drawn);
      this.drawn = undefined;
    } else if (this.beam) {
      if (!this.drawn) scene.add((this.drawn = beamOf(this.color())));
      shine(this.drawn, this.beam);
    }
    this.stage.touch();
    this.changed();
  }

  private hovered({ pointerType, clientX, clientY }: PointerEvent): void {
    if (pointerType !== 'mouse') return;
    const { left, top } = this.stage.canvas.getBoundingClientRect();
    this.hover = { x: Math.floor(clientX - left), y: Math.floor(clientY - top) };
    if (this.byKey) this.pixel = this.hover;
  }

  private keyDown(event: KeyboardEvent): void {
    if (event.code !== 'KeyL' || event.repeat || event.ctrlKey || event.metaKey || event.altKey) return;
    // With the console open, L may push a sensor.
    if (!(event.target instanceof Element) || !event.target.matches('body, canvas')) return;
    if (document.body.classList.contains('console-open')) return;
    this.byKey = true;
    const { clientWidth, clientHeight } = this.stage.canvas;
    const { x, y } = this.hover ?? { x: Math.floor(clientWidth / 2), y: Math.floor(clientHeight / 2) };
    this.press(x, y);
  }
}
