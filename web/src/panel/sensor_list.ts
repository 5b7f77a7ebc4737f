// SPDX-License-Identifier: Apache-2.0
// The sensors in the panel: one row each, with a switch, its traffic, the age of its newest frame, and, where it has a
// microphone that is heard, its volume.
import type { RoomSensor } from '../room_roster';
import type { RoomState } from '../room_state';
import { panelTexts, voiceTexts } from '../texts';
import { sensorColor } from '../view/sensor_color';
import { speakerOf } from '../voice/sensor_speaker';
import { element, setText } from './element';
import { megabytes, milliseconds, perSecond } from './format';
import { KeyedList, type Row } from './keyed_list';
import type { VolumeSlider } from './people_list';
import { placementTag } from './placement_tag';

interface SensorRow extends Row<RoomSensor> {
  entry: RoomSensor;
  figures: HTMLElement;
  tag: HTMLElement;
  coarse: HTMLElement; // shown while its pictures are of its small rendition
  slider: HTMLElement | undefined; // its volume, once it was heard
}

export class SensorList {
  readonly root = element('ul', { class: 'sensors' });
  private readonly switchedOff = new Set<string>(); // names: after a restart the hub may number sensors differently
  private readonly list: KeyedList<RoomSensor, SensorRow>;

  constructor(
    private readonly state: RoomState,
    private readonly switched: (sensor: string, visible: boolean) => void,
    private readonly volumeSlider: VolumeSlider,
  ) {
    const none = element('li', { class: 'none' }, panelTexts.noSensors);
    this.list = new KeyedList(this.root, ({ id, name }) => `${id} ${name}`, (entry) => this.row(entry), none);
  }

  rebuild(): void {
    const entries = [...(this.state.roster?.sensors ?? [])].sort((a, b) =>
      a.name.localeCompare(b.name, 'en', { numeric: true }),
    );
    this.list.show(entries);
  }

  refresh(): void {
    const room_ms = this.state.roomTime_ms();
    for (const row of this.list.shown) this.refreshRow(row, room_ms);
  }

  private refreshRow(row: SensorRow, room_ms: number | undefined): void {
    this.refreshVoice(row);
    const { entry, figures } = row;
    const traffic = this.state.status?.sensors.find((counts) => counts.sensor === entry.id);
    const captured = traffic?.lastCapture_ms;
    const age = room_ms === undefined || captured === undefined ? undefined : Math.max(0, room_ms - captured);
    const fps = perSecond(this.state.sensorFps(entry.id));
    const rate = megabytes(this.state.sensorBytesPerSecond(entry.id));
    row.coarse.hidden = !entry.online || !(traffic?.isSmall || traffic?.isHeldBack);
    setText(figures, entry.online ? `${fps} fps · ${rate} MB/s · ${milliseconds(age)}` : panelTexts.gone);
  }

  private refreshVoice(row: SensorRow): void {
    const { entry, root, tag, figures } = row;
    const speaker = speakerOf(entry.id);
    const speaks = this.state.speaking.has(speaker);
    setText(tag, this.state.muted.has(speaker) ? voiceTexts.isMuted : speaks ? voiceTexts.isHeard : '');
    if (!speaks || row.slider) return;
    row.slider = this.volumeSlider(speaker, entry.name);
    if (row.slider) root.insertBefore(row.slider, figures);
  }

  private row(entry: RoomSensor): SensorRow {
    const box = element('input', { type: 'checkbox', 'aria-label': panelTexts.showSensor(entry.name) });
    box.checked = !this.switchedOff.has(entry.name);
    box.addEventListener('change', () => {
      if (box.checked) this.switchedOff.delete(entry.name);
      else this.switchedOff.add(entry.name);
      this.switched(entry.name, box.checked);
    });
    const swatch = element('span', { class: 'swatch', 'aria-hidden': 'true' });
    swatch.style.background = sensorColor(entry.id);
    const name = element('span', { class: 'name' });
    const figures = element('span', { class: 'rates' });
    const tag = element('span', { class: 'voice-tag' });
    const coarse = element('span', { class: 'tag', title: panelTexts.coarseTitle }, panelTexts.coarse);
    const root = element('li', {}, element('label', {}, box, swatch, name, coarse), tag, figures);
    const update = (now: RoomSensor) => {
      row.entry = now;
      root.className = now.online ? '' : 'gone';
      name.replaceChildren(...[now.name, placementTag(now.pose)].filter((part) => part !== undefined));
    };
    const row: SensorRow = { root, update, entry, figures, tag, coarse, slider: undefined };
    return row;
  }
}
