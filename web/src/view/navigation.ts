// SPDX-License-Identifier: Apache-2.0
// Mouse, touch and keyboard on the canvas -> changes of the view.
//   mouse: left drag orbits, right or middle drag (or with Shift) pans, Ctrl drag turns the head, wheel zooms
//   touch: one finger turns the head, two fingers pan and zoom
//   keys: see motion_keys; Shift faster, R back to the start
import type { Vector3 } from 'three';
import { isMotionKey, movedByKeys } from './motion_keys';
import { withinReach } from './view_limits';
import { dolly, look, orbit, pan, pivot, type ViewState } from './view_state';

const orbitPerPixel = 0.006;
const lookPerPixel = 0.004;
const zoomPerWheelPixel = 0.0012;
const longestFrame_s = 0.1;
const tap_s = 0.05; // a key that is pressed and released between two pictures counts this long

interface Finger {
  x: number;
  y: number;
}

export interface NavigationEvents {
  changed(view: ViewState): void;
  reset(): void;
}

export class Navigation {
  private readonly fingers = new Map<number, Finger>();
  private readonly held = new Set<string>();
  private home: Vector3; // the pivot of the last view that was set from outside
  private running = false;
  private lastUpdate_ms: number | undefined;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private view: ViewState,
    private readonly events: NavigationEvents,
  ) {
    this.home = pivot(view);
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
    this.home = pivot(view);
    this.show(view);
  }

  /** A step of the user's, as far as it is permitted. */
  private go(view: ViewState): void {
    this.show(withinReach(view, this.home));
  }

  private show(view: ViewState): void {
    this.view = view;
    this.events.changed(view);
  }

  /** Continues moving while keys are pressed; call once per screen refresh. */
  update(now_ms: number): void {
    const seconds = Math.min(longestFrame_s, (now_ms - (this.lastUpdate_ms ?? now_ms)) / 1000);
    this.lastUpdate_ms = now_ms;
    if (this.held.size === 0 || seconds === 0) return;
    const moved = movedByKeys(this.view, this.held, seconds, this.running);
    if (moved !== this.view) this.go(moved);
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
    else if (event.ctrlKey) this.go(look(this.view, dx * lookPerPixel, dy * lookPerPixel));
    else this.go(orbit(this.view, -dx * orbitPerPixel, -dy * orbitPerPixel));
  }

  private touch(id: number, before: Finger, dx: number, dy: number): void {
    if (this.fingers.size === 1) return this.go(look(this.view, dx * lookPerPixel, dy * lookPerPixel));
    const other = [...this.fingers].find(([otherId]) => otherId !== id)![1];
    const now = this.fingers.get(id)!;
    const spread = (finger: Finger) => Math.max(20, Math.hypot(finger.x - other.x, finger.y - other.y));
    this.panBy(dx / 2, dy / 2);
    this.go(dolly(this.view, spread(before) / spread(now)));
  }

  /** The point at the pivot follows the finger. */
  private panBy(dx: number, dy: number): void {
    const metresPerPixel = (2 * this.view.distance * Math.tan(Math.PI / 6)) / this.canvas.clientHeight;
    this.go(pan(this.view, -dx * metresPerPixel, dy * metresPerPixel));
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 * event.deltaY : event.deltaY;
    this.go(dolly(this.view, Math.exp(Math.min(300, Math.max(-300, pixels)) * zoomPerWheelPixel)));
  }

  private keyDown(event: KeyboardEvent): void {
    if (!isForRoom(event) || event.ctrlKey || event.metaKey || event.altKey) return;
    this.running = event.shiftKey;
    if (event.code === 'KeyR') return this.events.reset();
    if (!isMotionKey(event.code)) return;
    event.preventDefault();
    if (!event.repeat) this.go(movedByKeys(this.view, [event.code], tap_s, this.running));
    this.held.add(event.code);
  }

  private keyUp(event: KeyboardEvent): void {
    this.running = event.shiftKey;
    this.held.delete(event.code);
  }
}

/** False for keys that operate a focused control: text in a field, arrows in a choice, a list or a scrolled panel. */
function isForRoom({ target, code }: KeyboardEvent): boolean {
  if (!(target instanceof HTMLElement) || target.matches('body, canvas')) return true;
  if (code.startsWith('Arrow')) return false;
  return target.closest('input:not([type=checkbox], [type=radio]), select, textarea') === null;
}
