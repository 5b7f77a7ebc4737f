// SPDX-License-Identifier: Apache-2.0
// A QR code as an SVG picture, to be scanned by a phone or a headset.
import qrcode from 'qrcode-generator';
import { svg } from '../panel/svg';

const quiet = 4; // light modules around the code, as the standard requires

export function qrCode(text: string, label: string): SVGElement {
  const code = qrcode(0, 'M');
  code.addData(text);
  code.make();
  const modules = code.getModuleCount();
  const side = modules + 2 * quiet;
  let dark = '';
  for (let row = 0; row < modules; row++) {
    for (let column = 0; column < modules; column++) {
      if (code.isDark(row, column)) dark += `M${column + quiet} ${row + quiet}h1v1h-1z`;
    }
  }
  const picture = svg('svg', { viewBox: `0 0 ${side} ${side}`, role: 'img', 'aria-label': label, class: 'qr' });
  picture.append(svg('rect', { width: side, height: side, fill: '#fff' }), svg('path', { d: dark, fill: '#000' }));
  return picture;
}
