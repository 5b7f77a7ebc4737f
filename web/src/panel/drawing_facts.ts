// SPDX-License-Identifier: Apache-2.0
// What is being drawn now, in words: how much of each sensor's picture, how, of how many sensors, and how finely on the
// screen. Pure.
import { qualityTexts as texts } from '../texts';
import type { Drawing } from '../view/draw_mode';
import type { Quality } from '../view/quality_ladder';

/** "Every 4th reading, nearest surface, 3 of 4 sensors, 60 % of the screen’s resolution." Empty before anything is drawn. */
export function drawingFacts({ mode, mixes, shown, wanted }: Drawing, { step, pixelRatio }: Quality): string {
  if (mode === 'still') return `${texts.still}.`;
  if (wanted === 0) return '';
  const how = mode === 'points' ? texts.points : mixes ? texts.blended : texts.nearest;
  const facts = [texts.readings(step), how, texts.sensors(shown, wanted)];
  if (pixelRatio < 1) facts.push(texts.screen(pixelRatio));
  return `${facts.join(', ')}.`;
}
