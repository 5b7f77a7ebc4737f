// SPDX-License-Identifier: Apache-2.0
// The custom element <roomcast-view>: a room in a frame, with attributes to steer it and events that tell of it. The
// frame and this page exchange messages over a MessagePort that only they hold (src/embedding/messages.ts).
import { portMessage, readyMessage, type FromRoom, type ToRoom } from '../src/embedding/messages';
import { frameAddress } from './address';
import type { Point, RoomcastState, RoomcastView as View } from './roomcast-view';

const answersWithin_ms = 5000; // after the frame has been loaded
const loadsWithin_ms = 30_000;
// What the hub's page may do in this page: neither open pages in this one's place nor ask for more than it shows.
const sandbox = 'allow-scripts allow-same-origin allow-forms allow-popups allow-popups-to-escape-sandbox allow-downloads';
const permissions = ['fullscreen', 'autoplay', 'xr-spatial-tracking', 'gyroscope', 'accelerometer', 'clipboard-write'];
const style = `
  :host { display: block; position: relative; aspect-ratio: 16 / 9; overflow: hidden; }
  :host([hidden]) { display: none; }
  iframe { position: absolute; inset: 0; width: 100%; height: 100%; border: 0; }
  p { position: absolute; inset: 0; display: grid; place-content: center; margin: 0; padding: 1em 2em;
      color: #e6ebf1; background: #181a1e; font: 0.9rem/1.5 system-ui, sans-serif; text-align: center; }
  p:empty { display: none; }
`;

const notYet: RoomcastState = {
  phase: 'loading',
  sentence: '',
  needsToken: false,
  room: '',
  people: 0,
  sensors: 0,
  places: [],
  muted: false,
};

const refusal = (hub: string, site: string) =>
  `${hub} cannot be reached, or does not let this site show the room. The room’s owner can permit it: embed_from = ["${site}"].`;

export class RoomcastView extends HTMLElement implements View {
  static readonly observedAttributes = ['src', 'name', 'controls', 'speak', 'muted', 'place', 'mode'];

  private readonly words = document.createElement('p');
  private readonly root: ShadowRoot;
  private frame: HTMLIFrameElement | undefined;
  private port: MessagePort | undefined;
  private secret = '';
  private known = notYet;
  private deadline: ReturnType<typeof setTimeout> | undefined;
  private isDue = false; // a new frame
  private readonly heard = (event: MessageEvent) => this.frameReady(event);

  constructor() {
    super();
    this.root = this.attachShadow({ mode: 'closed' });
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(style);
    this.root.adoptedStyleSheets = [sheet];
    this.words.setAttribute('role', 'status');
    this.root.append(this.words);
  }

  get src(): string {
    return this.getAttribute('src') ?? '';
  }

  set src(address: string) {
    this.setAttribute('src', address);
  }

  get token(): string {
    return this.secret;
  }

  set token(token: string) {
    this.secret = token;
    this.loadSoon();
  }

  get muted(): boolean {
    return this.hasAttribute('muted');
  }

  set muted(muted: boolean) {
    this.toggleAttribute('muted', muted);
  }

  get place(): string {
    return this.getAttribute('place') ?? '';
  }

  set place(name: string) {
    this.setAttribute('place', name);
  }

  get state(): RoomcastState {
    return this.known;
  }

  goTo(at: Point, look: Point): void {
    this.tell({ kind: 'look', at, look });
  }

  connectedCallback(): void {
    window.addEventListener('message', this.heard);
    this.loadSoon();
  }

  disconnectedCallback(): void {
    window.removeEventListener('message', this.heard);
    this.unload();
  }

  attributeChangedCallback(name: string, before: string | null, value: string | null): void {
    if (before === value || !this.isConnected) return;
    if (name === 'muted') this.tell({ kind: 'mute', muted: value !== null });
    else if (name === 'place') this.tell({ kind: 'place', name: value ?? '' });
    else if (name === 'mode') this.tell({ kind: 'mode', mode: value ?? 'blend' });
    else this.loadSoon();
  }

  /** Several changes at once load one frame. */
  private loadSoon(): void {
    if (this.isDue || !this.isConnected) return;
    this.isDue = true;
    queueMicrotask(() => {
      this.isDue = false;
      if (this.isConnected) this.load();
    });
  }

  private load(): void {
    this.unload();
    const attribute = (name: string) => this.getAttribute(name) ?? '';
    const [name, mode, controls] = ['name', 'mode', 'controls'].map(attribute) as [string, string, string];
    const { src, token, place, muted } = this;
    const made = frameAddress({ src, base: document.baseURI, token, name, place, mode, controls, muted });
    if ('fault' in made) return this.refuse(made.fault);
    this.become({ ...notYet, muted });
    this.frame = this.makeFrame(made.url);
    this.root.append(this.frame);
    this.refuseAfter(loadsWithin_ms, made.url);
  }

  private makeFrame(url: URL): HTMLIFrameElement {
    const frame = document.createElement('iframe');
    const allowed = this.hasAttribute('speak') ? [...permissions, 'microphone'] : permissions;
    frame.allow = allowed.join('; ');
    frame.setAttribute('sandbox', sandbox);
    frame.referrerPolicy = 'no-referrer';
    frame.title = this.title || `Live room ${url.searchParams.get('room')}`;
    frame.src = url.href;
    frame.addEventListener('load', () => !this.port && this.refuseAfter(answersWithin_ms, url));
    return frame;
  }

  private unload(): void {
    clearTimeout(this.deadline);
    this.port?.close();
    this.port = undefined;
    this.frame?.remove();
    this.frame = undefined;
  }

  private refuseAfter(time_ms: number, { origin }: URL): void {
    clearTimeout(this.deadline);
    this.deadline = setTimeout(() => {
      this.unload();
      this.refuse(refusal(origin, location.origin));
    }, time_ms);
  }

  private refuse(sentence: string): void {
    this.become({ ...notYet, phase: 'refused', sentence, muted: this.muted });
  }

  /** The page in the frame is the hub's and listens. */
  private frameReady({ source, origin, data }: MessageEvent): void {
    const window = this.frame?.contentWindow;
    if (!window || source !== window || data !== readyMessage || origin !== new URL(this.frame!.src).origin) return;
    clearTimeout(this.deadline);
    this.port?.close();
    const { port1, port2 } = new MessageChannel();
    this.port = port1;
    port1.onmessage = ({ data }: MessageEvent<FromRoom>) => data.kind === 'state' && this.become(data.state);
    window.postMessage(portMessage, origin, [port2]);
  }

  private tell(command: ToRoom): void {
    this.port?.postMessage(command);
  }

  private become(state: RoomcastState): void {
    this.known = state;
    this.words.textContent = state.phase === 'refused' ? state.sentence : '';
    this.dispatchEvent(new CustomEvent('roomcast-state', { detail: state }));
  }
}

if (!customElements.get('roomcast-view')) customElements.define('roomcast-view', RoomcastView);
