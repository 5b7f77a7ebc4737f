// SPDX-License-Identifier: Apache-2.0
// Words in the room, of the same size on the screen from everywhere, and never hidden by a surface.
import * as THREE from 'three';

const font_px = 44;
const line_px = 56;
const padding_px = 22;
const widest_px = 760;
const mostLines = 9;
const pin_px = 30; // below the words: the pin, of which the point is the middle
const pinRadius_px = 11;
const fontOfView = 0.021; // height of the letters as a share of the picture's height
const perPixel = (2 * Math.tan(Math.PI / 6) * fontOfView) / font_px; // at a distance of one metre

/** Lines of at most `widest`; words that are longer are broken. The last one ends with "…" where some is left out. */
export function linesOf(text: string, widest: number, most: number, measure: (text: string) => number): string[] {
  const lines: string[] = [];
  let line = '';
  for (const word of text.split(' ')) {
    const longer = line ? `${line} ${word}` : word;
    if (measure(longer) <= widest) {
      line = longer;
      continue;
    }
    if (line) lines.push(line);
    line = '';
    for (const letter of word) {
      if (line && measure(line + letter) > widest) {
        lines.push(line);
        line = '';
      }
      line += letter;
    }
  }
  lines.push(line);
  if (lines.length <= most) return lines;
  return [...lines.slice(0, most - 1), `${lines[most - 1]!} …`];
}

/** Above the sprite's position, which a pin shows. `color` is that of pin and frame: 0xRRGGBB. */
export function textLabel(text: string, color: number): THREE.Sprite {
  const canvas = document.createElement('canvas');
  const paint = canvas.getContext('2d')!;
  const font = `600 ${font_px}px system-ui, sans-serif`;
  paint.font = font;
  const lines = linesOf(text, widest_px, mostLines, (part) => paint.measureText(part).width);
  const width = Math.ceil(Math.max(...lines.map((line) => paint.measureText(line).width))) + 2 * padding_px;
  const height = lines.length * line_px + padding_px;
  canvas.width = width;
  canvas.height = height + pin_px;
  paint.font = font; // a canvas of another size has forgotten it
  paint.fillStyle = 'rgba(13, 17, 23, 0.86)';
  paint.strokeStyle = `#${color.toString(16).padStart(6, '0')}`;
  paint.lineWidth = 5;
  paint.beginPath();
  paint.roundRect(3, 3, width - 6, height - 6, 18);
  paint.fill();
  paint.stroke();
  paint.textBaseline = 'middle';
  drawPin(paint, width / 2, height + pin_px - pinRadius_px - 3);
  paint.fillStyle = '#f2f5f8';
  lines.forEach((line, i) => paint.fillText(line, padding_px, padding_px / 2 + line_px * (i + 0.5)));
  const texture = new THREE.CanvasTexture(canvas);
  texture.colorSpace = THREE.SRGBColorSpace;
  const sprite = new THREE.Sprite(
    new THREE.SpriteMaterial({ map: texture, transparent: true, depthTest: false, depthWrite: false, sizeAttenuation: false }),
  );
  sprite.scale.set(width * perPixel, canvas.height * perPixel, 1);
  sprite.center.set(0.5, (pinRadius_px + 3) / canvas.height);
  sprite.renderOrder = 3;
  return sprite;
}

/** In the colour of the frame, with a dark rim that shows on every surface. */
function drawPin(paint: CanvasRenderingContext2D, x: number, y: number): void {
  paint.fillStyle = paint.strokeStyle;
  paint.strokeStyle = 'rgba(13, 17, 23, 0.86)';
  paint.beginPath();
  paint.arc(x, y, pinRadius_px, 0, 2 * Math.PI);
  paint.fill();
  paint.stroke();
}
