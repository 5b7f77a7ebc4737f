// SPDX-License-Identifier: Apache-2.0
// The controls of a recording are loaded when one is played; nobody else waits for them.
import type { PlaybackBar, PlaybackSound } from './playback/playback_bar';
import type { PlaybackCommand, PlaybackState, ViewFrame } from './stream/protocol';

export interface PlaybackEvents {
  control(command: PlaybackCommand): void;
  room(): string;
  sound(): PlaybackSound;
  /** The controls could not be loaded. */
  failed(): void;
}

export class LazyPlayback {
  private bar: PlaybackBar | undefined;
  private isLoading = false;
  private newest: PlaybackState | undefined;

  constructor(private readonly events: PlaybackEvents) {}

  /** For tests. */
  get figures() {
    return this.bar?.figures ?? null;
  }

  show(state: PlaybackState): void {
    this.newest = state;
    if (this.bar) this.bar.show(state);
    else if (!this.isLoading) this.load().catch(() => this.events.failed());
  }

  drawn(frames: readonly ViewFrame[]): void {
    this.bar?.drawn(frames);
  }

  private async load(): Promise<void> {
    this.isLoading = true;
    const { PlaybackBar } = await import('./playback/playback_bar');
    this.bar = new PlaybackBar(this.events.room(), (command) => this.events.control(command), this.events.sound());
    this.bar.show(this.newest!);
  }
}
