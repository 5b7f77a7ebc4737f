// SPDX-License-Identifier: Apache-2.0
// The socket to the hub: joins as a viewer, keeps the clock, passes messages on, and reconnects when it ends, or
// connects to another hub with this room. docs/spec/wire.md §1, §3 and §5. Local time is this program's
// performance.now, in milliseconds.
import { pingDelay_ms, RoomClock } from '../clock/room_clock';
import { ErrorCode, type Control, type Welcome } from '../gen/control_pb';
import { connectionTexts } from '../texts';
import { audioPayload, encodeAudio, parseAudioHeader } from '../wire/audio_header';
import { decodeControl, encodeControl, type ControlMessage } from '../wire/control';
import { framePayload, MessageType, messageType, parseFrameHeader } from '../wire/frame_header';
import { asName } from '../wire/name_check';
import { malformed, WireError } from '../wire/wire_error';
import { explain, isHopeless, reconnectDelay_ms, type Ending, type Explanation } from './close_reason';
import { HubChoice } from './hub_choice';
import { initialState, pageTime_ms, type ConnectionState, type StartOptions } from './protocol';
import type { RoomEvents, RoomSource } from './room_source';
import { SocketRace } from './socket_race';

const subprotocol = 'roomcast.v1';
const silence_ms = 8000; // pings are answered about twice a second
// Where another hub has this room, silence is detected earlier, as in roomcast/client/hub_link.h, and the hub is pinged
// to check the connection. The usual round trip on a long path is added.
const silenceWithOthers_ms = 700;
const askedAfter_ms = 200;
const silenceCheck_ms = 100;
const normalClosure = 1000;
const policyClosure = 4000; // private range: a browser may not send 1002 or 1008

export type HubEvents = Omit<RoomEvents, 'playback' | 'rewound' | 'silenced' | 'line'>;

export class HubConnection implements RoomSource {
  received_bytes = 0;
  clock = new RoomClock();

  private socket: WebSocket | undefined;
  private openedAt_ms: number | undefined;
  private silent_ms = 0; // only while timers ran: without timers, messages were not processed either
  private failures = 0;
  private pings = 0;
  private pingTimer: ReturnType<typeof setTimeout> | undefined;
  private silenceTimer: ReturnType<typeof setInterval> | undefined;
  private ending: Ending = noEnding();
  private token: string;
  private name: string;
  private redirected = false; // by a busy hub
  private isOver = false;
  private maySpeak = false;
  private audioSeq = 0;
  private readonly hubs: HubChoice;

  constructor(
    private readonly options: Pick<StartOptions, 'socketUrl' | 'room' | 'name' | 'access' | 'hears' | 'authorKey'> & { plays?: string },
    private readonly events: HubEvents,
  ) {
    this.token = options.access.token;
    this.name = asName(options.name);
    this.hubs = new HubChoice(options.socketUrl);
  }

  connect(): void {
    if (this.isOver) return;
    this.ending = noEnding();
    this.clock = new RoomClock();
    this.pings = 0;
    this.openedAt_ms = pageTime_ms();
    this.report('connecting');
    new SocketRace(this.hubs.toTry(), subprotocol, {
      won: (socket, url) => this.opened(socket, url),
      lost: (event) => this.nobodyAnswered(event),
    });
  }

