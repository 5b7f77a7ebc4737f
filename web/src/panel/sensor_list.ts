// SPDX-License-Identifier: Apache-2.0
// The sensors in the panel: one row each, with a switch, its traffic, and the age of its newest frame.
import type { RoomSensor } from '../room_roster';
import type { RoomState } from '../room_state';
import { panelTexts } from '../texts';
import { sensorColor } from '../view/sensor_color';
import { element, setText } from './element';
import { megabytes, milliseconds, perSecond } from './format';
import { placementTag } from './placement_tag';

interface Row {
  entry: RoomSensor;
  figures: HTMLElement;
}

export class SensorList {
  readonly root = element('ul', { class: 'sensors' });
  private readonly switchedOff = new Set<number>();
  private rows: Row[] = [];

  constructor(
    private readonly state: RoomState,
    private readonly switched: (sensor: number, visible: boolean) => void,
  ) {}

  rebuild(): void {
    const entries = [...(this.state.roster?.sensors ?? [])].sort((a, b) =>
      a.name.localeCompare(b.name, 'en', { numeric: true }),
    );
    this.rows = entries.map((entry) => ({ entry, figures: element('span', { class: 'rates' }) }));
    const items = this.rows.map((row) => this.item(row));
    this.root.replaceChildren(...(items.length > 0 ? items : [element('li', { class: 'none' }, panelTexts.noSensors)]));
  }

  refresh(): void {
    const room_ms = this.state.roomTime_ms();
    for (const { entry, figures } of this.rows) {
      const traffic = this.state.status?.sensors.find((counts) => counts.sensor === entry.id);
      const captured = traffic?.lastCapture_ms;
      const age = room_ms === undefined || captured === undefined ? undefined : Math.max(0, room_ms - captured);
      const fps = perSecond(this.state.sensorFps(entry.id));
      const rate = megabytes(this.state.sensorBytesPerSecond(entry.id));
      setText(figures, entry.online ? `${fps} fps · ${rate} MB/s · ${milliseconds(age)}` : panelTexts.gone);
    }
  }

  private item({ entry, figures }: Row): HTMLElement {
    const box = element('input', { type: 'checkbox', 'aria-label': panelTexts.showSensor(entry.name) });
    box.checked = !this.switchedOff.has(entry.id);
    box.addEventListener('change', () => {
      if (box.checked) this.switchedOff.delete(entry.id);
      else this.switchedOff.add(entry.id);
      this.switched(entry.id, box.checked);
    });
    const swatch = element('span', { class: 'swatch', 'aria-hidden': 'true' });
    swatch.style.background = sensorColor(entry.id);
    const name = element('span', { class: 'name' }, entry.name, placementTag(entry.pose));
    return element('li', { class: entry.online ? '' : 'gone' }, element('label', {}, box, swatch, name), figures);
  }
}
