// SPDX-License-Identifier: Apache-2.0
// A board in the room of a headset's wearer: words and buttons on a plane, pointed at with a hand's ray. World
// coordinates, metres.
import * as THREE from 'three';
import { boardWidth_px, buttonAt, layoutBoard, wordsFont_px, type BoardLayout, type LaidButton } from './board_layout';
import type { BoardSheet } from './board_sheet';

const metresPerPixel = 0.0011; // letters of 34 px are 3.7 cm: 1.4 degrees at 1.5 m
const font = (size_px: number) => `500 ${size_px}px system-ui, sans-serif`;

export class Board {
  readonly root: THREE.Mesh<THREE.PlaneGeometry, THREE.MeshBasicMaterial>;
  readonly dot = new THREE.Mesh(new THREE.SphereGeometry(0.008, 12, 8), new THREE.MeshBasicMaterial({ color: 0xffffff, depthTest: false }));
  private readonly canvas = document.createElement('canvas');
  private readonly paint = this.canvas.getContext('2d')!;
  private readonly caster = new THREE.Raycaster();
  private layout: BoardLayout = { height: 1, texts: [], buttons: [] };
  private painted = '';
  private sheet: BoardSheet | undefined;
  private pointed: LaidButton | undefined;

  constructor(private readonly scale = 1) {
    this.canvas.width = boardWidth_px;
    const material = new THREE.MeshBasicMaterial({ transparent: true, depthTest: false, depthWrite: false });
    this.root = new THREE.Mesh(new THREE.PlaneGeometry(1, 1), material);
    this.root.renderOrder = 10;
    this.dot.renderOrder = 11;
    this.root.visible = this.dot.visible = false;
  }

  get isShown(): boolean {
    return this.root.visible;
  }

  /** The words and buttons that are shown; for tests. */
  get content() {
    const { texts, buttons } = this.layout;
    const center = ({ x, y, width, height }: LaidButton) => this.toWorld(x + width / 2, y + height / 2).toArray();
    return {
      texts: texts.map(({ text }) => text),
      buttons: buttons.map((button) => ({ id: button.id, text: button.text, isOn: button.isOn, at: center(button) })),
    };
  }

  show(sheet: BoardSheet | undefined): void {
    this.sheet = sheet;
    this.root.visible = sheet !== undefined;
    if (!sheet) {
      this.dot.visible = false;
      return;
    }
    const { title, words, rows } = sheet;
    const text = JSON.stringify({ title, words, rows });
    if (text === this.painted) return;
    this.painted = text;
    this.layout = layoutBoard(sheet, (part, size_px) => {
      this.paint.font = font(size_px);
      return this.paint.measureText(part).width;
    });
    this.pointed = undefined;
    this.draw();
  }

  /** In front of a head, at `distance_m` and `below_m` its eyes, and facing it. */
  placeBefore(head: THREE.Vector3, yaw: number, distance_m: number, below_m: number): void {
    this.root.position.set(head.x - Math.sin(yaw) * distance_m, head.y - below_m, head.z - Math.cos(yaw) * distance_m);
    this.root.lookAt(head);
    this.root.updateMatrixWorld();
  }

  /** True where the ray meets the board, wherever on it. */
  point(from: THREE.Vector3, direction: THREE.Vector3): boolean {
    if (!this.isShown) return false;
    this.caster.set(from, direction);
    const [hit] = this.caster.intersectObject(this.root, false);
    this.dot.visible = hit !== undefined;
    if (hit) this.dot.position.copy(hit.point);
    const button = hit?.uv && buttonAt(this.layout, hit.uv.x * boardWidth_px, (1 - hit.uv.y) * this.layout.height);
    if (button !== this.pointed) {
      this.pointed = button;
      this.draw();
    }
    return hit !== undefined;
  }

  press(): void {
    if (this.pointed) this.sheet?.press(this.pointed.id);
  }

  dispose(): void {
    this.root.geometry.dispose();
    this.root.material.map?.dispose();
    this.root.material.dispose();
    this.dot.geometry.dispose();
    this.dot.material.dispose();
  }

  private toWorld(x_px: number, y_px: number): THREE.Vector3 {
    const local = new THREE.Vector3(x_px / boardWidth_px - 0.5, 0.5 - y_px / this.layout.height, 0);
    return this.root.localToWorld(local);
  }

  private draw(): void {
    const { canvas, paint, layout } = this;
    const { material } = this.root;
    if (canvas.height !== layout.height || !material.map) {
      canvas.height = layout.height;
      material.map?.dispose();
      material.map = new THREE.CanvasTexture(canvas);
      material.map.colorSpace = THREE.SRGBColorSpace;
      material.needsUpdate = true;
      this.root.scale.set(boardWidth_px, layout.height, 1).multiplyScalar(metresPerPixel * this.scale);
    }
    paint.clearRect(0, 0, canvas.width, canvas.height);
    paint.fillStyle = 'rgba(19, 24, 31, 0.94)';
    paint.beginPath();
    paint.roundRect(0, 0, canvas.width, canvas.height, 28);
    paint.fill();
    paint.textBaseline = 'middle';
    paint.textAlign = 'left';
    paint.fillStyle = '#e6ebf1';
    for (const { text, x, y, font_px } of layout.texts) {
      paint.font = font(font_px);
      paint.fillText(text, x, y);
    }
    layout.buttons.forEach((button) => this.drawButton(button));
    material.map.needsUpdate = true;
  }

  private drawButton(button: LaidButton): void {
    const { paint } = this;
    const { x, y, width, height, text, isOn } = button;
    paint.beginPath();
    paint.roundRect(x, y, width, height, 16);
    paint.fillStyle = isOn ? '#56b4e9' : 'rgba(255, 255, 255, 0.12)';
    paint.fill();
    paint.lineWidth = button === this.pointed ? 6 : 2;
    paint.strokeStyle = button === this.pointed ? '#ffffff' : 'rgba(255, 255, 255, 0.35)';
    paint.stroke();
    paint.fillStyle = isOn ? '#06222f' : '#e6ebf1';
    paint.font = font(wordsFont_px);
    paint.textAlign = 'center';
    paint.fillText(text, x + width / 2, y + height / 2, width - 16);
  }
}
