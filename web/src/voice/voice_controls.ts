// SPDX-License-Identifier: Apache-2.0
// The controls of voice that come with the voice module: how to talk, which microphone, its loudness, whether to hear.
import { element } from '../panel/element';
import { checkbox, labelled } from '../panel/form';
import { RadioGroup } from '../panel/radio_group';
import { voiceTexts as texts } from '../texts';
import type { TalkMode } from './talk_gate';
import type { Voice } from './voice';
import './voice.css';

const pushKey = 'KeyV';
const quietest_db = -60;

/** 0 to 1 for a meter: decibels, as ears hear. */
export function meterOf(loudness: number): number {
  const db = 20 * Math.log10(Math.max(loudness, 1e-6));
  return Math.min(1, Math.max(0, 1 - db / quietest_db));
}

function isTyping(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && target.closest('input:not([type=radio], [type=checkbox], [type=range]), select, textarea') !== null;
}

export class VoiceControls {
  readonly root = element('div', { class: 'voice' });
  private readonly meter = element('meter', { min: '0', max: '1', low: '0.25', 'aria-label': texts.level });
  private readonly hold = element('button', { type: 'button', class: 'plain' }, texts.hold);
  private readonly device = element('select');
  private readonly deviceField = labelled(texts.device, this.device);
  private readonly hear = checkbox(true);
  private readonly talk: RadioGroup<TalkMode>;
  private readonly own = element('div', { class: 'own' });

  constructor(private readonly voice: Voice) {
    const modes = (['voice', 'push'] as const).map((value) => ({ value, label: texts.modes[value] }));
    this.talk = new RadioGroup('talk', texts.talk, modes, (mode) => voice.setMode(mode));
    this.talk.show(voice.mode);
    this.device.addEventListener('change', () => void voice.choose(this.device.value));
    this.hear.addEventListener('change', () => voice.hearOthers(this.hear.checked));
    this.own.append(this.meter, this.talk.root, this.hold, this.deviceField);
    this.root.append(this.own, labelled(texts.hear, this.hear, 'check'));
    this.listenToButton();
    this.listenToKey();
    this.refresh();
  }

  refresh(): void {
    const { voice } = this;
    this.own.hidden = !voice.isOn;
    this.hold.hidden = voice.mode !== 'push';
    this.hold.setAttribute('aria-pressed', String(voice.isPushed));
    this.showDevices();
  }

  showLevel(loudness: number): void {
    this.meter.value = meterOf(loudness);
  }

  private showDevices(): void {
    const { devices, deviceId } = this.voice;
    this.deviceField.hidden = devices.length < 2;
    const known = [...this.device.options].map(({ value, text }) => value + text).join();
    if (known !== devices.map(({ id, label }) => id + label).join()) {
      this.device.replaceChildren(...devices.map(({ id, label }) => element('option', { value: id }, label)));
    }
    if (deviceId) this.device.value = deviceId;
  }

  /** Holding works by pointer and, with the space bar or Enter, by keyboard. */
  private listenToButton(): void {
    const { hold, voice } = this;
    const isPress = ({ code }: KeyboardEvent) => code === 'Space' || code === 'Enter';
    hold.addEventListener('pointerdown', () => voice.push(true));
    for (const end of ['pointerup', 'pointerleave', 'pointercancel', 'blur'] as const) {
      hold.addEventListener(end, () => voice.push(false));
    }
    hold.addEventListener('keydown', (event) => isPress(event) && voice.push(true));
    hold.addEventListener('keyup', (event) => isPress(event) && voice.push(false));
  }

  private listenToKey(): void {
    const { voice } = this;
    window.addEventListener('keydown', ({ code, target, ctrlKey, metaKey, altKey }) => {
      const isFree = !ctrlKey && !metaKey && !altKey && !isTyping(target);
      if (code === pushKey && isFree && voice.isOn && voice.mode === 'push') voice.push(true);
    });
    window.addEventListener('keyup', ({ code }) => code === pushKey && voice.push(false));
    window.addEventListener('blur', () => voice.push(false));
  }
}

/** A slider for one person's volume. */
export function volumeSlider(voice: Voice, viewer: number, name: string): HTMLElement {
  const slider = element('input', { type: 'range', min: '0', max: '2', step: '0.05', class: 'volume' });
  slider.value = String(voice.speakers.volumeOf(viewer));
  slider.setAttribute('aria-label', texts.volumeOf(name));
  slider.title = texts.volumeOf(name);
  slider.addEventListener('input', () => voice.speakers.setVolume(viewer, Number(slider.value)));
  return slider;
}
