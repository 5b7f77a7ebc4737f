// SPDX-License-Identifier: Apache-2.0
// A participant's log: keeps records until the hub has them. They go in numbered batches, each of which counts once however
// often it is sent; while the hub is away they wait here.
import { StudyProblem } from './study_api';

export type LogRecord = { kind: string; t: number } & Record<string, string | number | boolean>;

const mostInBatch = 300; // records
const mostBytes = 40_000; // of a batch; the hub takes 64 KB at once, and so does a page that goes away
const mostWaiting = 200_000; // then the oldest poses go: an hour without a hub

interface Batch {
  number: number;
  records: LogRecord[];
}

export type SendBatch = (number: number, records: readonly LogRecord[], isLast: boolean) => Promise<void>;

export class SessionLog {
  problem = ''; // why records are waiting; empty: nothing is wrong
  isLost = false; // the hub will take no more
  private waiting: LogRecord[] = [];
  private sending: Batch | undefined;
  private flushing: Promise<void> | undefined;

  constructor(
    private lastBatch: number,
    private readonly send: SendBatch,
  ) {}

  get isEmpty(): boolean {
    return this.waiting.length === 0 && !this.sending;
  }

  add(record: LogRecord): void {
    this.waiting.push(record);
    if (this.waiting.length <= mostWaiting) return;
    const oldest = this.waiting.findIndex(({ kind }) => kind === 'poses');
    this.waiting.splice(Math.max(0, oldest), 1);
  }

  /** Sends what waits, batch by batch, as long as that works. Who calls it meanwhile waits for the same. */
  flush(): Promise<void> {
    this.flushing ??= this.sendAll().finally(() => (this.flushing = undefined));
    return this.flushing;
  }

  private async sendAll(): Promise<void> {
    try {
      while (!this.isEmpty && !this.isLost) {
        const { number, records } = (this.sending ??= this.next());
        await this.send(number, records, false);
        this.lastBatch = number;
        this.sending = undefined;
        this.problem = '';
      }
    } catch (error) {
      if (!(error instanceof StudyProblem)) throw error;
      this.problem = error.message;
      this.isLost = error.isFinal;
    }
  }

  /** The page goes away: sends once more what has no answer yet, and the rest. */
  leave(): void {
    if (this.isLost) return;
    const batches = this.sending ? [this.sending] : [];
    if (this.waiting.length > 0) batches.push(this.next((this.sending?.number ?? this.lastBatch) + 1));
    for (const { number, records } of batches) void this.send(number, records, true).catch(() => undefined);
  }

  private next(number = this.lastBatch + 1): Batch {
    let bytes = 0;
    let count = 0;
    for (const record of this.waiting.slice(0, mostInBatch)) {
      bytes += new TextEncoder().encode(JSON.stringify(record)).length;
      if (count > 0 && bytes > mostBytes) break;
      count++;
    }
    return { number, records: this.waiting.splice(0, count) };
  }
}