  send(message: ControlMessage): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(encodeControl(message));
  }

  /** Audio of this viewer; left out where the room does not let it speak, and before room time is known. */
  sendAudio(page_ms: number, ends: boolean, payload: Uint8Array): void {
    const clock = this.clock.estimate();
    if (!this.maySpeak || !clock || this.socket?.readyState !== WebSocket.OPEN) return;
    const room_ms = page_ms - performance.timeOrigin + clock.offset_ms;
    const capture_ns = BigInt(Math.round(room_ms * 1e6));
    this.socket.send(encodeAudio({ ends, seq: this.audioSeq++ >>> 0, capture_ns }, payload));
  }

  /** Joins again under another name: a viewer's name is part of its request to join. */
  rename(name: string): void {
    this.name = asName(name);
    if (!this.socket) return; // it is given with the next request
    this.drop(this.socket, normalClosure);
    this.forget();
    this.connect();
  }

  /** For good. */
  leave(): void {
    this.isOver = true;
    if (!this.socket) return; // one that opens later is closed
    this.drop(this.socket, normalClosure);
    this.forget();
  }

  /** A live room cannot be sought in. */
  control(): void {}

  private get room(): string {
    return this.options.room || this.options.access.room;
  }

  private opened(socket: WebSocket, url: string): void {
    if (this.isOver) return socket.close(normalClosure);
    this.hubs.answered(url);
    socket.onmessage = (event: MessageEvent) => this.received(event.data);
    socket.onclose = (event) => this.closed(event);
    this.socket = socket;
    this.ending.opened = true;
    this.silent_ms = 0;
    const { hears, authorKey, plays = '' } = this.options;
    const role = { case: 'viewer', value: { hears, authorKey, plays } } as const;
    // A code is valid once: after it was exchanged for a token, that token is presented.
    const right = this.token ? { token: this.token } : { code: this.options.access.code };
    this.send({ case: 'join', value: { room: this.room, name: this.name, role, ...right, redirected: this.redirected } });
    this.silenceTimer = setInterval(() => this.checkSilence(), silenceCheck_ms);
  }

  private received(data: unknown): void {
    this.silent_ms = 0;
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
    if (messageType(view) === MessageType.Audio) return this.readAudio(view);
    const header = parseFrameHeader(view);
    this.events.frame(header, framePayload(new Uint8Array(message), header));
  }

  private readAudio(message: DataView): void {
    const header = parseAudioHeader(message);
    this.events.audio(header, audioPayload(new Uint8Array(message.buffer), header));
  }

  private readControl({ message }: Control): void {
    switch (message.case) {
      case 'welcome':
        return this.welcomed(message.value);
      case 'roster':
        return this.events.roster(message.value);
      case 'viewerPoses':
        return this.events.poses(message.value.poses);
      case 'voices':
        return this.events.voices(message.value);
      case 'unseenSensors':
        return this.events.unseen(message.value);
      case 'setEnd':
        return this.events.setEnded(message.value.setId);
      case 'marks':
        return this.events.marks(message.value);
      case 'guide':
        return this.events.guide(message.value.on ? message.value.viewerId : 0);
      case 'clockPong':
        return this.clock.addExchange(
          Number(message.value.clientNs) / 1e6,
          performance.now(),
          Number(message.value.hubNs) / 1e6,
        );
      case 'otherHubs':
        return this.hubs.learn(message.value.urls);
      case 'error':
        this.ending.error = { code: message.value.code, sentence: message.value.sentence };
        this.redirected ||= message.value.code === ErrorCode.ERROR_BUSY;
    }
  }

  private welcomed(welcome: Welcome): void {
    this.failures = 0;
    this.redirected = false;
    this.hubs.welcomed();
    if (welcome.token) this.token = welcome.token;
    this.maySpeak = welcome.maySpeak;
    this.audioSeq = 0;
    this.events.welcome(welcome);
    this.report('joined');
    this.schedulePing();
  }

  private schedulePing(): void {
    this.pingTimer = setTimeout(
      () => {
        this.ping();
        this.schedulePing();
      },
      pingDelay_ms(this.pings++, Math.random()),
    );
  }

  private ping(): void {
    this.send({ case: 'clockPing', value: { clientNs: BigInt(Math.round(performance.now() * 1e6)) } });
  }

  private checkSilence(): void {
    this.silent_ms += silenceCheck_ms;
    if (this.hubs.hasOthers && this.silent_ms === askedAfter_ms) this.ping();
    const longest_ms = this.hubs.hasOthers ? Math.min(silenceWithOthers_ms + this.clock.roundTrip_ms, silence_ms) : silence_ms;
    if (this.silent_ms > longest_ms) this.hangUp('The hub has gone silent.', false);
  }

  /** Closes without waiting for the close event, which may come minutes later when the other side is silent. */
  private hangUp(sentence: string, unsupported: boolean): void {
    const socket = this.socket;
    if (!socket) return;
    this.ending.ownFault = { sentence, unsupported };
    this.drop(socket, policyClosure);
    this.closed({ code: normalClosure, reason: '' });
  }

  private drop(socket: WebSocket, code: number): void {
    socket.onmessage = socket.onclose = null;
    socket.close(code);
  }

  /** The connection is over. */
  private forget(): void {
    clearTimeout(this.pingTimer);
    clearInterval(this.silenceTimer);
    this.maySpeak = false;
    this.socket = undefined;
    this.events.disconnected();
  }

  private closed(event: Pick<CloseEvent, 'code' | 'reason'>): void {
    this.forget();
    const why = this.explain(event);
    const hopeless = isHopeless(this.ending);
    if (this.hubs.failed(hopeless)) {
      this.report('waiting', { ...why, sentence: `${why.sentence} ${connectionTexts.elsewhere}` });
      setTimeout(() => this.connect(), 0);
    } else if (hopeless && this.hubs.allRefuse) {
      this.report('waiting', { ...why, ended: true });
    } else {
      this.connectLater(why, hopeless);
    }
  }

  private nobodyAnswered(event: Pick<CloseEvent, 'code' | 'reason'>): void {
    this.events.disconnected();
    const why = this.explain(event);
    this.hubs.nobodyAnswered();
    this.connectLater(why, false);
  }

  private explain({ code, reason }: Pick<CloseEvent, 'code' | 'reason'>): Explanation {
    this.ending.closeCode = code;
    this.ending.closeReason = reason;
    return explain(this.ending, new URL(this.hubs.current).host, this.room);
  }

  private connectLater(why: Explanation, hopeless: boolean): void {
    const delay = reconnectDelay_ms(++this.failures, Math.random(), hopeless);
    this.report('waiting', { ...why, retryAt_ms: Date.now() + delay });
    setTimeout(() => this.connect(), delay);
  }

  private report(phase: ConnectionState['phase'], facts: Partial<ConnectionState> = {}): void {
    this.events.connection({ ...initialState, openedAt_ms: this.openedAt_ms, ...facts, phase });
  }
}

function noEnding(): Ending {
  return { opened: false, closeCode: 0, closeReason: '', error: undefined, ownFault: undefined };
}
