// SPDX-License-Identifier: Apache-2.0
// The socket to the hub: joins as a viewer, keeps the clock, hands messages on, and connects again when it ends.
// docs/spec/wire.md §1, §3 and §5. Local time is this program's performance.now, in milliseconds.
import { pingDelay_ms, RoomClock } from '../clock/room_clock';
import type { Control, Roster, ViewerPose, Welcome } from '../gen/control_pb';
import { connectionTexts } from '../texts';
import { decodeControl, encodeControl, type ControlMessage } from '../wire/control';
import { framePayload, MessageType, messageType, parseFrameHeader, type FrameHeader } from '../wire/frame_header';
import { asName } from '../wire/name_check';
import { malformed, WireError } from '../wire/wire_error';
import { explain, isHopeless, reconnectDelay_ms, type Ending } from './close_reason';
import { pageTime_ms, type ConnectionState, type StartOptions } from './protocol';

const subprotocol = 'roomcast.v1';
const silence_ms = 8000; // pings are answered about twice a second
const silenceCheck_ms = 1000;
const normalClosure = 1000;
const policyClosure = 4000; // private range: a browser may not send 1002 or 1008

export interface HubEvents {
  connection(state: ConnectionState): void;
  welcome(welcome: Welcome): void;
  roster(roster: Roster): void;
  poses(poses: ViewerPose[]): void;
  frame(header: FrameHeader, payload: Uint8Array): void;
  /** The connection ended; another one follows. */
  disconnected(): void;
}

export class HubConnection {
  received_bytes = 0;
  clock = new RoomClock();

  private socket: WebSocket | undefined;
  private openedAt_ms: number | undefined;
  private lastHeard_ms = 0;
  private failures = 0;
  private pings = 0;
  private pingTimer: ReturnType<typeof setTimeout> | undefined;
  private silenceTimer: ReturnType<typeof setInterval> | undefined;
  private ending: Ending = noEnding();
  private token: string;
  private otherPages: string[] = []; // of hubs where the room is, too

  constructor(
    private readonly options: Pick<StartOptions, 'socketUrl' | 'room' | 'name' | 'access'>,
    private readonly events: HubEvents,
  ) {
    this.token = options.access.token;
  }

  connect(): void {
    this.ending = noEnding();
    this.clock = new RoomClock();
    this.pings = 0;
    this.openedAt_ms = pageTime_ms();
    this.report('connecting', '');
    const socket = new WebSocket(this.options.socketUrl, subprotocol);
    socket.binaryType = 'arraybuffer';
    socket.onopen = () => this.opened();
    socket.onmessage = (event: MessageEvent) => this.received(event.data);
    socket.onclose = (event) => this.closed(event);
    this.socket = socket;
  }

  send(message: ControlMessage): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(encodeControl(message));
  }

  private get room(): string {
    return this.options.room || this.options.access.room;
  }

  private opened(): void {
    this.ending.opened = true;
    this.lastHeard_ms = performance.now();
    const name = asName(this.options.name);
    const role = { case: 'viewer', value: {} } as const;
    // A code is good for one time: once it has brought a token, that one is shown.
    const right = this.token ? { token: this.token } : { code: this.options.access.code };
    this.send({ case: 'join', value: { room: this.room, name, role, ...right } });
    this.silenceTimer = setInterval(() => this.checkSilence(), silenceCheck_ms);
  }

  private received(data: unknown): void {
    this.lastHeard_ms = performance.now();
    try {
      if (!(data instanceof ArrayBuffer)) throw malformed('the hub sent text, where every message is binary');
      this.received_bytes += data.byteLength;
      this.read(data);
    } catch (error) {
      if (!(error instanceof WireError)) throw error;
      this.hangUp(`The hub sent what this page cannot read: ${error.message}.`, error.fault === 'unsupported');
    }
  }

  private read(message: ArrayBuffer): void {
    const view = new DataView(message);
    if (messageType(view) === MessageType.Control) return this.readControl(decodeControl(new Uint8Array(message)));
    const header = parseFrameHeader(view);
    this.events.frame(header, framePayload(new Uint8Array(message), header));
  }

  private readControl({ message }: Control): void {
    switch (message.case) {
      case 'welcome':
        return this.welcomed(message.value);
      case 'roster':
        return this.events.roster(message.value);
      case 'viewerPoses':
        return this.events.poses(message.value.poses);
      case 'clockPong':
        return this.clock.addExchange(
          Number(message.value.clientNs) / 1e6,
          performance.now(),
          Number(message.value.hubNs) / 1e6,
        );
      case 'otherHubs':
        this.otherPages = message.value.urls.map(pageOf);
        return;
      case 'error':
        this.ending.error = { code: message.value.code, sentence: message.value.sentence };
    }
  }

  private welcomed(welcome: Welcome): void {
    this.failures = 0;
    if (welcome.token) this.token = welcome.token;
    this.events.welcome(welcome);
    this.report('joined', '');
    this.schedulePing();
  }

  private schedulePing(): void {
    this.pingTimer = setTimeout(
      () => {
        this.send({ case: 'clockPing', value: { clientNs: BigInt(Math.round(performance.now() * 1e6)) } });
        this.schedulePing();
      },
      pingDelay_ms(this.pings++, Math.random()),
    );
  }

  private checkSilence(): void {
    if (performance.now() - this.lastHeard_ms > silence_ms) this.hangUp('The hub has gone silent.', false);
  }

  /** The close event may come minutes later when nobody answers, so it is not waited for. */
  private hangUp(sentence: string, unsupported: boolean): void {
    const socket = this.socket;
    if (!socket) return;
    this.ending.ownFault = { sentence, unsupported };
    socket.onmessage = socket.onclose = null;
    socket.close(policyClosure);
    this.closed({ code: normalClosure, reason: '' });
  }

  private closed(event: Pick<CloseEvent, 'code' | 'reason'>): void {
    clearTimeout(this.pingTimer);
    clearInterval(this.silenceTimer);
    this.socket = undefined;
    this.events.disconnected();
    this.ending.closeCode = event.code;
    this.ending.closeReason = event.reason;
    const { sentence, reload } = explain(this.ending, new URL(this.options.socketUrl).host, this.room);
    const delay = reconnectDelay_ms(++this.failures, Math.random(), isHopeless(this.ending));
    this.report('waiting', sentence + this.elsewhere(), reload, Date.now() + delay);
    setTimeout(() => this.connect(), delay);
  }

  /** The page may connect to its own hub only; a person may open another's. */
  private elsewhere(): string {
    return this.otherPages.length > 0 ? ` ${connectionTexts.elsewhere(this.otherPages)}` : '';
  }

  private report(phase: ConnectionState['phase'], sentence: string, reload = false, retryAt_ms?: number): void {
    this.events.connection({ phase, sentence, reload, retryAt_ms, openedAt_ms: this.openedAt_ms });
  }
}

/** "wss://b:7600/ws#sha256=..." -> "https://b:7600" */
function pageOf(hubUrl: string): string {
  return hubUrl.replace(/#.*$/, '').replace(/\/ws$/, '').replace(/^ws/, 'http');
}

function noEnding(): Ending {
  return { opened: false, closeCode: 0, closeReason: '', error: undefined, ownFault: undefined };
}
