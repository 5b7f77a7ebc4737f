// SPDX-License-Identifier: Apache-2.0
// Mouse, touch and keyboard on the canvas -> changes of the view.
//   mouse: left drag orbits, right or middle drag (or with Shift) pans, Ctrl drag turns the head, wheel zooms
//   touch: one finger turns the head, two fingers pan and zoom
//   keys: WASD and arrows walk, Q and E down and up, Shift faster, R back to the start
import { dolly, look, orbit, pan, walk, type ViewState } from './view_state';

const orbitPerPixel = 0.006;
const lookPerPixel = 0.004;
const zoomPerWheelPixel = 0.0012;
const walkSpeed_mPerS = 1.4;
const runFactor = 2.5;
const longestFrame_s = 0.1;

interface Finger {
  x: number;
  y: number;
}

/** Direction of each walking key: forward, right, up. */
const walkingKeys: Record<string, readonly [number, number, number]> = {
  KeyW: [1, 0, 0],
  ArrowUp: [1, 0, 0],
  KeyS: [-1, 0, 0],
  ArrowDown: [-1, 0, 0],
  KeyA: [0, -1, 0],
  ArrowLeft: [0, -1, 0],
  KeyD: [0, 1, 0],
  ArrowRight: [0, 1, 0],
  KeyE: [0, 0, 1],
  KeyQ: [0, 0, -1],
};

export interface NavigationEvents {
  changed(view: ViewState): void;
  reset(): void;
}

export class Navigation {
  private readonly fingers = new Map<number, Finger>();
  private readonly held = new Set<string>();
  private running = false;
  private lastUpdate_ms: number | undefined;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private view: ViewState,
    private readonly events: NavigationEvents,
  ) {
    canvas.addEventListener('pointerdown', (event) => this.down(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', (event) => this.fingers.delete(event.pointerId));
    canvas.addEventListener('pointercancel', (event) => this.fingers.delete(event.pointerId));
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    window.addEventListener('keydown', (event) => this.keyDown(event));
    window.addEventListener('keyup', (event) => this.keyUp(event));
    window.addEventListener('blur', () => this.held.clear());
  }

  get current(): ViewState {
    return this.view;
  }

  set(view: ViewState): void {
    this.view = view;
    this.events.changed(view);
  }

  /** Continues walking while keys are pressed; call once per screen refresh. */
  update(now_ms: number): void {
    const seconds = Math.min(longestFrame_s, (now_ms - (this.lastUpdate_ms ?? now_ms)) / 1000);
    this.lastUpdate_ms = now_ms;
    if (this.held.size === 0 || seconds === 0) return;
    const sum = [0, 0, 0];
    for (const key of this.held) walkingKeys[key]!.forEach((amount, axis) => (sum[axis]! += amount));
    const step = seconds * walkSpeed_mPerS * (this.running ? runFactor : 1);
    const [forward, right, up] = sum as [number, number, number];
    if (forward || right || up) this.set(walk(this.view, forward * step, right * step, up * step));
  }

  private down(event: PointerEvent): void {
    this.canvas.setPointerCapture(event.pointerId);
    this.canvas.focus({ preventScroll: true });
    this.fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  }

  private move(event: PointerEvent): void {
    const finger = this.fingers.get(event.pointerId);
    if (!finger) return;
    const before = { ...finger };
    finger.x = event.clientX;
    finger.y = event.clientY;
    const dx = finger.x - before.x;
    const dy = finger.y - before.y;
    if (event.pointerType !== 'mouse') this.touch(event.pointerId, before, dx, dy);
    else if (event.buttons & 6 || event.shiftKey) this.panBy(dx, dy);
    else if (event.ctrlKey) this.set(look(this.view, dx * lookPerPixel, dy * lookPerPixel));
    else this.set(orbit(this.view, -dx * orbitPerPixel, -dy * orbitPerPixel));
  }

  private touch(id: number, before: Finger, dx: number, dy: number): void {
    if (this.fingers.size === 1) return this.set(look(this.view, dx * lookPerPixel, dy * lookPerPixel));
    const other = [...this.fingers].find(([otherId]) => otherId !== id)![1];
    const now = this.fingers.get(id)!;
    const spread = (finger: Finger) => Math.max(20, Math.hypot(finger.x - other.x, finger.y - other.y));
    this.panBy(dx / 2, dy / 2);
    this.set(dolly(this.view, spread(before) / spread(now)));
  }

  /** The point at the pivot follows the finger. */
  private panBy(dx: number, dy: number): void {
    const metresPerPixel = (2 * this.view.distance * Math.tan(Math.PI / 6)) / this.canvas.clientHeight;
    this.set(pan(this.view, -dx * metresPerPixel, dy * metresPerPixel));
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 * event.deltaY : event.deltaY;
    this.set(dolly(this.view, Math.exp(Math.min(300, Math.max(-300, pixels)) * zoomPerWheelPixel)));
  }

  private keyDown(event: KeyboardEvent): void {
    if (isTyping(event) || event.ctrlKey || event.metaKey || event.altKey) return;
    this.running = event.shiftKey;
    if (event.code === 'KeyR') return this.events.reset();
    if (!(event.code in walkingKeys)) return;
    event.preventDefault();
    this.held.add(event.code);
  }

  private keyUp(event: KeyboardEvent): void {
    this.running = event.shiftKey;
    this.held.delete(event.code);
  }
}

/** True for keys that operate a focused control of the panel: text in a field, arrows in a choice. They do not walk. */
function isTyping({ target, code }: KeyboardEvent): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.closest('[role=radiogroup]')) return code.startsWith('Arrow');
  return target.closest('input:not([type=checkbox]), select, textarea') !== null;
}
