// SPDX-License-Identifier: Apache-2.0
// A sensor's settings from afar, in its card: depth coding, target rate, frame rate where it can be set, restart.
import { sensorSettingsTexts as texts } from '../event_texts';
import { consoleTexts } from '../console_texts';
import { AskingButton } from '../panel/asking_button';
import { element, setText } from '../panel/element';
import { choice, labelled, numberField, submit } from '../panel/form';

export interface SensorSettings {
  codec?: string;
  mbit?: number | 'auto'; // 0: no target
  fps?: number; // of a sensor that has a rate of its own: absent
}

export type AskSensor = (wanted: SensorSettings & { restart?: boolean }) => Promise<void>;

type Rate = keyof typeof texts.rates;

const usualMbit = 2;

export function rateOf(mbit: SensorSettings['mbit']): Rate {
  return mbit === 'auto' ? 'auto' : mbit ? 'number' : 'none';
}

/** What differs from `now`. */
export function changesOf(now: SensorSettings, wanted: SensorSettings): SensorSettings {
  const changed = Object.entries(wanted).filter(([field, value]) => now[field as keyof SensorSettings] !== value);
  return Object.fromEntries(changed);
}

export class SensorSettingsForm {
  readonly root = element('details', { class: 'sensor-settings' });
  private readonly codec = choice(texts.codecs);
  private readonly rate = choice<Rate>(texts.rates);
  private readonly mbit = numberField(0.1, 100, usualMbit);
  private readonly fps = numberField(1, 60, 15);
  private readonly fpsField = labelled(texts.fps, this.fps);
  private readonly mbitField = labelled(texts.mbit, this.mbit);
  private readonly fixed = element('p', { class: 'note' }, texts.fpsFixed);
  private readonly said = element('p', { class: 'note', role: 'status' });
  private now: SensorSettings = {};

  constructor(
    name: string,
    private readonly ask: AskSensor,
  ) {
    this.mbit.step = '0.1';
    const restart = new AskingButton({ label: texts.restart, question: texts.reallyRestart, of: name }, () =>
      void this.send({ restart: true }),
    );
    const actions = element('div', { class: 'actions' }, submit(texts.apply), restart.root);
    const form = element('form', {}, labelled(texts.codec, this.codec), labelled(texts.rate, this.rate), this.mbitField, this.fpsField, this.fixed, actions);
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      void this.send(this.wanted);
    });
    this.rate.addEventListener('change', () => this.showFields());
    this.root.append(element('summary', { 'aria-label': texts.title(name) }, texts.open), form, this.said);
    this.root.hidden = true;
  }

  /** Undefined: it takes none. What somebody is typing stays. */
  show(settings: SensorSettings | undefined): void {
    this.root.hidden = settings === undefined;
    if (!settings || JSON.stringify(settings) === JSON.stringify(this.now)) return;
    this.now = settings;
    this.codec.value = settings.codec ?? 'live';
    this.rate.value = rateOf(settings.mbit);
    if (typeof settings.mbit === 'number' && settings.mbit > 0) this.mbit.value = String(settings.mbit);
    if (settings.fps) this.fps.value = String(settings.fps);
    this.showFields();
  }

  private showFields(): void {
    this.mbitField.hidden = this.rate.value !== 'number';
    this.fpsField.hidden = this.now.fps === undefined;
    this.fixed.hidden = !this.fpsField.hidden;
  }

  private get wanted(): SensorSettings {
    const mbit = { none: 0, auto: 'auto' as const, number: Number(this.mbit.value) }[this.rate.value as Rate];
    const fps = this.now.fps === undefined ? {} : { fps: Number(this.fps.value) };
    return changesOf(this.now, { codec: this.codec.value, mbit, ...fps });
  }

  private async send(wanted: SensorSettings & { restart?: boolean }): Promise<void> {
    if (Object.keys(wanted).length === 0) return;
    setText(this.said, texts.asking);
    const problem = await this.ask(wanted).then(() => '', (error: Error) => consoleTexts.failed(error.message));
    setText(this.said, problem || texts.applied);
  }
}
