// SPDX-License-Identifier: Apache-2.0
// Paired comparison: of each pair of pictures, a photograph and a drawn view of the same place, one is left and one right by
// chance, and the participant says which is which. All that is needed to tell them apart is the pictures themselves: they are
// drawn on canvases, without names or addresses.
import { element, setText } from '../panel/element';
import type { Comparison } from './study_plan';
import { studyTexts as texts } from './study_texts';

export type Kind = 'real' | 'drawn';

export interface Verdict {
  pair: string;
  left: Kind;
  chosen: 'left' | 'right';
  correct: boolean; // the photograph was chosen
  after_s: number;
}

/** A number from 0 to 1, 1 left out. */
export type Chance = () => number;

/** In an order drawn by chance (Fisher and Yates 1938), each with the kind that is on the left. */
export function drawnOrder(pairs: readonly string[], chance: Chance): { index: number; pair: string; left: Kind }[] {
  const order = pairs.map((pair, index) => ({ index, pair, left: (chance() < 0.5 ? 'real' : 'drawn') as Kind }));
  for (let i = order.length - 1; i > 0; i--) {
    const j = Math.floor(chance() * (i + 1));
    [order[i], order[j]] = [order[j]!, order[i]!];
  }
  return order;
}

export class Comparing {
  readonly root = element('div', { class: 'comparing' });
  private readonly progress = element('p', { class: 'note', role: 'status' });
  private readonly pictures = element('div', { class: 'pair', tabindex: '-1' });

  constructor(
    private readonly comparison: Comparison,
    private readonly picture: (index: number, kind: Kind) => Promise<Blob>,
  ) {
    const { title, intro, question } = comparison;
    const words = intro ? [element('p', { class: 'words' }, intro)] : [];
    this.root.append(element('h2', {}, title || texts.comparing), ...words, element('p', { class: 'question' }, question), this.pictures, this.progress);
  }

  /** One pair after the other; `decided` is called for each. Rejects where a picture cannot be had. */
  async run(decided: (verdict: Verdict) => void): Promise<void> {
    const order = drawnOrder(this.comparison.pairs, Math.random);
    for (const [number, { index, pair, left }] of order.entries()) {
      const kinds: Kind[] = left === 'real' ? ['real', 'drawn'] : ['drawn', 'real'];
      const shown = await Promise.all(kinds.map(async (kind) => paint(await this.picture(index, kind))));
      setText(this.progress, texts.pairOf(number + 1, order.length)); // with its pictures: those of the pair before were there until now
      const { chosen, after_s } = await this.ask(shown);
      decided({ pair, left, chosen, correct: (chosen === 'left') === (left === 'real'), after_s });
    }
  }

  private ask(canvases: readonly HTMLCanvasElement[]): Promise<Pick<Verdict, 'chosen' | 'after_s'>> {
    return new Promise((resolve) => {
      const from_ms = performance.now();
      const buttons = (['left', 'right'] as const).map((side, i) => {
        const button = element('button', { type: 'button' }, canvases[i], element('span', {}, texts.sides[side]));
        button.addEventListener('click', () => {
          const after_s = Number(((performance.now() - from_ms) / 1000).toFixed(2));
          resolve({ chosen: side, after_s });
        });
        return button;
      });
      this.pictures.replaceChildren(...buttons);
      this.pictures.focus(); // none of the two is suggested
      const { seconds } = this.comparison;
      if (seconds > 0) setTimeout(() => canvases.forEach(hide), 1000 * seconds);
    });
  }
}

async function paint(file: Blob): Promise<HTMLCanvasElement> {
  const bitmap = await createImageBitmap(file);
  const canvas = element('canvas', { width: String(bitmap.width), height: String(bitmap.height), 'aria-hidden': 'true' });
  canvas.getContext('2d')!.drawImage(bitmap, 0, 0);
  bitmap.close();
  return canvas;
}

function hide(canvas: HTMLCanvasElement): void {
  canvas.getContext('2d')!.clearRect(0, 0, canvas.width, canvas.height);
}
