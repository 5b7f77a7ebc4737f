// SPDX-License-Identifier: Apache-2.0
// Asks for one's name where the others would see a number only, and lets one change it.
import { nameTexts as texts } from '../texts';
import { element } from './element';
import { labelled, textField } from './form';

const longest = 64; // characters; the page shortens it to the bytes that are permitted

export class NameForm {
  readonly root = element('div', { class: 'name-form' });
  private readonly field = textField(longest);
  private readonly form: HTMLElement;
  private readonly change = element('button', { type: 'button', class: 'plain' }, texts.change);
  private isOpen = true;
  private isHere = false;

  /** `taken` returns the name as far as it can be used; empty if it cannot. */
  constructor(
    private name: string,
    private readonly taken: (name: string) => string,
  ) {
    this.field.autocomplete = 'name';
    const take = element('button', { type: 'submit', class: 'plain' }, texts.take);
    this.form = element('form', {}, labelled(texts.name, this.field), take);
    this.form.addEventListener('submit', (event) => {
      event.preventDefault();
      this.take();
    });
    this.form.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || !this.name) return;
      event.preventDefault();
      this.close();
    });
    this.change.addEventListener('click', () => this.open());
    this.isOpen = name === '';
    this.root.append(this.form, this.change);
    this.show();
  }

  /** Only who is in the room needs a name. */
  setHere(isHere: boolean): void {
    this.isHere = isHere;
    this.show();
  }

  private take(): void {
    const name = this.taken(this.field.value);
    if (!name) return this.field.focus();
    this.name = name;
    this.close();
  }

  private open(): void {
    this.field.value = this.name;
    this.isOpen = true;
    this.show();
    this.field.select();
    this.field.focus();
  }

  private close(): void {
    this.isOpen = false;
    this.show();
    this.change.focus();
  }

  private show(): void {
    this.root.hidden = !this.isHere;
    this.form.hidden = !this.isOpen;
    this.change.hidden = this.isOpen;
  }
}
