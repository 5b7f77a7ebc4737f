// SPDX-License-Identifier: Apache-2.0
// The part of the hub's HTTP interface about the recordings that it keeps.
import type { HubApi } from './hub_api';

export interface KeptRecording {
  name: string;
  state: 'whole' | 'running' | 'damaged' | 'unreadable';
  problem?: string;
  bytes: number;
  seconds: number;
  began_at: number; // seconds since 1970
  by?: string;
  sensors: number;
  voices?: boolean; // absent at a hub of an earlier version
}

export interface RecordingList {
  recordings: KeptRecording[]; // newest first
  left_out: number; // older ones
  unread: number; // files that the hub is still reading
}

export class RecordingsApi {
  constructor(
    private readonly api: HubApi,
    readonly room: () => string,
  ) {}

  list(): Promise<RecordingList> {
    return this.api.ask('GET', `/rooms/${encodeURIComponent(this.room())}/recordings`);
  }

  /** The address at which the browser gets the file, once. */
  async downloadAddress(name: string): Promise<string> {
    const { address } = await this.api.ask<{ address: string }>('POST', `${this.path(name)}/download`);
    return `api/v1/${address}`;
  }

  rename(name: string, to: string): Promise<KeptRecording> {
    return this.api.ask('PATCH', this.path(name), { name: to });
  }

  remove(name: string): Promise<void> {
    return this.api.ask('DELETE', this.path(name));
  }

  private path(name: string): string {
    return `/rooms/${encodeURIComponent(this.room())}/recordings/${encodeURIComponent(name)}`;
  }
}
