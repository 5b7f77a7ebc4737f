// SPDX-License-Identifier: Apache-2.0
// At which of several hubs the page is: the one that answers first, of its own and those that hubs name. It stays there;
// when that hub is gone, or has refused it, it knocks at the others at once, and only when all have failed in a row it
// waits. As roomcast/client/hub_choice.h. Pure.

const defaultPort = 7600;

export class HubChoice {
  private others: string[] = [];
  private here: string;
  private avoidsHere = false;
  private readonly useless = new Set<string>();
  private failures = 0; // in a row

  /** `own` is the socket of the hub that the page comes from. */
  constructor(private readonly own: string) {
    this.here = own;
  }

  /** The one that answered last. */
  get current(): string {
    return this.here;
  }
  get hasOthers(): boolean {
    return this.all.length > 1;
  }

  /** Where to knock now, all at once. */
  toTry(): string[] {
    const hubs = this.avoidsHere ? this.all.filter((hub) => hub !== this.here) : this.all;
    return hubs.length > 0 ? hubs : this.all;
  }

  /** Where else the room is, as the current hub says; what it said before is forgotten. */
  learn(hubUrls: string[]): void {
    const isAsSafe = (hub: string) => hub.startsWith('wss:') || this.own.startsWith('ws:');
    this.others = hubUrls.flatMap((url) => socketOf(url) ?? []).filter(isAsSafe);
  }

  answered(hub: string): void {
    this.here = hub;
    this.avoidsHere = false;
  }
  welcomed(): void {
    this.failures = 0;
  }

  /** The current one is gone, or has sent us away; true: knock at the others at once. `hopeless`: and always will. */
  failed(hopeless: boolean): boolean {
    if (hopeless && this.here !== this.own) this.useless.add(this.here);
    const count = this.all.length;
    this.avoidsHere = true;
    return ++this.failures % count !== 0;
  }
  /** None did; one waits, and then knocks at all. */
  nobodyAnswered(): void {
    this.avoidsHere = false;
  }

  private get all(): string[] {
    return [...new Set([this.own, this.here, ...this.others])].filter((hub) => !this.useless.has(hub));
  }
}

/** "wss://b/ws#sha256=..." -> "wss://b:7600/ws"; nothing for what is no hub's address. */
export function socketOf(hubUrl: string): string | undefined {
  const found = /^(wss?|https?):\/\/(\[[0-9a-f:.]+\]|[a-z0-9.-]+)(:\d{1,5})?(\/[^#?\s]*)?(#.*)?$/i.exec(hubUrl);
  if (!found) return undefined;
  const [, scheme, host, port, path] = found;
  const isSafe = /^(wss|https)$/i.test(scheme!);
  return `${isSafe ? 'wss' : 'ws'}://${host!.toLowerCase()}${port ?? `:${defaultPort}`}${path && path !== '/' ? path : '/ws'}`;
}
