// SPDX-License-Identifier: Apache-2.0
// One recording in the console's list: what it is, and what can be done with it.
import { AskingButton } from '../panel/asking_button';
import { element, setText } from '../panel/element';
import { textField } from '../panel/form';
import { duration, megabytes } from '../panel/format';
import type { Row } from '../panel/keyed_list';
import { recordingTexts as texts } from '../recording_texts';
import type { KeptRecording } from './recordings_api';

const longestName = 120; // bytes; the hub counts them

export interface RecordingRowEvents {
  download(name: string): void;
  remove(name: string): void;
  /** False: it was refused, and the form stays open. */
  rename(name: string, to: string): Promise<boolean>;
}

/** "12 Nov 2026, 10:15 · 2:31 min · 34.2 MB · 3 sensors · voices · by Ada" */
export function factsOf({ state, began_at, seconds, bytes, sensors, voices, by }: KeptRecording): string {
  const date = new Date(1000 * began_at).toLocaleString('en-GB', { dateStyle: 'medium', timeStyle: 'short' });
  const isRead = state !== 'unreadable';
  const facts = isRead
    ? [date, texts.length(duration(seconds)), texts.size(megabytes(bytes)), texts.sensors(sensors)]
    : [texts.changed(date), texts.size(megabytes(bytes))];
  if (isRead && voices) facts.push(texts.voices);
  return [...facts, ...(by ? [texts.by(by)] : [])].join(' · ');
}

export class RecordingRow implements Row<KeptRecording> {
  readonly root = element('li', { class: 'kept' });
  private readonly name = element('strong');
  private readonly facts = element('span', { class: 'note' });
  private readonly trouble = element('span', { class: 'trouble' });
  private readonly play = element('a', { class: 'plain' }, texts.play);
  private readonly download: HTMLButtonElement;
  private readonly rename: HTMLButtonElement;
  private readonly remove: AskingButton;
  private readonly actions: HTMLElement;
  private readonly field = textField(longestName);
  private readonly form = element('form', { hidden: '' });

  constructor(
    private readonly called: string,
    room: string,
    private readonly events: RecordingRowEvents,
  ) {
    this.play.href = `?${new URLSearchParams({ room, play: called }).toString()}`;
    this.play.setAttribute('aria-label', texts.of(texts.play, called));
    this.download = this.button(texts.download, () => events.download(called));
    this.rename = this.button(texts.rename, () => this.setRenaming(true));
    const asked = { label: texts.remove, question: texts.reallyRemove, of: called };
    this.remove = new AskingButton(asked, () => events.remove(called));
    this.actions = element('span', { class: 'actions' }, this.play, this.download, this.rename, this.remove.root);
    setText(this.name, called);
    this.fillForm();
    this.root.append(this.name, this.facts, this.trouble, this.actions, this.form);
  }

  update(recording: KeptRecording): void {
    const { state, problem } = recording;
    setText(this.facts, factsOf(recording));
    setText(this.trouble, [texts.states[state], problem].filter(Boolean).join(' '));
    this.trouble.classList.toggle('running', state === 'running');
    this.play.hidden = state === 'running' || state === 'unreadable';
    for (const button of [this.download, this.rename, this.remove.root]) button.disabled = state === 'running';
  }

  private fillForm(): void {
    this.field.setAttribute('aria-label', texts.of(texts.newName, this.called));
    const save = element('button', { type: 'submit', class: 'plain' }, texts.save);
    const cancel = element('button', { type: 'button', class: 'plain' }, texts.cancel);
    cancel.addEventListener('click', () => this.setRenaming(false));
    this.form.append(this.field, save, cancel);
    this.form.addEventListener('submit', (event) => {
      event.preventDefault();
      void this.save();
    });
    this.form.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.preventDefault(); // it does not close the console, too
      this.setRenaming(false);
    });
  }

  private async save(): Promise<void> {
    const to = this.field.value.trim();
    if (to === this.called || (await this.events.rename(this.called, to))) this.setRenaming(false);
  }

  private setRenaming(on: boolean): void {
    if (this.form.hidden === !on) return;
    this.form.hidden = !on;
    this.actions.hidden = on;
    this.field.value = this.called;
    if (on) this.field.select();
    else this.rename.focus();
  }

  private button(text: string, run: () => void): HTMLButtonElement {
    const button = element('button', { type: 'button', class: 'plain', 'aria-label': texts.of(text, this.called) }, text);
    button.addEventListener('click', run);
    return button;
  }
}
