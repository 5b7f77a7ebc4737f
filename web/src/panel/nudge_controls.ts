// SPDX-License-Identifier: Apache-2.0
// Places a sensor by hand, for users with an admin's token: buttons, and keys while these are on the screen and they or
// the room have the focus. The pushed pose is shown on this page only. `try` sends it to the aligner, which refines or
// rejects it.
import { nudgeTexts as texts } from '../console_texts';
import type { HandStep } from '../view/nudge';
import { element, setText } from './element';

/** What became of a pose that was to be tried. */
export type Tried = 'sent' | 'notMoved' | 'notConnected';

export interface NudgeEvents {
  push(sensor: number, step: HandStep): void;
  /** Moves the sensor to the user's position and viewing direction. */
  putHere(sensor: number): void;
  tryIt(sensor: number): Tried;
  /** False if the sensor had not been moved. */
  putBack(sensor: number): boolean;
}

const step_m = 0.05;
const step_rad = (2 * Math.PI) / 180;
const fineFactor = 0.2; // with Shift
const patience_ms = 20_000; // an aligner answers within some seconds

interface Step {
  key: string;
  label: string;
  title: string;
  push: Partial<HandStep>; // in steps
}

const steps: readonly Step[] = [
  { key: 'KeyY', label: '⤴', title: texts.steps.tiltUp, push: { tilt: 1 } },
  { key: 'KeyU', label: '↺', title: texts.steps.left, push: { turn: 1 } },
  { key: 'KeyI', label: '↑', title: texts.steps.away, push: { forward: 1 } },
  { key: 'KeyO', label: '↻', title: texts.steps.right, push: { turn: -1 } },
  { key: 'KeyP', label: '⤒', title: texts.steps.up, push: { up: 1 } },
  { key: 'KeyH', label: '⤵', title: texts.steps.tiltDown, push: { tilt: -1 } },
  { key: 'KeyJ', label: '←', title: texts.steps.toLeft, push: { right: -1 } },
  { key: 'KeyK', label: '↓', title: texts.steps.towards, push: { forward: -1 } },
  { key: 'KeyL', label: '→', title: texts.steps.toRight, push: { right: 1 } },
  { key: 'Semicolon', label: '⤓', title: texts.steps.down, push: { up: -1 } },
];

export class NudgeControls {
  readonly root = element('div', { class: 'nudge', hidden: '' });
  private readonly said = element('p', { role: 'status' });
  private sensor: number | undefined;
  private waits: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly events: NudgeEvents) {
    const pad = element('div', { class: 'pad' }, ...steps.map((step) => this.button(step)));
    const tryIt = element('button', { type: 'button', class: 'plain' }, texts.tryIt);
    tryIt.addEventListener('click', () => this.tryIt());
    const back = element('button', { type: 'button', class: 'plain' }, texts.putBack);
    back.addEventListener('click', () => this.putBack());
    const hint = element('p', {}, texts.hint);
    const here = element('button', { type: 'button', class: 'plain' }, texts.putHere);
    here.addEventListener('click', () => this.putHere());
    this.root.append(pad, hint, element('div', { class: 'row' }, here, tryIt, back), this.said);
    this.root.addEventListener('keydown', (event) => this.keyDown(event));
    window.addEventListener('keydown', (event) => isInRoom(event) && this.keyDown(event));
  }

  /** The sensor that is being moved, if any. */
  get moving(): number | undefined {
    return this.sensor;
  }

  choose(sensor: number | undefined): void {
    this.sensor = sensor;
    this.root.hidden = sensor === undefined;
    this.say('');
  }

  focus(): void {
    this.root.querySelector('button')?.focus();
  }

  /** The sensor's pose or the aligner's words on it have changed. */
  answered(): void {
    this.say('');
  }

  private say(sentence: string): void {
    clearTimeout(this.waits);
    setText(this.said, sentence);
  }

  private button(step: Step): HTMLElement {
    const button = element('button', { type: 'button', title: step.title, 'aria-label': step.title }, step.label);
    button.addEventListener('click', (event) => this.push(step, event.shiftKey));
    return button;
  }

  private push({ push: { right = 0, up = 0, forward = 0, turn = 0, tilt = 0 } }: Step, fine: boolean): void {
    if (this.sensor === undefined) return;
    const by = fine ? fineFactor : 1;
    const [metres, radians] = [by * step_m, by * step_rad];
    this.events.push(this.sensor, {
      right: right * metres,
      up: up * metres,
      forward: forward * metres,
      turn: turn * radians,
      tilt: tilt * radians,
    });
  }

  private putHere(): void {
    if (this.sensor !== undefined) this.events.putHere(this.sensor);
  }

  private tryIt(): void {
    if (this.sensor === undefined) return;
    const tried = this.events.tryIt(this.sensor);
    this.say(texts.tried[tried]);
    if (tried === 'sent') this.waits = setTimeout(() => this.say(texts.noAnswer), patience_ms);
  }

  private putBack(): boolean {
    this.say('');
    return this.sensor !== undefined && this.events.putBack(this.sensor);
  }

  private keyDown(event: KeyboardEvent): void {
    if (!this.root.checkVisibility() || event.ctrlKey || event.metaKey || event.altKey) return;
    const step = steps.find(({ key }) => key === event.code);
    if (step) this.push(step, event.shiftKey);
    else if (event.code === 'Enter' && !(event.target instanceof HTMLButtonElement)) this.tryIt();
    else if (event.code !== 'Escape' || !this.putBack()) return;
    event.preventDefault();
  }
}

function isInRoom({ target }: KeyboardEvent): boolean {
  return target instanceof Element && target.matches('body, canvas');
}
