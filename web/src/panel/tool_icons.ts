// SPDX-License-Identifier: Apache-2.0
// The tools' pictures: lines on a grid of 24 x 24.
import type { Tool } from '../marks/tool';
import { svg } from './svg';

const paths: Record<Tool | 'list', string> = {
  point: 'M4 20 15 9M15 4v2M20 9h-2M18.5 5.5 17 7M10.5 6.5 12 8M17.5 13.5 16 12',
  note: 'M5 4h14v11H12l-4 4v-4H5zM8.5 8h7M8.5 11h5',
  sketch: 'M4 17c3-8 5-9 6-6s-2 7 1 7 3-5 9-9M18 5l2 2',
  measure: 'M3 15 15 3l6 6L9 21zM7 11l2 2M10 8l3 3M13 5l2 2',
  list: 'M9 6h11M9 12h11M9 18h11M4 6h1M4 12h1M4 18h1',
};

export function toolIcon(tool: Tool | 'list'): SVGElement {
  const icon = svg('svg', { viewBox: '0 0 24 24', 'aria-hidden': 'true' });
  icon.append(svg('path', { d: paths[tool] }));
  return icon;
}
