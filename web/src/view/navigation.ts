// SPDX-License-Identifier: Apache-2.0
// Mouse, touch and keyboard on the canvas -> changes of the view.
//   mouse: left drag orbits, right or middle drag (or with Shift) pans, Ctrl drag turns the head, wheel zooms, a double
//     click goes there, a long press points
//   touch: one finger turns the head, two fingers pan and zoom, a double tap goes there, a long press points; the stick
//     (walk_stick) walks
//   keys: see motion_keys; Shift faster, R back to the start, G goes to what is in the middle
import type { CanvasHand } from './canvas_hand';
import { DoubleTap } from './double_tap';
import { Glide } from './going_there';
import { LongPress } from './long_press';
import { isMotionKey, movedByKeys, walkSpeed_mPerS } from './motion_keys';
import type { StickPush } from './stick_motion';
import { reachAround, withinReach, type Reach } from './view_limits';
import { dolly, look, orbit, pan, walk, type ViewState } from './view_state';

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
  /** The user moves the view: not another person, nor the page. */
  moved(): void;
  /** The user wants to go to what is at a pixel of the canvas. */
  goThere(x: number, y: number): void;
  reset(): void;
}

export class Navigation {
  /** What a press is given to: a long one `pointing`, every one the `tool`. */
  readonly hands: { pointing?: CanvasHand; tool?: CanvasHand | undefined } = {};
  private readonly fingers = new Map<number, Finger>();
  private readonly held = new Set<string>();
  private readonly taps = new DoubleTap();
  private readonly longPress = new LongPress();
  private taken: { id: number; hand: CanvasHand; x: number; y: number } | undefined; // a pointer that does not move the view
  private reach: Reach;
  private roomsReach: Reach | undefined; // undefined while the room's size is not known
  private glide: Glide | undefined;
  private push: StickPush = { forward: 0, right: 0 };
  private running = false;
  private lastUpdate_ms: number | undefined;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private view: ViewState,
    private readonly events: NavigationEvents,
  ) {
    this.reach = reachAround(view);
    canvas.addEventListener('pointerdown', (event) => this.down(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', (event) => this.up(event));
    canvas.addEventListener('pointercancel', (event) => this.forget(event));
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    window.addEventListener('keydown', (event) => this.keyDown(event));
    window.addEventListener('keyup', (event) => this.keyUp(event));
    window.addEventListener('blur', () => this.held.clear());
  }

  get current(): ViewState {
    return this.view;
  }

  /** It is on the way to a place. */
  get isGliding(): boolean {
    return this.glide !== undefined;
  }

  /** At once. */
  set(view: ViewState): void {
    this.glide = undefined;
    if (!this.roomsReach) this.reach = reachAround(view);
    this.show(view);
  }

  /** Smoothly, unless the user prefers less motion; as far as it is permitted. */
  glideTo(view: ViewState): void {
    const to = withinReach(view, this.reach);
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) return this.set(to);
    this.glide = new Glide(this.view, to);
  }

  /** The size of the room has become known, or has changed. */
  setReach(reach: Reach): void {
    this.reach = this.roomsReach = reach;
  }

  permitted(view: ViewState): ViewState {
    return withinReach(view, this.reach);
  }

  /** A press that came before the tool was chosen is the tool's: on a busy machine it overtakes the click on its button. */
  setTool(tool: CanvasHand | undefined): void {
    const { taken, hands } = this;
    const isHeld = taken !== undefined && taken.hand === hands.tool;
    hands.tool?.cancel();
    hands.tool = tool;
    if (isHeld && tool) this.give(taken.id, tool, taken);
  }

  /** Walks on until it is called with zeros. */
  pushStick(push: StickPush): void {
    this.push = push;
  }

  /** A step of the user's, as far as it is permitted. */
  private go(view: ViewState): void {
    this.glide = undefined;
    this.events.moved();
    this.show(this.permitted(view));
  }

  private show(view: ViewState): void {
    this.view = view;
    this.events.changed(view);
  }

  /** Continues moving while keys are pressed or the stick is pushed; call once per screen refresh. */
  update(now_ms: number): void {
    const seconds = Math.min(longestFrame_s, (now_ms - (this.lastUpdate_ms ?? now_ms)) / 1000);
    this.lastUpdate_ms = now_ms;
    if (this.glide) this.glideOn(this.glide, now_ms);
    const press = this.longPress.due(now_ms);
    if (press) this.give(press.id, this.hands.pointing, press);
    if (seconds === 0) return;
    const { forward, right } = this.push;
    const step_m = seconds * walkSpeed_mPerS;
    const walked = forward || right ? walk(this.view, forward * step_m, right * step_m, 0) : this.view;
    const moved = movedByKeys(walked, this.held, seconds, this.running);
    if (moved !== this.view) this.go(moved);
  }

  private glideOn(glide: Glide, now_ms: number): void {
    const { view, isOver } = glide.at(now_ms);
    if (isOver) this.glide = undefined;
    this.show(view);
  }

  private down(event: PointerEvent): void {
    this.canvas.setPointerCapture(event.pointerId);
    this.canvas.focus({ preventScroll: true });
    this.fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    if (this.fingers.size > 1 || event.button !== 0) return this.cancelPress();
    const { pointerId: id } = event;
    if (this.hands.tool) return this.give(id, this.hands.tool, this.pixelOf(event));
    this.taps.down(event.clientX, event.clientY, event.timeStamp);
    if (!event.shiftKey && !event.ctrlKey) this.longPress.down({ id, ...this.pixelOf(event) }, event.timeStamp);
  }

  private up(event: PointerEvent): void {
    this.fingers.delete(event.pointerId);
    this.longPress.cancel();
    if (this.taken?.id === event.pointerId) return this.letGo();
    if (!this.taps.up(event.clientX, event.clientY, event.timeStamp)) return;
    const { x, y } = this.pixelOf(event);
    this.goThere(x, y);
  }

  private forget(event: PointerEvent): void {
    this.fingers.delete(event.pointerId);
    this.cancelPress();
  }

  private pixelOf(event: PointerEvent): { x: number; y: number } {
    const { left, top } = this.canvas.getBoundingClientRect();
    return { x: Math.floor(event.clientX - left), y: Math.floor(event.clientY - top) };
  }

  private give(id: number, hand: CanvasHand | undefined, { x, y }: { x: number; y: number }): void {
    if (!hand) return;
    this.taps.cancel();
    this.taken = { id, hand, x, y };
    hand.press(x, y);
  }

  private letGo(): void {
    this.taken?.hand.release();
    this.taken = undefined;
  }

  private cancelPress(): void {
    this.taps.cancel();
    this.longPress.cancel();
    this.taken?.hand.cancel();
    this.taken = undefined;
  }

  private goAhead(): void {
    this.goThere(this.canvas.clientWidth >> 1, this.canvas.clientHeight >> 1);
  }

  private goThere(x: number, y: number): void {
    this.events.moved();
    this.events.goThere(x, y);
  }

  private move(event: PointerEvent): void {
    const finger = this.fingers.get(event.pointerId);
    if (!finger) return;
    const { x, y } = this.pixelOf(event);
    if (this.taken?.id === event.pointerId) {
      Object.assign(this.taken, { x, y });
      return this.taken.hand.drag(x, y);
    }
    this.longPress.move({ id: event.pointerId, x, y });
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
    this.go(dolly(this.view, spread(before) / spread(now), this.reach.radius_m));
  }

  /** The point at the pivot follows the finger. */
  private panBy(dx: number, dy: number): void {
    const metresPerPixel = (2 * this.view.distance * Math.tan(Math.PI / 6)) / this.canvas.clientHeight;
    this.go(pan(this.view, -dx * metresPerPixel, dy * metresPerPixel));
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 * event.deltaY : event.deltaY;
    this.go(dolly(this.view, Math.exp(Math.min(300, Math.max(-300, pixels)) * zoomPerWheelPixel), this.reach.radius_m));
  }

  private keyDown(event: KeyboardEvent): void {
    if (!isForRoom(event) || event.ctrlKey || event.metaKey || event.altKey) return;
    this.running = event.shiftKey;
    if (event.code === 'KeyR') return this.events.reset();
    if (event.code === 'KeyG' && !event.repeat) return this.goAhead();
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
