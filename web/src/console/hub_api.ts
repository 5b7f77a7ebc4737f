// SPDX-License-Identifier: Apache-2.0
// Client of the hub's HTTP interface, docs/spec/admin.openapi.yaml. The token is sent in a header, never in an address.
// A refusal is a HubRefusal with the hub's own sentence.

import type { HubEvent } from './events';
import type { SensorSettings } from './sensor_settings';

export type Who = 'anyone' | 'token' | 'admin' | 'nobody';
export type Role = 'sensor' | 'viewer' | 'hub' | 'admin';

/** Where people enter; metres, 0 degrees look along -z, counter-clockwise from above. */
export interface StartPosition {
  x: number;
  z: number;
  eye_height?: number;
  yaw_deg?: number;
}

export interface RoomSettings {
  name?: string;
  title?: string;
  max_sensors?: number;
  max_viewers?: number;
  listed?: boolean;
  embed_from?: string[]; // web sites
  send?: Who;
  view?: Who;
  record?: Who;
  export?: Who;
  speak?: Who;
  mark?: Who;
  record_voices?: boolean;
  uplink_mbit?: number; // 0: no limit
  start_positions?: StartPosition[];
}

export interface HubRoom extends RoomSettings {
  name: string;
  title: string;
  sensors: number;
  viewers: number;
  max_viewers: number;
  view: Who;
}

/** How much the infrared light of other cameras disturbs a sensor. */
export interface HubInterference {
  flickering: number; // share of the readings of still surfaces that are missing
  noise_ratio: number; // largest noise of the last seconds, in the sensor's usual noise
  neighbour: string; // '': unknown
  shared: number; // share of the sensor's view that the neighbour lights
  advice: string; // '': nothing needs to be done
}

export interface HubSensor {
  id: number;
  name: string;
  online: boolean;
  address?: string;
  frames: number;
  bytes: number;
  frames_per_second: number;
  bytes_per_second: number;
  unseen?: boolean; // it sends no frames, because nobody sees what it shows
  share_mbit?: number; // of the room's uplink; 0: it sends as it likes
  delay_ms?: number;
  clock_error_ms?: number;
  interference?: HubInterference;
  has_microphone?: boolean; // it has been heard
  muted?: boolean; // the microphone
  settings?: SensorSettings; // absent: it takes none from afar
}

export interface HubViewer {
  id: number;
  name: string;
  address?: string;
  records?: boolean;
  plays?: string; // a recording, in place of the room
  may_speak?: boolean;
  muted?: boolean;
  bytes_per_second: number;
  sets_dropped: number;
  shown_fps?: number;
  latency_ms?: number;
}

export interface HubToken {
  id: string;
  room: string;
  role: Role;
  name?: string;
  issued_at: number;
  expires_at: number;
  revoked: boolean;
  once?: boolean; // an unused one-time code
}

export interface TokenRequest {
  room: string;
  role: Role;
  name?: string;
  ttl_s?: number;
  once?: boolean;
}

export interface NewToken {
  id?: string;
  token?: string;
  code?: string;
  fragment?: string;
  expires_at: number;
}

export interface HubRecording {
  state: 'off' | 'starting' | 'on' | 'stopping' | 'failed';
  file?: string;
  seconds: number;
  frames: number;
  bytes: number;
  problem?: string;
}

export class HubRefusal extends Error {
  constructor(
    sentence: string,
    readonly code: string,
  ) {
    super(sentence);
    this.name = 'HubRefusal';
  }
}

type Method = 'GET' | 'POST' | 'PATCH' | 'DELETE';
type Answered = Pick<Response, 'ok' | 'status' | 'json'> & Partial<Pick<Response, 'arrayBuffer'>>;
type Fetch = (address: string, init: RequestInit) => Promise<Answered>;

const patience_ms = 10_000;

function inRoom(room: string, rest = ''): string {
  return `/rooms/${encodeURIComponent(room)}${rest}`;
}

async function refusalOf(response: Pick<Response, 'status' | 'json'>): Promise<HubRefusal> {
  const said = (await response.json().catch(() => undefined)) as
    { error?: { code?: string; sentence?: string } } | undefined;
  const sentence = said?.error?.sentence ?? `The hub answered ${response.status}.`;
  return new HubRefusal(sentence, said?.error?.code ?? String(response.status));
}

