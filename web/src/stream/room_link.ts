// SPDX-License-Identifier: Apache-2.0
// The page's interface to its worker.
import { problemTexts } from '../texts';
import type { Drawing } from '../view/draw_mode';
import { buffersOf } from './protocol';
import type { Body, FromWorker, Handicap, NewMark, PlaybackCommand, StartOptions, ToWorker, ViewFrame } from './protocol';
import { WantedMotion } from './wanted_motion';

export class RoomLink {
  private readonly worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module', name: 'roomcast' });
  private readonly motion = new WantedMotion((isWanted) => this.tell({ kind: 'motion', isWanted }));

  constructor(options: StartOptions, receive: (message: FromWorker) => void) {
    this.worker.onmessage = ({ data }: MessageEvent<FromWorker>) => receive(data);
    this.worker.onerror = (event) => {
      const reason = event.message || 'it could not be loaded';
      receive({ kind: 'broken', sentence: problemTexts.decoderStopped(reason) });
    };
    this.tell({ kind: 'start', options });
  }

  /** The frames have been drawn; returns their pixel buffers. `drawing`: how they were, for what can be drawn at one instant. */
  shown(frames: readonly ViewFrame[], drawing?: Drawing): void {
    const buffers = frames.flatMap(buffersOf);
    this.worker.postMessage({ kind: 'shown', buffers } satisfies ToWorker, buffers);
    if (drawing) this.motion.drawn(drawing, performance.now());
  }

  pose(body: Body): void {
    this.tell({ kind: 'pose', body });
  }

  /** Sends a user's pose of a sensor to the aligner. */
  nudge(sensor: number, worldFromDepth: number[]): void {
    this.tell({ kind: 'nudge', sensor, worldFromDepth });
  }

  /** Connects the voice worker with the hub. */
  connectVoice(port: MessagePort): void {
    this.worker.postMessage({ kind: 'voice', port } satisfies ToWorker, [port]);
  }

  mark(mark: NewMark): void {
    this.tell({ kind: 'mark', mark });
  }

  removeMarks(ids: number[]): void {
    this.tell({ kind: 'removeMarks', ids });
  }

  guide(on: boolean): void {
    this.tell({ kind: 'guide', on });
  }

  playback(command: PlaybackCommand): void {
    this.tell({ kind: 'playback', command });
  }

  /** In a study. */
  handicap(handicap: Handicap): void {
    this.tell({ kind: 'handicap', handicap });
  }

  /** Joins the room again under another name. */
  rename(name: string): void {
    this.tell({ kind: 'rename', name });
  }

  stats(lastSetId: bigint, shownFps: number, latency_ms: number): void {
    this.tell({ kind: 'stats', lastSetId, shownFps, latency_ms });
  }

  /** Leaves the room. */
  end(): void {
    this.worker.terminate();
  }

  private tell(message: ToWorker): void {
    this.worker.postMessage(message);
  }
}
