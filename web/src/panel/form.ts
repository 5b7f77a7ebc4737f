// SPDX-License-Identifier: Apache-2.0
// Labelled fields. The label encloses the field, so that a click on the words works, too.
import { element } from './element';

export function labelled(text: string, field: HTMLElement, className = 'field'): HTMLElement {
  return element('label', { class: className }, element('span', {}, text), field);
}

export function choice<Value extends string>(values: Record<Value, string>, chosen?: Value): HTMLSelectElement {
  const select = element('select');
  for (const [value, text] of Object.entries<string>(values)) select.append(element('option', { value }, text));
  if (chosen !== undefined) select.value = chosen;
  return select;
}

export function textField(longest: number, value = ''): HTMLInputElement {
  const field = element('input', {
    type: 'text',
    maxlength: String(longest),
    autocomplete: 'off',
    spellcheck: 'false',
  });
  field.value = value;
  return field;
}

export function numberField(least: number, most: number, value: number): HTMLInputElement {
  const field = element('input', { type: 'number', min: String(least), max: String(most) });
  field.value = String(value);
  return field;
}

export function checkbox(checked: boolean): HTMLInputElement {
  const box = element('input', { type: 'checkbox' });
  box.checked = checked;
  return box;
}

export function submit(text: string): HTMLButtonElement {
  return element('button', { type: 'submit', class: 'main' }, text);
}
