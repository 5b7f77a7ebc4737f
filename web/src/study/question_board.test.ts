// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from 'vitest';
import { QuestionBoard, type BoardQuestion } from './question_board';
import type { Item } from './study_plan';

const item = (changes: Partial<Item>): Item => ({
  name: 'q', text: 'How real?', kind: 'scale', points: 5, labels: ['not', 'very'], choices: [], required: true, ...changes,
});

function question(changes: Partial<Item>): BoardQuestion {
  let value: number | string = '';
  return { item: item(changes), field: { value: () => value, set: (given) => void (value = given) } };
}

function board(...questions: BoardQuestion[]) {
  const ended = { times: 0 };
  const made = new QuestionBoard({ title: 'Questions', intro: 'Some words' }, questions, () => {
    const missing = questions.findIndex(({ item, field }) => item.required && field.value() === '');
    if (missing >= 0) return missing;
    ended.times++;
    return undefined;
  });
  const texts = () => made.sheet.rows.map(({ text }) => text).filter(Boolean);
  const buttons = () => made.sheet.rows.flatMap((row) => row.buttons);
  return { ended, texts, buttons, press: (id: string) => made.sheet.press(id), words: () => made.sheet.words };
}

describe('a questionnaire in the headset', () => {
  it('shows one question at a time and its scale with the words at the ends', () => {
    const shown = board(question({}), question({ kind: 'choice', choices: ['yes', 'no'], required: false }));
    expect(shown.words()).toEqual(['Some words', 'Question 1 of 2']);
    expect(shown.texts()).toEqual(['How real?', '1: not – 5: very']);
    expect(shown.buttons().map(({ id }) => id)).toEqual(['answer 1', 'answer 2', 'answer 3', 'answer 4', 'answer 5', 'next']);
    shown.press('answer 4');
    expect(shown.buttons().filter(({ isOn }) => isOn).map(({ id }) => id)).toEqual(['answer 4']);
    shown.press('next');
    expect(shown.buttons().map(({ id }) => id)).toEqual(['answer yes', 'answer no', 'back', 'next']);
    shown.press('next');
    expect(shown.ended.times).toBe(1);
  });

  it('goes on when what is required is answered', () => {
    const [first, second] = [question({}), question({ kind: 'choice', choices: ['yes'] })];
    const shown = board(first, second);
    shown.press('next');
    expect(shown.words()).toContain('One answer is missing.');
    shown.press('answer 1');
    shown.press('next');
    shown.press('answer yes');
    first.field.set(''); // on the screen
    shown.press('next');
    expect(shown.words()).toContain('Question 1 of 2');
    expect(shown.ended.times).toBe(0);
  });

  it('takes numbers by a keypad', () => {
    const age = question({ kind: 'number' });
    const shown = board(age);
    for (const key of ['4', '-', '2', '.', '.', '5']) shown.press(`key ${key}`);
    expect(shown.texts()).toContain('42.5');
    expect(age.field.value()).toBe(42.5);
    for (let i = 0; i < 4; i++) shown.press('key ⌫');
    expect(age.field.value()).toBe('');
  });

  it('says that words are typed on the screen', () => {
    const shown = board(question({ kind: 'text', required: false }));
    expect(shown.texts()).toContain('Type this answer on the screen, without the headset; or go on.');
    shown.press('next');
    expect(shown.ended.times).toBe(1);
  });
});
