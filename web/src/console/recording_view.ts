// SPDX-License-Identifier: Apache-2.0
// The console's bar: starts and stops the hub's recording of the room.
import { element, setText } from '../panel/element';
import { duration, megabytes } from '../panel/format';
import { consoleTexts } from '../console_texts';
import type { HubApi, HubRecording } from './hub_api';

const texts = consoleTexts.recording;

export class RecordingView {
  readonly root = element('div', { class: 'recording' });
  private readonly button = element('button', { type: 'button', class: 'main' });
  private readonly said = element('span', { role: 'status' });
  private readonly figures = element('span', { class: 'note' });
  private isOn = false;
  private shown: HubRecording['state'] | '' = '';
  private refusal = ''; // of the last click, until the next one or until a recording begins

  constructor(
    private readonly api: HubApi,
    private readonly room: () => string,
    private readonly changed: () => void, // it has begun or ended
  ) {
    this.button.addEventListener('click', () => void this.toggle());
    this.root.append(this.button, this.said, this.figures);
    this.show({ state: 'off', seconds: 0, frames: 0, bytes: 0 });
  }

  async refresh(): Promise<void> {
    try {
      this.show(await this.api.recording(this.room()));
    } catch (error) {
      setText(this.said, consoleTexts.failed((error as Error).message));
    }
  }

  private async toggle(): Promise<void> {
    this.button.disabled = true;
    this.refusal = '';
    try {
      this.show(await (this.isOn ? this.api.stopRecording(this.room()) : this.api.startRecording(this.room())));
    } catch (error) {
      this.button.disabled = false;
      this.refusal = consoleTexts.failed((error as Error).message);
      setText(this.said, this.refusal);
    }
  }

  private show({ state, file, seconds, bytes, problem }: HubRecording): void {
    if (this.shown !== '' && state !== this.shown) this.changed();
    this.shown = state;
    this.isOn = state === 'on';
    this.button.disabled = state === 'starting' || state === 'stopping';
    setText(this.button, this.isOn ? texts.stop : texts.start);
    this.root.classList.toggle('on', this.isOn);
    if (state === 'starting' || state === 'on') this.refusal = '';
    setText(this.said, this.refusal || (state === 'failed' ? texts.failed(problem ?? '') : texts.states[state]));
    const name = file?.split('/').at(-1);
    setText(this.figures, name ? texts.file(name, duration(seconds), megabytes(bytes)) : '');
    this.figures.title = file ?? '';
  }
}
