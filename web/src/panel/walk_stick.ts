// SPDX-License-Identifier: Apache-2.0
// A stick on the screen for walking with a thumb, while another finger looks around. For fingers only: keys walk, too.
import { pushOf, type StickPush } from '../view/stick_motion';
import { element } from './element';

export class WalkStick {
  private readonly knob = element('div', { class: 'knob' });
  private finger: number | undefined;

  constructor(
    private readonly root: HTMLElement,
    private readonly pushed: (push: StickPush) => void,
  ) {
    root.append(this.knob);
    root.addEventListener('pointerdown', (event) => this.down(event));
    root.addEventListener('pointermove', (event) => event.pointerId === this.finger && this.push(event));
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'] as const) {
      root.addEventListener(end, (event) => event.pointerId === this.finger && this.release());
    }
    root.addEventListener('contextmenu', (event) => event.preventDefault());
    window.addEventListener('blur', () => this.release());
  }

  setShown(shown: boolean): void {
    this.root.hidden = !shown;
    if (!shown) this.release();
  }

  private down(event: PointerEvent): void {
    event.preventDefault();
    if (this.finger !== undefined) return;
    this.finger = event.pointerId;
    this.root.setPointerCapture(event.pointerId);
    this.push(event);
  }

  private push(event: PointerEvent): void {
    const { left, top, width, height } = this.root.getBoundingClientRect();
    const radius = (width - this.knob.offsetWidth) / 2;
    const push = pushOf(event.clientX - left - width / 2, event.clientY - top - height / 2, radius);
    this.knob.style.transform = `translate(${push.right * radius}px, ${-push.forward * radius}px)`;
    this.pushed(push);
  }

  private release(): void {
    if (this.finger === undefined) return;
    this.finger = undefined;
    this.knob.style.transform = '';
    this.pushed({ forward: 0, right: 0 });
  }
}
