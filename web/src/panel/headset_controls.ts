// SPDX-License-Identifier: Apache-2.0
// Controls for entering a headset: a button for each mode that this browser supports, or advice if there is none.
import { headsetTexts as texts } from '../texts';
import type { HeadsetMode, HeadsetOffer } from '../xr/offer';
import { element, setText } from './element';

export interface HeadsetControlEvents {
  enter(mode: HeadsetMode): Promise<void>;
  leave(): void;
}

export class HeadsetControls {
  readonly root = element('div', { class: 'headset' });
  private readonly note = element('p', { role: 'status' });
  private readonly buttons: HTMLButtonElement[] = [];
  private modes: readonly HeadsetMode[] = [];
  private readonly leave = element('button', { type: 'button', class: 'plain', hidden: '' }, texts.leave);

  constructor(private readonly events: HeadsetControlEvents) {
    this.leave.addEventListener('click', () => events.leave());
    this.root.append(this.leave, this.note);
  }

  offer({ modes, obstacle }: HeadsetOffer): void {
    this.buttons.forEach((button) => button.remove());
    this.buttons.length = 0;
    this.modes = modes;
    for (const mode of modes) this.buttons.push(this.button(mode));
    this.root.prepend(...this.buttons);
    setText(this.note, modes.length > 0 ? texts.help : texts.obstacles[obstacle]);
  }

  /** Whether one could enter a virtual room now. */
  get offersVr(): boolean {
    return this.leave.hidden && this.modes.includes('immersive-vr');
  }

  enterVr(): void {
    void this.enter('immersive-vr');
  }

  setOn(on: boolean): void {
    this.buttons.forEach((button) => (button.hidden = on));
    this.leave.hidden = !on;
  }

  private button(mode: HeadsetMode): HTMLButtonElement {
    const label = mode === 'immersive-vr' ? texts.enterVr : texts.enterAr;
    const button = element('button', { type: 'button', class: mode === 'immersive-vr' ? 'main' : 'plain' }, label);
    button.addEventListener('click', () => void this.enter(mode));
    return button;
  }

  private async enter(mode: HeadsetMode): Promise<void> {
    setText(this.note, texts.entering);
    try {
      await this.events.enter(mode);
      setText(this.note, texts.help);
    } catch (error) {
      setText(this.note, texts.failed((error as Error).message));
    }
  }
}
