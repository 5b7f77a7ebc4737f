// SPDX-License-Identifier: Apache-2.0
// Keeps up with the hub's model of the room: asks for it, then for its changes. What it gets is decoded by a worker.
import type { DecodedModel, FromModelWorker } from './model_worker';

const pause_ms = 4_000; // the hub keeps a silent connection for five seconds

export interface ModelEvents {
  /** The hub's answer to a request; undefined: nothing is newer. Rejects where the hub refuses or is away. */
  changesAfter(version: bigint): Promise<ArrayBuffer | undefined>;
  show(model: DecodedModel): void;
}

export class ModelFollower {
  private version = 0n;
  private readonly worker = new Worker(new URL('./model_worker.ts', import.meta.url), { type: 'module', name: 'model' });

  constructor(private readonly events: ModelEvents) {
    this.worker.onmessage = ({ data }: MessageEvent<FromModelWorker>) => this.take(data);
    this.worker.onerror = () => this.askLater();
    void this.ask();
  }

  private async ask(): Promise<void> {
    const changes = await this.events.changesAfter(this.version).catch(() => undefined);
    if (changes) this.worker.postMessage(changes, [changes]);
    else this.askLater();
  }

  private take(decoded: FromModelWorker): void {
    if ('problem' in decoded) console.warn(`roomcast: the room's model could not be read: ${decoded.problem}`);
    else {
      this.version = decoded.version;
      this.events.show(decoded);
    }
    this.askLater();
  }

  private askLater(): void {
    setTimeout(() => void this.ask(), pause_ms);
  }
}
