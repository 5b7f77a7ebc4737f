// SPDX-License-Identifier: Apache-2.0
// Connects to several servers at once: the first WebSocket to open is used, the others are closed.

const openWithin_ms = 5000;

export interface RaceEvents {
  won(socket: WebSocket, url: string): void;
  /** No socket opened; `event` is the close event of the last one. */
  lost(event: Pick<CloseEvent, 'code' | 'reason'>): void;
}

export class SocketRace {
  private readonly running = new Set<WebSocket>();
  private readonly deadline: ReturnType<typeof setTimeout>;

  constructor(
    urls: string[],
    protocol: string,
    private readonly events: RaceEvents,
  ) {
    this.deadline = setTimeout(() => this.isOver({ code: 1006, reason: '' }), openWithin_ms);
    urls.forEach((url) => this.enter(url, protocol));
  }

  private enter(url: string, protocol: string): void {
    const socket = new WebSocket(url, protocol);
    socket.binaryType = 'arraybuffer';
    this.running.add(socket);
    socket.onopen = () => {
      this.running.delete(socket);
      this.end();
      this.events.won(socket, url);
    };
    socket.onclose = (event) => {
      this.running.delete(socket);
      if (this.running.size === 0) this.isOver(event);
    };
  }

  private isOver(event: Pick<CloseEvent, 'code' | 'reason'>): void {
    this.end();
    this.events.lost(event);
  }

  private end(): void {
    clearTimeout(this.deadline);
    for (const socket of this.running) {
      socket.onopen = socket.onclose = null;
      socket.close();
    }
    this.running.clear();
  }
}
