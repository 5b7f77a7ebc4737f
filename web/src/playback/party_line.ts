// SPDX-License-Identifier: Apache-2.0
// The voices of the people who play the same recording: a connection to the hub that carries nothing else
// (docs/spec/wire.md §6, "People who play a recording").
import { HubConnection } from '../stream/hub_connection';
import type { StartOptions } from '../stream/protocol';
import type { RoomEvents } from '../stream/room_source';
import type { ControlMessage } from '../wire/control';
import { fellowOf } from '../voice/fellow_speaker';

export type PartyEvents = Pick<RoomEvents, 'line' | 'voices' | 'audio'>;

const nothing = () => undefined;

export class PartyLine {
  private readonly hub: HubConnection;

  /** `pose`: where this person stood last. */
  constructor(options: StartOptions, recording: string, private pose: ControlMessage | undefined, events: PartyEvents) {
    this.hub = new HubConnection(
      { ...options, plays: recording },
      {
        welcome: ({ viewerId, maySpeak }) => {
          if (this.pose) this.hub.send(this.pose);
          events.line(viewerId, maySpeak);
        },
        voices: ({ speaking, muted, ...rest }) =>
          events.voices({ ...rest, speaking: speaking.map(fellowOf), muted: muted.map(fellowOf) }),
        audio: (header, payload) => events.audio({ ...header, speaker: fellowOf(header.speaker) }, payload),
        disconnected: () => events.line(0, false),
        roster: () => this.leave(), // this hub knows no recordings that are played together, and takes us for somebody in the room
        connection: nothing,
        poses: nothing,
        marks: nothing,
        guide: nothing,
        frame: nothing,
        unseen: nothing,
        setEnded: nothing,
      },
    );
    this.hub.connect();
  }

  get received_bytes(): number {
    return this.hub.received_bytes;
  }

  /** By its pose the hub knows who is near. */
  stand(pose: ControlMessage): void {
    this.pose = pose;
    this.hub.send(pose);
  }

  sendAudio(page_ms: number, ends: boolean, payload: Uint8Array): void {
    this.hub.sendAudio(page_ms, ends, payload);
  }

  rename(name: string): void {
    this.hub.rename(name);
  }

  leave(): void {
    this.hub.leave();
  }
}
