// SPDX-License-Identifier: Apache-2.0
// Chooses one of several hubs: the first to answer of the page's own hub and those announced by hubs. The page stays
// there. When that hub is lost or refuses the page, the others are tried at once; after a failure of all of them in a
// row, there is a delay. As roomcast/client/hub_choice.h. Pure.

const defaultPort = 7600;
const defaultTlsPort = 443; // of every wss:// and https:// address

export class HubChoice {
  private others: string[] = [];
  private here: string;
  private avoidsHere = false;
  private readonly useless = new Set<string>();
  private readonly refusing = new Set<string>(); // hubs that will refuse this page again
  private failures = 0; // consecutive

  /** `own` is the socket of the hub that served the page. */
  constructor(private readonly own: string) {
    this.here = own;
  }

  /** The hub that answered last. */
  get current(): string {
    return this.here;
  }
  get hasOthers(): boolean {
    return this.all.length > 1;
  }

  /** No hub is left that might accept this page. */
  get allRefuse(): boolean {
    return this.all.every((hub) => this.refusing.has(hub));
  }

  /** The hubs to try now, all at once. */
  toTry(): string[] {
    const hubs = this.avoidsHere ? this.all.filter((hub) => hub !== this.here) : this.all;
    return hubs.length > 0 ? hubs : this.all;
  }

  /** Replaces the other addresses of the room by those announced by the current hub. */
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
    this.refusing.clear();
  }

  /**
   * The current hub is lost, or has refused the page. True: try the others at once. `hopeless`: it will always refuse.
   */
  failed(hopeless: boolean): boolean {
    if (hopeless && this.here !== this.own) this.useless.add(this.here);
    if (hopeless) this.refusing.add(this.here);
    const count = this.all.length;
    this.avoidsHere = true;
    return ++this.failures % count !== 0;
  }
  /** No hub answered. After a delay, all are tried. */
  nobodyAnswered(): void {
    this.avoidsHere = false;
  }

  private get all(): string[] {
    return [...new Set([this.own, this.here, ...this.others])].filter((hub) => !this.useless.has(hub));
  }
}

/** "wss://b/ws#sha256=..." -> "wss://b:443/ws"; undefined for anything but a hub's address. */
export function socketOf(hubUrl: string): string | undefined {
  const found = /^(wss?|https?):\/\/(\[[0-9a-f:.]+\]|[a-z0-9.-]+)(:\d{1,5})?(\/[^#?\s]*)?(#.*)?$/i.exec(hubUrl);
  if (!found) return undefined;
  const [, scheme, host, port, path] = found;
  const isSafe = /^(wss|https)$/i.test(scheme!);
  const usualPort = `:${isSafe ? defaultTlsPort : defaultPort}`;
  return `${isSafe ? 'wss' : 'ws'}://${host!.toLowerCase()}${port ?? usualPort}${path && path !== '/' ? path : '/ws'}`;
}
