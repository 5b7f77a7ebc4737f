// SPDX-License-Identifier: Apache-2.0
// What the picture lacks because this machine cannot draw more, in words. Pure.
import { panelTexts } from '../texts';
import type { Drawing } from '../view/draw_mode';

const texts = panelTexts.drawing;

/** Empty when everything is drawn as chosen. `isAutomatic`: the page chooses the quality, so the machine is the reason. */
export function drawingNote({ mode, mixes, shown, wanted }: Drawing, isAutomatic = true): string {
  if (!isAutomatic) return '';
  const notes = [];
  if (mode === 'blend' && !mixes && wanted > 0) notes.push(texts.notBlended);
  if (shown < wanted) notes.push(texts.someSensors(shown, wanted));
  return notes.join(' ');
}
