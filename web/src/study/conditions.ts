// SPDX-License-Identifier: Apache-2.0
// Applies a condition of a study to the page, and takes it back.
import type { DrawMode } from '../view/draw_mode';
import type { Condition } from './study_plan';
import type { StudySeat } from './study_seat';

export class Conditions {
  private hidden: string[] = [];
  private usualMode: DrawMode | undefined;

  constructor(private readonly seat: StudySeat) {}

  /** Returns what this page cannot do of it, as sentences. */
  apply({ mode, latency_ms, fps, sensors_off, voice }: Condition): string[] {
    const { seat } = this;
    this.end();
    this.usualMode = seat.mode();
    if (mode) seat.setMode(mode);
    seat.link.handicap({ latency_ms, fps });
    seat.sound.hearOthers(voice);
    if (!voice && seat.sound.isOn) void seat.sound.toggle();
    const troubles = mode && seat.mode() !== mode ? [`it draws as ${seat.mode()}, not as ${mode}`] : [];
    for (const name of sensors_off) {
      if (seat.state.roster?.sensors.some((sensor) => sensor.name === name)) this.hide(name);
      else troubles.push(`the room has no sensor "${name}"`);
    }
    return troubles;
  }

  end(): void {
    const { seat } = this;
    if (this.usualMode) seat.setMode(this.usualMode);
    this.usualMode = undefined;
    seat.link.handicap({ latency_ms: 0, fps: 0 });
    seat.sound.hearOthers(true);
    this.hidden.forEach((name) => seat.stage.setVisible(name, true));
    this.hidden = [];
  }

  private hide(name: string): void {
    this.seat.stage.setVisible(name, false);
    this.hidden.push(name);
  }
}
