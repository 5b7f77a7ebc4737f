// SPDX-License-Identifier: Apache-2.0
// Asks for the words of a note.
import { element, setText } from '../panel/element';
import { labelled, submit, textField } from '../panel/form';
import { markTexts as texts } from '../mark_texts';
import { maxMarkTextBytes } from '../wire/limits';
import { asText } from '../wire/name_check';

export class NoteForm {
  readonly root: HTMLFormElement;
  private readonly field = textField(maxMarkTextBytes);
  private readonly said = element('p', { role: 'status' });
  private given: ((text: string) => string) | undefined;

  constructor(private readonly closed: () => void) {
    const cancel = element('button', { type: 'button', class: 'plain' }, texts.cancel);
    cancel.addEventListener('click', () => this.close());
    const buttons = element('div', { class: 'row' }, submit(texts.leave), cancel);
    this.root = element('form', { class: 'note-form', hidden: '' }, labelled(texts.words, this.field), this.said, buttons);
    this.root.addEventListener('submit', (event) => {
      event.preventDefault();
      this.submit();
    });
    this.root.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.preventDefault();
      this.close();
    });
  }

  /** `given` returns why the note cannot be left now, or nothing. */
  ask(given: (text: string) => string): void {
    this.given = given;
    this.root.hidden = false;
    setText(this.said, '');
    this.field.focus();
  }

  close(): void {
    if (this.root.hidden) return;
    this.root.hidden = true;
    this.field.value = '';
    this.closed();
  }

  /** Words that the hub would not take stay in the field. */
  private submit(): void {
    const typed = this.field.value.trim();
    const text = asText(typed, maxMarkTextBytes);
    if (!text) return setText(this.said, texts.noWords);
    if (text !== typed) return setText(this.said, texts.tooManyWords(maxMarkTextBytes));
    const problem = this.given?.(text) ?? '';
    setText(this.said, problem);
    if (!problem) this.close();
  }
}
