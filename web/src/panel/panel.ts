// SPDX-License-Identifier: Apache-2.0
// The panel beside the room: connection, what is wrong, sensors, figures, people, how to draw. Rebuilt by parts when the
// roster changes; figures are refreshed a few times a second.
import type { RoomState } from '../room_state';
import type { DrawMode } from '../view/draw_mode';
import { element, setText } from './element';
import type { NudgeEvents } from './nudge_controls';
import { clockError, megabytes, milliseconds, perSecond } from './format';
import { HeadsetControls, type HeadsetControlEvents } from './headset_controls';
import './panel.css';
import { problems, type Problem } from './problems';
import { SensorList } from './sensor_list';
import { headsetTexts } from '../texts';

export interface PanelEvents {
  modeChosen(mode: DrawMode): void;
  sensorSwitched(sensor: number, visible: boolean): void;
  reset(): void;
  headset: HeadsetControlEvents;
  nudge: NudgeEvents | undefined; // undefined: this person may only look
}

interface Figure {
  root: HTMLElement;
  value: HTMLElement;
}

function figure(label: string, title: string): Figure {
  const value = element('dd', {}, '–');
  return { root: element('div', { class: 'figure', title }, element('dt', {}, label), value), value };
}

function section(title: string, ...content: Node[]): HTMLElement {
  return element('section', {}, element('h2', {}, title), ...content);
}

export class Panel {
  private readonly dot = element('span', { class: 'dot', 'aria-hidden': 'true' });
  private readonly title = element('h1', {}, 'roomcast');
  private readonly phase = element('p', { class: 'phase', role: 'status' });
  private readonly toggle = element('button', { type: 'button', class: 'toggle', 'aria-controls': 'panel-body' });
  private readonly body = element('div', { id: 'panel-body', class: 'body' });
  private readonly troubles = element('ul', {
    class: 'troubles',
    'aria-live': 'polite',
    'aria-label': 'What is wrong',
  });
  readonly headset: HeadsetControls;
  private readonly sensors: SensorList;
  private readonly people = element('ul', { class: 'people' });
  private readonly received = figure('MB/s', 'Received in all, 10⁶ bytes per second');
  private readonly shown = figure('fps', 'Frame sets shown per second');
  private readonly latency = figure(
    'latency',
    'From capture to screen, median of the last second, ± error of the clock',
  );
  private readonly modes = new Map<DrawMode, HTMLInputElement>();

  constructor(
    private readonly root: HTMLElement,
    private readonly state: RoomState,
    private readonly hubAddress: string,
    private readonly events: PanelEvents,
  ) {
    this.sensors = new SensorList(state, (sensor, visible) => events.sensorSwitched(sensor, visible), events.nudge);
    this.headset = new HeadsetControls(events.headset);
    this.toggle.addEventListener('click', () => this.setOpen(!this.open));
    const header = element(
      'header',
      {},
      this.dot,
      element('div', { class: 'names' }, this.title, this.phase),
      this.toggle,
    );
    const figures = element('dl', { class: 'figures' }, this.received.root, this.shown.root, this.latency.root);
    this.body.append(
      figures,
      section('Sensors', this.sensors.root),
      section('People', this.people),
      section('Drawn as', this.modeSwitch()),
      section(headsetTexts.title, this.headset.root),
      this.help(),
    );
    root.append(header, this.troubles, this.body);
    this.setOpen(true);
    this.refresh();
  }

  get open(): boolean {
    return !this.root.classList.contains('closed');
  }

  setOpen(open: boolean): void {
    this.root.classList.toggle('closed', !open);
    this.body.hidden = !open;
    this.toggle.setAttribute('aria-expanded', String(open));
    this.toggle.setAttribute('aria-label', open ? 'Close the panel' : 'Open the panel');
  }

  setMode(mode: DrawMode): void {
    this.modes.get(mode)!.checked = true;
  }

  /** The roster has changed. */
  rebuild(): void {
    this.sensors.rebuild();
    const self = this.state.welcome?.viewerId;
    const people = (this.state.roster?.viewers ?? []).map((viewer) => {
      const color = `#${viewer.colorRgb.toString(16).padStart(6, '0')}`;
      const name = viewer.name || `viewer ${viewer.id}`;
      const swatch = element('span', { class: 'swatch round', 'aria-hidden': 'true' });
      swatch.style.background = color;
      return element('li', {}, swatch, viewer.id === self ? `${name} (you)` : name);
    });
    this.people.replaceChildren(...people);
    this.refresh();
  }

  refresh(): void {
    const { state } = this;
    const { connection, status } = state;
    const live = connection.phase === 'joined' && !state.broken;
    setText(this.title, state.welcome?.room || 'roomcast');
    this.root.dataset.phase = state.broken ? 'broken' : connection.phase;
    setText(
      this.phase,
      state.broken
        ? 'stopped'
        : { joined: 'live', connecting: 'connecting', waiting: 'not connected' }[connection.phase],
    );
    setText(this.received.value, live ? megabytes(state.bytesPerSecond) : '–');
    setText(this.shown.value, live ? perSecond(state.shownFps) : '–');
    setText(
      this.latency.value,
      live ? `${milliseconds(state.latency_ms)} ${clockError(status?.clock?.error_ms)}`.trim() : '–',
    );
    this.sensors.refresh();
    this.showProblems(problems({ ...this.known(), hubAddress: this.hubAddress }, state.roomTime_ms(), Date.now()));
  }

  private known() {
    const { broken, connection, roster, status } = this.state;
    return { broken, connection, roster, status };
  }

  private showProblems(found: Problem[]): void {
    const key = JSON.stringify(found);
    if (this.troubles.dataset.key === key) return;
    this.troubles.dataset.key = key;
    this.troubles.replaceChildren(
      ...found.map(({ severity, sentence }) => element('li', { class: severity }, sentence)),
    );
  }

  private modeSwitch(): HTMLElement {
    const group = element('div', { class: 'modes', role: 'radiogroup', 'aria-label': 'Drawn as' });
    for (const [mode, label] of [
      ['blend', 'Blended'],
      ['mesh', 'Surfaces'],
      ['points', 'Points'],
    ] as const) {
      const input = element('input', { type: 'radio', name: 'mode', value: mode });
      input.addEventListener('change', () => this.events.modeChosen(mode));
      this.modes.set(mode, input);
      group.append(element('label', {}, input, element('span', {}, label)));
    }
    return group;
  }

  private help(): HTMLElement {
    const row = (keys: string, what: string) => element('div', {}, element('dt', {}, keys), element('dd', {}, what));
    const keys = element(
      'dl',
      { class: 'keys' },
      row('drag', 'turn around the middle'),
      row('right drag', 'shift'),
      row('wheel', 'nearer, farther'),
      row('W A S D, arrows', 'walk (Shift: faster)'),
      row('Q E', 'down, up'),
      row('R', 'back to the start'),
      row('1 finger', 'look around'),
      row('2 fingers', 'shift and zoom'),
    );
    const reset = element('button', { type: 'button', class: 'plain' }, 'Back to the start');
    reset.addEventListener('click', () => this.events.reset());
    return element('details', { class: 'help' }, element('summary', {}, 'Moving around'), keys, reset);
  }
}
