// SPDX-License-Identifier: Apache-2.0
// The controls of a recording are loaded when one is played; nobody else waits for them.
import type { ViewerEntry, ViewerPose } from './gen/control_pb';
import type { PlaybackBar, PlaybackSound } from './playback/playback_bar';
import type { Self } from './playback/together';
import type { PlaybackCommand, PlaybackState, ViewFrame } from './stream/protocol';

export interface PlaybackEvents {
  control(command: PlaybackCommand): void;
  room(): string;
  /** Their names. */
  sensors(): readonly string[];
  sound(): PlaybackSound;
  /** This person, for the others who play the same recording. */
  self(): Self & { token: string };
  /** Those others. */
  people(viewers: ViewerEntry[], poses: ViewerPose[]): void;
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
    const { PlaybackBar, partyOf, picturesOf } = await import('./playback/playback_bar');
    const { events } = this;
    const { name } = this.newest!;
    const [together, pictures] = [partyOf(events, name), picturesOf(events, name)];
    this.bar = new PlaybackBar(events.room(), (command) => events.control(command), events.sound(), together, pictures);
    this.bar.show(this.newest!);
  }
}
