// SPDX-License-Identifier: Apache-2.0
// A few mutually exclusive choices side by side.
import { element } from './element';

export class RadioGroup<Value extends string> {
  readonly root: HTMLElement;
  private readonly inputs = new Map<Value, HTMLInputElement>();

  constructor(
    name: string,
    label: string,
    choices: readonly { value: Value; label: string; title?: string }[],
    chosen: (value: Value) => void,
  ) {
    this.root = element('div', { class: 'choices', role: 'radiogroup', 'aria-label': label });
    for (const { value, label: text, title } of choices) {
      const input = element('input', { type: 'radio', name, value });
      input.addEventListener('change', () => chosen(value));
      this.inputs.set(value, input);
      this.root.append(element('label', title ? { title } : {}, input, element('span', {}, text)));
    }
  }

  show(value: Value): void {
    this.inputs.get(value)!.checked = true;
  }
}
