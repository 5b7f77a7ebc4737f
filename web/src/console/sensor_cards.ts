// SPDX-License-Identifier: Apache-2.0
// The console's sensors tab: for each sensor its picture, its traffic over time, and the accuracy of its clock.
import { element, setText } from '../panel/element';
import { placementTag } from '../panel/placement_tag';
import type { RoomSensor } from '../room_roster';
import type { RoomState } from '../room_state';
import type { ViewFrame } from '../stream/protocol';
import { consoleTexts as texts } from '../texts';
import { sensorColor } from '../view/sensor_color';
import { Chart } from './chart';
import type { HubSensor } from './hub_api';
import { Thumbnail } from './thumbnail';

class SensorCard {
  readonly root = element('article', { class: 'card' });
  private readonly thumbnail: Thumbnail;
  private readonly clock = element('p', { class: 'note' });
  private readonly tag = element('span');
  private readonly wayOut: HTMLElement;
  private readonly charts = {
    fps: new Chart({ label: texts.charts.fps, unit: 'fps', least: 10, digits: 1 }),
    rate: new Chart({ label: texts.charts.rate, unit: 'MB/s', least: 0.5, digits: 2 }),
    latency: new Chart({ label: texts.charts.latency, unit: 'ms', least: 100, digits: 0 }),
    leftOut: new Chart({ label: texts.charts.leftOut, unit: '/s', least: 5, digits: 1 }),
  };
  private clockError_ms: number | undefined;
  private leftOutBefore: number | undefined;

  constructor(entry: RoomSensor, forget: (sensor: string) => void) {
    const label = `${texts.forget}: ${entry.name}`;
    this.wayOut = element('button', { type: 'button', class: 'plain', 'aria-label': label }, texts.forget);
    this.wayOut.addEventListener('click', () => forget(entry.name));
    this.wayOut.hidden = true;
    this.thumbnail = new Thumbnail(entry.name);
    const swatch = element('span', { class: 'swatch', 'aria-hidden': 'true' });
    swatch.style.background = sensorColor(entry.id);
    const charts = Object.values(this.charts).map((chart) => chart.root);
    this.root.append(
      element('h3', {}, swatch, entry.name, this.tag),
      element('div', { class: 'seen' }, this.thumbnail.root, element('div', { class: 'charts' }, ...charts)),
      this.clock,
      this.wayOut,
    );
  }

  offer(frame: ViewFrame, now_ms: number): void {
    this.clockError_ms = frame.captureError_ms;
    this.thumbnail.offer(frame, now_ms);
  }

  /** Called once a second. `hub` is the data that the hub reports to admins. */
  sample(entry: RoomSensor, state: RoomState, hub: HubSensor | undefined): void {
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
    setText(this.clock, entry.online ? [clock, hub?.address].filter(Boolean).join(' · ') : texts.gone);
    this.root.classList.toggle('gone', !entry.online);
    this.wayOut.hidden = entry.online || hub === undefined;
    this.tag.replaceChildren(...[placementTag(entry.pose)].filter((tag) => tag !== undefined));
  }
}

export class SensorCards {
  readonly root = element('div', { class: 'cards' });
  private readonly cards = new Map<number, { card: SensorCard; name: string }>();

  /** `forget` removes a sensor that has left; for admins. */
  constructor(private readonly forget: (sensor: string) => void) {}

  offer(frames: readonly ViewFrame[], now_ms: number): void {
    for (const frame of frames) this.cards.get(frame.sensor)?.card.offer(frame, now_ms);
  }

  sample(entries: readonly RoomSensor[], state: RoomState, hubSensors: readonly HubSensor[]): void {
    this.follow(entries);
    for (const entry of entries) {
      const hub = hubSensors.find(({ id }) => id === entry.id);
      this.cards.get(entry.id)!.card.sample(entry, state, hub);
    }
  }

  private follow(entries: readonly RoomSensor[]): void {
    const known = [...this.cards].map(([id, { name }]) => `${id} ${name}`).join();
    if (known === entries.map(({ id, name }) => `${id} ${name}`).join() && this.root.childElementCount > 0) return;
    const before = new Map(this.cards);
    this.cards.clear();
    for (const entry of entries) {
      const kept = before.get(entry.id);
      const stays = kept?.name === entry.name;
      this.cards.set(entry.id, stays ? kept : { card: new SensorCard(entry, this.forget), name: entry.name });
    }
    const roots = [...this.cards.values()].map(({ card }) => card.root);
    this.root.replaceChildren(...(roots.length > 0 ? roots : [element('p', { class: 'empty' }, texts.noSensors)]));
  }
}
