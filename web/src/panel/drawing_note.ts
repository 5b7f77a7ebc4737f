// SPDX-License-Identifier: Apache-2.0
// What the picture lacks because this machine cannot draw more, in words. Pure.
import { panelTexts } from '../texts';
import type { DrawMode } from '../view/draw_mode';

const texts = panelTexts.drawing;

export interface Drawing {
  mode: DrawMode; // as chosen
  mixes: boolean; // surfaces are blended now
  shown: number; // sensors drawn
  wanted: number; // sensors with a picture that are not switched off
}

/** Empty when everything is drawn as chosen. */
export function drawingNote({ mode, mixes, shown, wanted }: Drawing): string {
  const notes = [];
  if (mode === 'blend' && !mixes && wanted > 0) notes.push(texts.notBlended);
  if (shown < wanted) notes.push(texts.someSensors(shown, wanted));
  return notes.join(' ');
}
