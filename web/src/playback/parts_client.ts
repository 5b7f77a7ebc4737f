// SPDX-License-Identifier: Apache-2.0
// Fetches a recording from the hub, part by part. A refusal is a PlaybackProblem with a sentence for people.
import { playbackTexts as texts } from '../recording_texts';
import { readPart, type Part } from './part';

const patience_ms = 20_000;

export interface AboutRecording {
  name: string;
  state: 'whole' | 'running' | 'damaged' | 'unreadable';
  seconds: number;
  began_at: number; // seconds since 1970
  voices?: boolean; // absent at a hub of an earlier version
  problem?: string;
}

export class PlaybackProblem extends Error {
  constructor(
    sentence: string,
    readonly needsToken: boolean,
    readonly isFinal: boolean, // another attempt cannot succeed
  ) {
    super(sentence);
    this.name = 'PlaybackProblem';
  }
}

type Fetch = (address: string, init: RequestInit) => Promise<Response>;

export class PartsClient {
  private readonly base: string;
  received_bytes = 0;

  /** `hub` is the address of the page; `token` an admin's, or empty. */
  constructor(
    hub: string,
    room: string,
    recording: string,
    private readonly token: string,
    private readonly fetching: Fetch = (address, init) => fetch(address, init),
  ) {
    this.base = `${hub}api/v1/rooms/${encodeURIComponent(room)}/recordings/${encodeURIComponent(recording)}`;
  }

  async about(): Promise<AboutRecording> {
    return (await (await this.get('')).json()) as AboutRecording;
  }

  async moment(position_s: number): Promise<Part> {
    return this.part(`/moments/${Math.round(1000 * position_s)}`);
  }

  async following(part: number): Promise<Part> {
    return this.part(`/parts/${part}`);
  }

  /** A frame of this sensor that can be decoded alone, for a small picture. */
  async keyFrame(sensor: string, position_s: number): Promise<Part> {
    return this.part(`/sensors/${encodeURIComponent(sensor)}/key-frames/${Math.round(1000 * position_s)}`);
  }

  private async part(path: string): Promise<Part> {
    const bytes = await (await this.get(path)).arrayBuffer();
    this.received_bytes += bytes.byteLength;
    return readPart(bytes);
  }

  private async get(path: string): Promise<Response> {
    const headers: Record<string, string> = this.token ? { Authorization: `Bearer ${this.token}` } : {};
    const signal = AbortSignal.timeout(patience_ms);
    const response = await this.fetching(this.base + path, { headers, signal }).catch(() => {
      throw new PlaybackProblem(texts.unreachable, false, false);
    });
    if (response.ok) return response;
    throw await problemOf(response);
  }
}

async function problemOf(response: Response): Promise<PlaybackProblem> {
  const { status } = response;
  if (status === 404) return new PlaybackProblem(texts.gone, false, true);
  if (status === 401 || status === 403) return new PlaybackProblem(texts.notAllowed, true, true);
  const said = (await response.json().catch(() => undefined)) as { error?: { sentence?: string } } | undefined;
  return new PlaybackProblem(texts.refused(said?.error?.sentence ?? String(status)), false, status < 500);
}
