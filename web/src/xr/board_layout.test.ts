// SPDX-License-Identifier: Apache-2.0
import { describe, expect, it } from 'vitest';
import { boardWidth_px, buttonAt, layoutBoard } from './board_layout';
import type { BoardSheet } from './board_sheet';

const measure = (text: string, font_px: number) => 0.5 * font_px * text.length;
const sheet = (changes: Partial<BoardSheet>): BoardSheet => ({ title: '', words: [], rows: [], press: () => {}, ...changes });

describe('a board in the headset', () => {
  it('has its words above its buttons, which lie beside each other', () => {
    const buttons = ['1', '2', '3'].map((id) => ({ id, text: id }));
    const laid = layoutBoard(sheet({ title: 'Title', words: ['Some words'], rows: [{ text: 'A question', buttons }] }), measure);
    expect(laid.texts.map(({ text }) => text)).toEqual(['Title', 'Some words', 'A question']);
    const [a, b, c] = laid.buttons;
    expect(a!.y).toBe(c!.y);
    expect(b!.x).toBeGreaterThan(a!.x + a!.width);
    expect(a!.y).toBeGreaterThan(laid.texts.at(-1)!.y);
    expect(laid.height).toBeGreaterThan(a!.y + a!.height);
  });

  it('breaks long words and rows of many buttons', () => {
    const buttons = Array.from({ length: 21 }, (_, i) => ({ id: String(i), text: String(i + 1) }));
    const laid = layoutBoard(sheet({ words: ['word '.repeat(60)], rows: [{ buttons }] }), measure);
    expect(laid.texts.length).toBeGreaterThan(3);
    for (const { x, width } of laid.buttons) expect(x + width).toBeLessThanOrEqual(boardWidth_px);
    expect(new Set(laid.buttons.map(({ y }) => y)).size).toBeGreaterThan(1);
  });

  it('knows the button that is pointed at', () => {
    const laid = layoutBoard(sheet({ rows: [{ buttons: [{ id: 'a', text: 'A' }, { id: 'b', text: 'B' }] }] }), measure);
    const [a, b] = laid.buttons;
    expect(buttonAt(laid, a!.x + 5, a!.y + 5)!.id).toBe('a');
    expect(buttonAt(laid, b!.x + 5, b!.y + 5)!.id).toBe('b');
    expect(buttonAt(laid, a!.x + 5, a!.y - 20)).toBeUndefined();
  });
});
