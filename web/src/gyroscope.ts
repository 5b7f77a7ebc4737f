// SPDX-License-Identifier: Apache-2.0
// Looking around by turning a phone: its movements are added to the view, so that fingers still work.
import { gyroscopeTexts as texts } from './texts';
import { gazeOf, turnBetween, type Gaze } from './view/device_turn';

const patience_ms = 2000; // for the first event

/** Some browsers ask the user first. */
type WithPermission = typeof DeviceOrientationEvent & { requestPermission?: () => Promise<'granted' | 'denied'> };

export class Gyroscope {
  private before: Gaze | undefined;
  private isOn_ = false;
  private readonly listen = (event: DeviceOrientationEvent) => this.turned(event);

  constructor(private readonly turn: (dYaw: number, dPitch: number) => void) {}

  /** On devices with a touch screen; the event exists on others, too, and never comes. */
  static get isOffered(): boolean {
    return 'DeviceOrientationEvent' in window && matchMedia('(pointer: coarse)').matches;
  }

  get isOn(): boolean {
    return this.isOn_;
  }

  /** Returns why it cannot be on although it was wanted; empty if nothing is wrong. Call it from a gesture. */
  async toggle(): Promise<string> {
    if (this.isOn) {
      this.end();
      return '';
    }
    if (!window.isSecureContext) return texts.insecure;
    const answer = await (DeviceOrientationEvent as WithPermission).requestPermission?.().catch(() => 'denied');
    if (answer === 'denied') return texts.denied;
    this.before = undefined;
    this.isOn_ = true;
    window.addEventListener('deviceorientation', this.listen);
    await new Promise((resolve) => setTimeout(resolve, patience_ms));
    if (this.before || !this.isOn) return '';
    this.end();
    return texts.none;
  }

  private end(): void {
    this.isOn_ = false;
    window.removeEventListener('deviceorientation', this.listen);
  }

  private turned({ alpha, beta, gamma }: DeviceOrientationEvent): void {
    if (alpha === null || beta === null || gamma === null) return;
    const now = gazeOf(alpha, beta, gamma, screen.orientation?.angle ?? 0);
    if (this.before) {
      const { yaw, pitch } = turnBetween(this.before, now);
      this.turn(yaw, pitch);
    }
    this.before = now;
  }
}
