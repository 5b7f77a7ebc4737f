// SPDX-License-Identifier: Apache-2.0
// Buttons for one's own view: back to the start, an address for others that opens it, full screen, a picture.
import { guideTexts } from '../mark_texts';
import { Gyroscope } from '../gyroscope';
import { gyroscopeTexts, viewTexts as texts } from '../texts';
import { element, setText } from './element';
import { labelled, textField } from './form';

export interface SharedView {
  address: string;
  omitsToken: boolean; // this viewer has a token, and it is not in the address
}

export interface ViewToolEvents {
  reset(): void;
  /** The device was turned. */
  turn(dYaw: number, dPitch: number): void;
  share(): SharedView;
  /** A PNG of the view, and the name of its file; null where it cannot be drawn. */
  picture(): Promise<{ png: Blob; name: string } | null>;
  /** Shows everybody around from now on, or no more. */
  guide(on: boolean): void;
}

const download_ms = 60_000; // after that the browser has read the picture

export class ViewTools {
  readonly root = element('div', { class: 'view-tools' });
  private readonly buttons = element('div', { class: 'buttons' });
  private readonly full: HTMLButtonElement;
  private readonly guide: HTMLButtonElement;
  private readonly said = element('p', { role: 'status' });
  private readonly address = textField(0);
  private readonly shared = labelled(texts.address, this.address);

  constructor(private readonly events: ViewToolEvents) {
    this.address.readOnly = true;
    this.address.removeAttribute('maxlength');
    this.address.addEventListener('focus', () => this.address.select());
    this.shared.hidden = true;
    this.add(texts.reset, () => events.reset());
    this.add(texts.share, () => void this.share());
    this.full = this.add(texts.fullScreen, () => void this.switchFullScreen());
    this.full.hidden = !document.fullscreenEnabled;
    this.add(texts.save, () => void this.save());
    if (Gyroscope.isOffered) this.offerGyroscope();
    this.guide = this.add(guideTexts.guide, () => events.guide(!this.guides));
    this.setGuide(false, false);
    document.addEventListener('fullscreenchange', () => this.showFullScreen());
    window.addEventListener('keydown', (event) => this.keyDown(event));
    this.root.append(this.buttons, this.shared, this.said);
  }

  /** `offered`: this viewer may show everybody around; `on`: they do. */
  setGuide(offered: boolean, on: boolean): void {
    this.guide.hidden = !offered;
    this.guide.setAttribute('aria-pressed', String(on));
  }

  private offerGyroscope(): void {
    const gyroscope = new Gyroscope((dYaw, dPitch) => this.events.turn(dYaw, dPitch));
    const button = this.add(gyroscopeTexts.button, () => {
      const done = gyroscope.toggle();
      const show = () => button.setAttribute('aria-pressed', String(gyroscope.isOn));
      show();
      void done.then((problem) => {
        show();
        setText(this.said, problem);
      });
    });
    button.setAttribute('aria-pressed', 'false');
  }

  private get guides(): boolean {
    return this.guide.getAttribute('aria-pressed') === 'true';
  }

  private add(label: string, chosen: () => void): HTMLButtonElement {
    const button = element('button', { type: 'button', class: 'plain' }, label);
    button.addEventListener('click', chosen);
    this.buttons.append(button);
    return button;
  }

  private async share(): Promise<void> {
    const { address, omitsToken } = this.events.share();
    this.address.value = address;
    this.shared.hidden = false;
    const copied = await copy(address);
    if (!copied) this.address.focus();
    setText(this.said, `${copied ? texts.copied : texts.copyByHand}${omitsToken ? ` ${texts.omitsToken}` : ''}`);
  }

  private keyDown(event: KeyboardEvent): void {
    const isForRoom = event.target instanceof Element && event.target.matches('body, canvas');
    if (!isForRoom || event.code !== 'KeyF' || event.repeat) return;
    if (event.ctrlKey || event.metaKey || event.altKey || this.full.hidden) return;
    event.preventDefault();
    void this.switchFullScreen();
  }

  private async switchFullScreen(): Promise<void> {
    try {
      await (document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen());
    } catch {
      setText(this.said, texts.noFullScreen);
    }
  }

  private showFullScreen(): void {
    setText(this.full, document.fullscreenElement ? texts.leaveFullScreen : texts.fullScreen);
  }

  private async save(): Promise<void> {
    const picture = await this.events.picture();
    if (picture) download(picture.png, picture.name);
    setText(this.said, picture ? texts.saved(picture.name) : texts.notSaved);
  }
}

function download(file: Blob, name: string): void {
  const address = URL.createObjectURL(file);
  element('a', { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), download_ms);
}

/** False where the browser does not permit it, as on pages that were not loaded over HTTPS. */
async function copy(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}
