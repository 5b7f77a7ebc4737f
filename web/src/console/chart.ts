// SPDX-License-Identifier: Apache-2.0
// A small line chart of the last minutes, with its newest value, its scale and its time as text. Under the mouse or a finger
// it tells the value of that time.
import { element, setText } from '../panel/element';
import { svg } from '../panel/svg';
import { consoleTexts } from '../console_texts';
import { chartPath, History, keptReadings, readingAt, scaleOf } from './history';

const texts = consoleTexts.charts;
const width = 150;
const height = 34;

export interface ChartStyle {
  label: string;
  unit: string;
  least: number; // smallest maximum of the scale
  digits: number;
}

export class Chart {
  readonly root: HTMLElement;
  private readonly history = new History();
  private readonly line = svg('path', { class: 'line' });
  private readonly area = svg('path', { class: 'area' });
  private readonly cursor = svg('path', { class: 'cursor' });
  private readonly value = element('span', { class: 'value' }, '–');
  private readonly top = element('span', { class: 'top' });
  private pointed: number | undefined; // share of the width under the mouse

  constructor(private readonly style: ChartStyle) {
    const picture = svg('svg', {
      viewBox: `0 0 ${width} ${height}`,
      preserveAspectRatio: 'none',
      'aria-hidden': 'true',
    });
    picture.append(this.area, this.line, this.cursor);
    const words = element('div', { class: 'words' }, element('span', {}, style.label), this.value);
    const ends = element('div', { class: 'ends', 'aria-hidden': 'true' }, element('span', {}, texts.past), element('span', {}, texts.now));
    const plot = element('div', { class: 'plot' }, this.top);
    plot.append(picture);
    this.root = element('div', { class: 'chart' }, words, plot, ends);
    plot.addEventListener('pointermove', ({ clientX }) => {
      const box = plot.getBoundingClientRect();
      this.point((clientX - box.left) / box.width);
    });
    for (const end of ['pointerleave', 'pointercancel']) plot.addEventListener(end, () => this.point(undefined));
  }

  add(value: number | undefined): void {
    const { unit, least } = this.style;
    this.history.add(value);
    const { readings } = this.history;
    const scale = scaleOf(readings, least);
    const path = chartPath(readings, scale, width, height);
    this.line.setAttribute('d', path);
    this.area.setAttribute('d', closed(path));
    setText(this.top, `${scale} ${unit}`);
    this.say();
  }

  private point(share: number | undefined): void {
    this.pointed = share;
    this.cursor.setAttribute('d', share === undefined ? '' : `M${(share * width).toFixed(1)} 0V${height}`);
    this.say();
  }

  private say(): void {
    const { readings } = this.history;
    if (this.pointed === undefined) return setText(this.value, this.words(readings.at(-1)));
    const { value, age_s } = readingAt(readings, this.pointed);
    setText(this.value, texts.then(this.words(value), Math.min(age_s, keptReadings)));
  }

  private words(value: number | undefined): string {
    return value === undefined ? '–' : `${value.toFixed(this.style.digits)} ${this.style.unit}`.trim();
  }
}

/** Closes each piece of the line down to the base line. */
function closed(path: string): string {
  return path
    .split('M')
    .filter((piece) => piece !== '')
    .map((piece) => {
      const points = piece.split('L');
      const x = (point: string) => point.split(' ')[0];
      return `M${piece}L${x(points.at(-1)!)} ${height}L${x(points[0]!)} ${height}Z`;
    })
    .join('');
}
