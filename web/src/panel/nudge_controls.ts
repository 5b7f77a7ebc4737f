// SPDX-License-Identifier: Apache-2.0
// Putting a sensor in its place by hand, for whoever opened the page with an admin's token: buttons, and keys while a sensor
// is being moved. What it is pushed to is shown here only; `try` asks the aligner, which refines the guess or refuses it.
import { nudgeTexts as texts } from '../texts';
import { element } from './element';

export interface NudgeEvents {
  /** Metres and radians as the person sees them. */
  push(sensor: number, right: number, up: number, forward: number, turn: number): void;
  tryIt(sensor: number): void;
  putBack(sensor: number): void;
}

const step_m = 0.05;
const step_rad = (2 * Math.PI) / 180;
const fineFactor = 0.2; // with Shift

interface Step {
  key: string;
  label: string;
  title: string;
  push: readonly [right: number, up: number, forward: number, turn: number];
}

const steps: readonly Step[] = [
  { key: 'KeyU', label: '↺', title: texts.steps.left, push: [0, 0, 0, 1] },
  { key: 'KeyI', label: '↑', title: texts.steps.away, push: [0, 0, 1, 0] },
  { key: 'KeyO', label: '↻', title: texts.steps.right, push: [0, 0, 0, -1] },
  { key: 'KeyP', label: '⤒', title: texts.steps.up, push: [0, 1, 0, 0] },
  { key: 'KeyJ', label: '←', title: texts.steps.toLeft, push: [-1, 0, 0, 0] },
  { key: 'KeyK', label: '↓', title: texts.steps.towards, push: [0, 0, -1, 0] },
  { key: 'KeyL', label: '→', title: texts.steps.toRight, push: [1, 0, 0, 0] },
  { key: 'Semicolon', label: '⤓', title: texts.steps.down, push: [0, -1, 0, 0] },
];

export class NudgeControls {
  readonly root = element('div', { class: 'nudge', hidden: '' });
  private sensor: number | undefined;

  constructor(private readonly events: NudgeEvents) {
    const pad = element('div', { class: 'pad' }, ...steps.map((step) => this.button(step)));
    const tryIt = element('button', { type: 'button', class: 'plain' }, texts.tryIt);
    tryIt.addEventListener('click', () => this.tryIt());
    const back = element('button', { type: 'button', class: 'plain' }, texts.putBack);
    back.addEventListener('click', () => this.putBack());
    const hint = element('p', {}, texts.hint);
    this.root.append(pad, hint, element('div', { class: 'row' }, tryIt, back));
    window.addEventListener('keydown', (event) => this.keyDown(event));
  }

  /** The sensor that is being moved, if any. */
  get moving(): number | undefined {
    return this.sensor;
  }

  choose(sensor: number | undefined): void {
    this.sensor = sensor;
    this.root.hidden = sensor === undefined;
  }

  private button(step: Step): HTMLElement {
    const button = element('button', { type: 'button', title: step.title, 'aria-label': step.title }, step.label);
    button.addEventListener('click', (event) => this.push(step, event.shiftKey));
    return button;
  }

  private push({ push: [right, up, forward, turn] }: Step, fine: boolean): void {
    if (this.sensor === undefined) return;
    const by = fine ? fineFactor : 1;
    const metres = by * step_m;
    this.events.push(this.sensor, right * metres, up * metres, forward * metres, turn * by * step_rad);
  }

  private tryIt(): void {
    if (this.sensor !== undefined) this.events.tryIt(this.sensor);
  }

  private putBack(): void {
    if (this.sensor !== undefined) this.events.putBack(this.sensor);
  }

  private keyDown(event: KeyboardEvent): void {
    if (this.sensor === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.target instanceof HTMLInputElement && event.target.type === 'text') return;
    const step = steps.find(({ key }) => key === event.code);
    if (step) this.push(step, event.shiftKey);
    else if (event.code === 'Enter' && !(event.target instanceof HTMLButtonElement)) this.tryIt();
    else if (event.code === 'Escape') this.putBack();
    else return;
    event.preventDefault();
  }
}
