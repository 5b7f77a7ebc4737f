// SPDX-License-Identifier: Apache-2.0
// Where the words and buttons of a board in the headset are, and which button a point is on. Pixels of the board's
// picture, from its top left. Pure.
import { linesOf } from '../marks/text_label';
import type { BoardSheet } from './board_sheet';

export const boardWidth_px = 1024;
export const titleFont_px = 46;
export const wordsFont_px = 34;
const margin_px = 40;
const buttonHeight_px = 78;
const gap_px = 14;
const padding_px = 26; // beside a button's words
const mostLines = 12;

export interface LaidText {
  text: string;
  x: number;
  y: number; // of the middle of the line
  font_px: number;
}

export interface LaidButton {
  id: string;
  text: string;
  isOn: boolean;
  x: number;
  y: number;
  width: number;
  height: number;
}

export interface BoardLayout {
  height: number;
  texts: LaidText[];
  buttons: LaidButton[];
}

/** `measure`: the width of a text in a font. */
export function layoutBoard(sheet: BoardSheet, measure: (text: string, font_px: number) => number): BoardLayout {
  const texts: LaidText[] = [];
  const buttons: LaidButton[] = [];
  const widest = boardWidth_px - 2 * margin_px;
  let y = margin_px;
  const write = (text: string, font_px: number) => {
    for (const line of linesOf(text, widest, mostLines, (part) => measure(part, font_px))) {
      y += 0.75 * font_px;
      texts.push({ text: line, x: margin_px, y, font_px });
      y += 0.6 * font_px;
    }
    y += gap_px;
  };
  if (sheet.title) write(sheet.title, titleFont_px);
  for (const words of sheet.words) write(words, wordsFont_px);
  for (const row of sheet.rows) {
    if (row.text) write(row.text, wordsFont_px);
    y = layRow(row.buttons, y, widest, measure, buttons);
  }
  return { height: Math.ceil(y - gap_px + margin_px), texts, buttons };
}

/** Beside each other as far as they fit, then below. Returns where the next row begins. */
function layRow(
  given: BoardSheet['rows'][number]['buttons'],
  top: number,
  widest: number,
  measure: (text: string, font_px: number) => number,
  into: LaidButton[],
): number {
  let [x, y] = [margin_px, top];
  for (const { id, text, isOn = false } of given) {
    const width = Math.min(widest, Math.max(buttonHeight_px, measure(text, wordsFont_px) + 2 * padding_px));
    if (x > margin_px && x + width > margin_px + widest) [x, y] = [margin_px, y + buttonHeight_px + gap_px];
    into.push({ id, text, isOn, x, y, width, height: buttonHeight_px });
    x += width + gap_px;
  }
  return given.length > 0 ? y + buttonHeight_px + gap_px : y;
}

export function buttonAt({ buttons }: BoardLayout, x: number, y: number): LaidButton | undefined {
  const reach = gap_px / 2; // between two buttons the nearer one is meant
  return buttons.find(
    (button) =>
      x >= button.x - reach && x < button.x + button.width + reach && y >= button.y - reach && y < button.y + button.height + reach,
  );
}
