// SPDX-License-Identifier: Apache-2.0
// The sensors in the panel: one row each, with a switch, what it sends, and how old its newest frame is.
import { Placement, type SensorEntry } from '../gen/control_pb';
import type { RoomState } from '../room_state';
import { sensorColor } from '../view/sensor_color';
import { element, setText } from './element';
import { megabytes, milliseconds, perSecond } from './format';
import { NudgeControls, type NudgeEvents } from './nudge_controls';

interface Row {
  entry: SensorEntry;
  figures: HTMLElement;
}

export class SensorList {
  readonly root = element('ul', { class: 'sensors' });
  private readonly switchedOff = new Set<number>();
  private rows: Row[] = [];
  private readonly controls: NudgeControls | undefined;

  constructor(
    private readonly state: RoomState,
    private readonly switched: (sensor: number, visible: boolean) => void,
    nudge?: NudgeEvents,
  ) {
    this.controls = nudge && new NudgeControls(nudge);
  }

  rebuild(): void {
    const entries = [...(this.state.roster?.sensors ?? [])].sort((a, b) =>
      a.name.localeCompare(b.name, 'en', { numeric: true }),
    );
    this.rows = entries.map((entry) => ({ entry, figures: element('span', { class: 'rates' }) }));
    const items = this.rows.map((row) => this.item(row));
    this.root.replaceChildren(...(items.length > 0 ? items : [element('li', { class: 'none' }, 'none yet')]));
  }

  refresh(): void {
    const room_ms = this.state.roomTime_ms();
    for (const { entry, figures } of this.rows) {
      const traffic = this.state.status?.sensors.find((counts) => counts.sensor === entry.id);
      const captured = traffic?.lastCapture_ms;
      const age = room_ms === undefined || captured === undefined ? undefined : Math.max(0, room_ms - captured);
      const fps = perSecond(this.state.sensorFps(entry.id));
      const rate = megabytes(this.state.sensorBytesPerSecond(entry.id));
      setText(figures, entry.online ? `${fps} fps · ${rate} MB/s · ${milliseconds(age)}` : 'gone');
    }
  }

  private item({ entry, figures }: Row): HTMLElement {
    const box = element('input', { type: 'checkbox', 'aria-label': `Show sensor ${entry.name}` });
    box.checked = !this.switchedOff.has(entry.id);
    box.addEventListener('change', () => {
      if (box.checked) this.switchedOff.delete(entry.id);
      else this.switchedOff.add(entry.id);
      this.switched(entry.id, box.checked);
    });
    const swatch = element('span', { class: 'swatch', 'aria-hidden': 'true' });
    swatch.style.background = sensorColor(entry.id);
    const name = element('span', { class: 'name' }, entry.name, placementTag(entry));
    const line = element('div', { class: 'line' }, element('label', {}, box, swatch, name), this.moveButton(entry));
    const controls = this.controls?.moving === entry.id ? this.controls.root : undefined;
    return element('li', { class: entry.online ? '' : 'gone' }, line, figures, controls);
  }

  private moveButton(entry: SensorEntry): HTMLElement | undefined {
    const { controls } = this;
    if (!controls) return undefined;
    const moving = controls.moving === entry.id;
    const button = element('button', { type: 'button', class: 'move', 'aria-pressed': String(moving) }, 'move');
    button.title = 'Put this sensor in its place by hand';
    button.addEventListener('click', () => {
      controls.choose(moving ? undefined : entry.id);
      this.rebuild();
    });
    return button;
  }
}

/** How well the aligner knows where the sensor stands; nothing for poses that were given. */
function placementTag(entry: SensorEntry): HTMLElement | undefined {
  if (entry.moved) {
    const title = entry.placementNote || 'It was moved and is being aligned again.';
    return element('span', { class: 'tag', title }, 'moved');
  }
  if (entry.placement === Placement.UNPLACED) {
    return element('span', { class: 'tag', title: entry.placementNote || 'being aligned' }, 'not placed');
  }
  if (entry.placement !== Placement.ALIGNED) return undefined;
  const error_mm = Math.max(1, Math.round(entry.expectedErrorMm));
  const title = entry.placementNote || 'Aligned by what it sees. Expected error 2.5 m in front of it.';
  return element('span', { class: 'tag good', title }, entry.expectedErrorMm > 0 ? `± ${error_mm} mm` : 'aligned');
}
