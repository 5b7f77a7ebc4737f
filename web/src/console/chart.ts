// SPDX-License-Identifier: Apache-2.0
// A small line chart of the last minutes, with its newest value and its scale as text.
import { element, setText } from '../panel/element';
import { svg } from '../panel/svg';
import { chartPath, History, scaleOf } from './history';

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
  private readonly value = element('span', { class: 'value' }, '–');

  constructor(private readonly style: ChartStyle) {
    const picture = svg('svg', {
      viewBox: `0 0 ${width} ${height}`,
      preserveAspectRatio: 'none',
      'aria-hidden': 'true',
    });
    picture.append(this.area, this.line);
    const words = element('div', { class: 'words' }, element('span', {}, style.label), this.value);
    this.root = element('div', { class: 'chart' }, words);
    this.root.append(picture);
  }

  add(value: number | undefined): void {
    const { label, unit, least, digits } = this.style;
    this.history.add(value);
    const { readings } = this.history;
    const scale = scaleOf(readings, least);
    const path = chartPath(readings, scale, width, height);
    this.line.setAttribute('d', path);
    this.area.setAttribute('d', closed(path));
    const text = value === undefined ? '–' : `${value.toFixed(digits)} ${unit}`.trim();
    setText(this.value, text);
    this.root.title = `${label} over the last three minutes; the chart's top is ${scale} ${unit}`.trim();
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