export class HubApi {
  constructor(
    private readonly token: () => string,
    private readonly fetching: Fetch = (address, init) => fetch(address, init),
  ) {}

  async rooms(): Promise<HubRoom[]> {
    return (await this.ask<{ rooms: HubRoom[] }>('GET', '/rooms')).rooms;
  }

  room(room: string): Promise<HubRoom> {
    return this.ask('GET', inRoom(room));
  }

  openRoom(settings: RoomSettings): Promise<HubRoom> {
    return this.ask('POST', '/rooms', settings);
  }

  changeRoom(room: string, settings: RoomSettings): Promise<HubRoom> {
    return this.ask('PATCH', inRoom(room), settings);
  }

  closeRoom(room: string): Promise<void> {
    return this.ask('DELETE', inRoom(room));
  }

  async sensors(room: string): Promise<HubSensor[]> {
    return (await this.ask<{ sensors: HubSensor[] }>('GET', inRoom(room, '/sensors'))).sensors;
  }

  /** The sensor's answer: it does as asked, or a HubRefusal in its words. */
  changeSensor(room: string, name: string, wanted: SensorSettings & { restart?: boolean }): Promise<void> {
    return this.ask('PATCH', inRoom(room, `/sensors/${encodeURIComponent(name)}`), wanted);
  }

  /** A page of those with a higher number than `after`. */
  events(room: string, after: number): Promise<{ events: HubEvent[]; newest: number }> {
    return this.ask('GET', inRoom(room, `/events/after/${after}`));
  }

  /** Only for a sensor that is not online. */
  forgetSensor(room: string, name: string): Promise<void> {
    return this.ask('DELETE', inRoom(room, `/sensors/${encodeURIComponent(name)}`));
  }

  /** Its microphone, for all. */
  muteSensor(room: string, name: string, muted: boolean): Promise<HubSensor> {
    return this.ask('PATCH', inRoom(room, `/sensors/${encodeURIComponent(name)}`), { muted });
  }

  async viewers(room: string): Promise<HubViewer[]> {
    return (await this.ask<{ viewers: HubViewer[] }>('GET', inRoom(room, '/viewers'))).viewers;
  }

  sendAway(room: string, viewer: number): Promise<void> {
    return this.ask('DELETE', inRoom(room, `/viewers/${viewer}`));
  }

  /** For all, also when the viewer joins again with the same token. */
  mute(room: string, viewer: number, muted: boolean): Promise<HubViewer> {
    return this.ask('PATCH', inRoom(room, `/viewers/${viewer}`), { muted });
  }

  /** The model of the room, after 0, or what has changed of it since a version; undefined: nothing. */
  async roomModel(room: string, after: bigint): Promise<ArrayBuffer | undefined> {
    const response = await this.call('GET', inRoom(room, `/model/after/${after}`));
    return response.status === 204 ? undefined : response.arrayBuffer?.();
  }

  recording(room: string): Promise<HubRecording> {
    return this.ask('GET', inRoom(room, '/recording'));
  }

  startRecording(room: string): Promise<HubRecording> {
    return this.ask('POST', inRoom(room, '/recording'));
  }

  stopRecording(room: string): Promise<HubRecording> {
    return this.ask('DELETE', inRoom(room, '/recording'));
  }

  async tokens(): Promise<HubToken[]> {
    return (await this.ask<{ tokens: HubToken[] }>('GET', '/tokens')).tokens;
  }

  makeToken(request: TokenRequest): Promise<NewToken> {
    return this.ask('POST', '/tokens', request);
  }

  revoke(id: string): Promise<void> {
    return this.ask('DELETE', `/tokens/${encodeURIComponent(id)}`);
  }

  /** `path` is below the interface's own. */
  async ask<Answer>(method: Method, path: string, body?: object): Promise<Answer> {
    const response = await this.call(method, path, body);
    return (response.status === 204 ? undefined : await response.json()) as Answer;
  }

  private async call(method: Method, path: string, body?: object): Promise<Answered> {
    const headers: Record<string, string> = {};
    if (this.token()) headers.Authorization = `Bearer ${this.token()}`;
    if (body) headers['Content-Type'] = 'application/json';
    const response = await this.fetching(`api/v1${path}`, {
      method,
      headers,
      signal: AbortSignal.timeout(patience_ms),
      ...(body && { body: JSON.stringify(body) }),
    });
    if (!response.ok) throw await refusalOf(response);
    return response;
  }
}
