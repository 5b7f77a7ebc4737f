// SPDX-License-Identifier: Apache-2.0
// The console is loaded when the hub has let in somebody who may use it; nobody else waits for it.
import type { Console } from './console/console';
import type { ViewFrame } from './stream/protocol';

export interface ConsoleRights {
  mayNudge: boolean;
  isAdmin: boolean;
}

export class LazyConsole {
  private console: Console | undefined;
  private loading: Promise<Console> | undefined;
  private rights: ConsoleRights = { mayNudge: false, isAdmin: false };

  /** `load` fetches and makes the console; it is called again after it has failed. */
  constructor(private readonly load: () => Promise<Console>) {}

  /** Rejects where the console cannot be loaded. */
  async offer(rights: ConsoleRights): Promise<void> {
    this.rights = rights;
    if (this.console || rights.mayNudge || rights.isAdmin) (await this.ready()).setRights(this.rights);
  }

  get isOpen(): boolean {
    return this.console?.open ?? false;
  }

  /** Opens or closes it. Rejects where it cannot be loaded. */
  async toggle(): Promise<void> {
    const console = await this.ready();
    console.setOpen(!console.open);
  }

  /** Called with frames before they are drawn. */
  offerFrames(frames: readonly ViewFrame[], now_ms: number): void {
    this.console?.offer(frames, now_ms);
  }

  private ready(): Promise<Console> {
    this.loading ??= this.load().then(
      (made) => {
        this.console = made;
        made.setRights(this.rights);
        return made;
      },
      (reason: unknown) => {
        this.loading = undefined;
        throw reason;
      },
    );
    return this.loading;
  }
}
