// SPDX-License-Identifier: Apache-2.0
// A button for what cannot be undone: the first press asks, a second one does it. Going elsewhere takes the question back.
import { element, setText } from './element';

export interface AskingButtonTexts {
  label: string;
  question: string;
  of: string; // what it is about, for screen readers
}

export class AskingButton {
  readonly root = element('button', { type: 'button', class: 'plain' });
  private wasAsked = false;

  constructor(
    private readonly texts: AskingButtonTexts,
    act: () => void,
  ) {
    this.ask(false);
    this.root.addEventListener('click', () => {
      const isSure = this.wasAsked;
      this.ask(!isSure);
      if (isSure) act();
    });
    this.root.addEventListener('blur', () => this.ask(false));
    this.root.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || !this.wasAsked) return;
      event.preventDefault(); // it does not close the console, too
      this.ask(false);
    });
  }

  private ask(wasAsked: boolean): void {
    this.wasAsked = wasAsked;
    const { label, question, of } = this.texts;
    const text = wasAsked ? question : label;
    setText(this.root, text);
    this.root.setAttribute('aria-label', `${text}: ${of}`);
    this.root.classList.toggle('asks', wasAsked);
  }
}
