// SPDX-License-Identifier: Apache-2.0
// The console's sensors tab: for each sensor its picture, its traffic over time, and the accuracy of its clock.
import { AskingButton } from '../panel/asking_button';
import { element, setText } from '../panel/element';
import { KeyedList, type Row } from '../panel/keyed_list';
import { placementTag } from '../panel/placement_tag';
import type { RoomSensor } from '../room_roster';
import type { RoomState } from '../room_state';
import type { ViewFrame } from '../stream/protocol';
import { consoleTexts as texts } from '../console_texts';
import { sensorColor } from '../view/sensor_color';
import { Chart } from './chart';
import type { HubSensor } from './hub_api';
import { sendingText } from './sending';
import { SensorSettingsForm, type AskSensor } from './sensor_settings';
import { interferenceText } from './interference';
import { Thumbnail } from './thumbnail';

/** For admins. */
export interface SensorEvents {
  /** Removes a sensor that has left. */
  forget(sensor: string): void;
  /** Its microphone, for all; or ends that. */
  mute(sensor: string, muted: boolean): void;
  /** Its settings. */
  change(sensor: string, wanted: Parameters<AskSensor>[0]): Promise<void>;
}

class SensorCard implements Row<RoomSensor> {
  readonly root = element('article', { class: 'card' });
  private readonly thumbnail: Thumbnail;
  private readonly seen = element('div', { class: 'seen' });
  private readonly clock = element('p', { class: 'note' });
  private readonly interference = element('p', { class: 'note interference' });
  private readonly tag = element('span');
  private readonly settings: SensorSettingsForm;
  private readonly wayOut: HTMLElement;
  private readonly mute = element('button', { type: 'button', class: 'plain mute', 'aria-pressed': 'false' }, texts.people.mute);
  private readonly charts = {
    fps: new Chart({ label: texts.charts.fps, unit: 'fps', least: 10, digits: 1 }),
    rate: new Chart({ label: texts.charts.rate, unit: 'MB/s', least: 0.5, digits: 2 }),
    latency: new Chart({ label: texts.charts.latency, unit: 'ms', least: 100, digits: 0 }),
    leftOut: new Chart({ label: texts.charts.leftOut, unit: '/s', least: 5, digits: 1 }),
  };
  private clockError_ms: number | undefined;
  private leftOutBefore: number | undefined;

  constructor(
    public entry: RoomSensor,
    events: SensorEvents,
  ) {
    this.mute.setAttribute('aria-label', `${texts.people.mute}: ${entry.name}`);
    this.mute.hidden = true;
    this.mute.addEventListener('click', () => events.mute(entry.name, this.mute.getAttribute('aria-pressed') !== 'true'));
    const asked = { label: texts.forget, question: texts.reallyForget, of: entry.name };
    this.wayOut = new AskingButton(asked, () => events.forget(entry.name)).root;
    this.settings = new SensorSettingsForm(entry.name, (wanted) => events.change(entry.name, wanted));
    this.wayOut.hidden = true;
    this.thumbnail = new Thumbnail(entry.name, (large) => this.seen.classList.toggle('large', large));
    const swatch = element('span', { class: 'swatch', 'aria-hidden': 'true' });
    swatch.style.background = sensorColor(entry.id);
    const charts = Object.values(this.charts).map((chart) => chart.root);
    this.seen.append(this.thumbnail.root, element('div', { class: 'charts' }, ...charts));
    this.root.append(
      element('h3', {}, swatch, entry.name, this.tag),
      this.seen,
      this.clock,
      this.interference,
      this.mute,
      this.settings.root,
      this.wayOut,
    );
  }

  update(entry: RoomSensor): void {
    this.entry = entry;
  }

  offer(frame: ViewFrame, now_ms: number): void {
    this.clockError_ms = frame.captureError_ms;
    this.thumbnail.offer(frame, now_ms);
  }

  /** Called once a second. `hub` is the data that the hub reports to admins. */
  sample(state: RoomState, hub: HubSensor | undefined): void {
    const { entry } = this;
    const traffic = state.status?.sensors.find(({ sensor }) => sensor === entry.id);
    const live = entry.online && traffic !== undefined;
    const room_ms = state.roomTime_ms();
    const captured_ms = traffic?.lastCapture_ms;
    const age_ms = room_ms === undefined || captured_ms === undefined ? undefined : Math.max(0, room_ms - captured_ms);
    const leftOut = traffic && traffic.skipped + traffic.missed;
    const newlyLeftOut =
      leftOut === undefined || this.leftOutBefore === undefined ? undefined : leftOut - this.leftOutBefore;
    this.leftOutBefore = leftOut;
    this.charts.fps.add(live ? state.sensorFps(entry.id) : undefined);
    this.charts.rate.add(live ? state.sensorBytesPerSecond(entry.id) / 1e6 : undefined);
    this.charts.latency.add(live ? (hub?.delay_ms ?? age_ms) : undefined);
    this.charts.leftOut.add(live ? newlyLeftOut : undefined);
    const error_ms = hub?.clock_error_ms ?? this.clockError_ms;
    const clock = error_ms === undefined ? texts.clockUnknown : texts.clock(error_ms);
    setText(this.clock, entry.online ? [clock, hub?.address, hub && sendingText(hub)].filter(Boolean).join(' · ') : texts.gone);
    const disturbed = entry.online ? hub?.interference : undefined;
    setText(this.interference, disturbed ? interferenceText(disturbed) : '');
    this.interference.classList.toggle('warning', Boolean(disturbed?.advice));
    this.root.classList.toggle('gone', !entry.online);
    this.wayOut.hidden = entry.online || hub === undefined;
    this.mute.hidden = !hub?.has_microphone && !hub?.muted;
    this.mute.setAttribute('aria-pressed', String(hub?.muted ?? false));
    this.settings.show(entry.online ? hub?.settings : undefined);
    this.tag.replaceChildren(...[placementTag(entry.pose)].filter((tag) => tag !== undefined));
  }
}

export class SensorCards {
  readonly root = element('div', { class: 'cards' });
  private readonly list: KeyedList<RoomSensor, SensorCard>;

  constructor(events: SensorEvents) {
    const none = element('p', { class: 'empty' }, texts.noSensors);
    const make = (entry: RoomSensor) => new SensorCard(entry, events);
    this.list = new KeyedList(this.root, ({ id, name }) => `${id} ${name}`, make, none);
  }

  offer(frames: readonly ViewFrame[], now_ms: number): void {
    for (const card of this.list.shown) {
      for (const frame of frames) if (frame.sensor === card.entry.id) card.offer(frame, now_ms);
    }
  }

  sample(entries: readonly RoomSensor[], state: RoomState, hubSensors: readonly HubSensor[]): void {
    this.list.show(entries);
    for (const card of this.list.shown) card.sample(state, hubSensors.find(({ id }) => id === card.entry.id));
  }
}
