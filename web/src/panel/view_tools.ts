// SPDX-License-Identifier: Apache-2.0
// What one can do with one's own view: go back to the start, and give others an address that opens it.
import { viewTexts as texts } from '../texts';
import { element, setText } from './element';
import { labelled, textField } from './form';

export interface SharedView {
  address: string;
  omitsToken: boolean; // this viewer has a token, and it is not in the address
}

export interface ViewToolEvents {
  reset(): void;
  share(): SharedView;
}

export class ViewTools {
  readonly root = element('div', { class: 'view-tools' });
  private readonly buttons = element('div', { class: 'buttons' });
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
    this.root.append(this.buttons, this.shared, this.said);
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
