// SPDX-License-Identifier: Apache-2.0
// Plays a recording together with others: tells the hub where this person stands and what they want, shows where the
// others stand, and follows what they want (docs/spec/playback.md).
import type { Pose, ViewerEntry, ViewerPose } from '../gen/control_pb';
import { hexText } from '../hex_text';
import { playbackTexts as texts } from '../recording_texts';
import { fellowOf, silentFellowOf } from '../voice/fellow_speaker';
import type { PlainPose, PlaybackCommand, PlaybackState } from '../stream/protocol';

const askEvery_ms = 200;
const far_s = 2; // from the others: then it seeks
const rest_ms = 10_000; // between two such seeks, for a page that is too slow
const near_s = 0.3; // a seek that nobody would notice
const colors = [0xe69f00, 0x56b4e9, 0x009e73, 0xf0e442, 0xcc79a7, 0xd55e00];

export interface Playing {
  position_s: number;
  paused: boolean;
  speed: number;
}

export interface PartyAnswer {
  people: { id: number; viewer?: number; name: string; head: number[] }[];
  change: number;
  by: string;
  own: boolean;
  playing: Playing;
}

export interface Self {
  name: string;
  head: PlainPose;
  viewer: number; // by which the others know one's voice; 0: they hear nothing
}

export interface TogetherEvents {
  self(): Self;
  people(viewers: ViewerEntry[], poses: ViewerPose[]): void;
  control(command: PlaybackCommand): void;
}

/** `isLast`: the page goes away, and nobody waits for the answer. */
export type AskParty = (body: object, isLast?: boolean) => Promise<PartyAnswer>;

export class Together {
  names: string[] = [];
  private readonly key = hexText(crypto.getRandomValues(new Uint8Array(16)));
  private wants: Playing | undefined; // of this person, not told yet
  private change = 0; // the last one that is known here
  private state: PlaybackState | undefined;
  private soughtAt_ms = -Infinity;
  private isOn = true;

  constructor(
    private readonly ask: AskParty,
    private readonly events: TogetherEvents,
    private readonly now_ms: () => number = () => performance.now(),
  ) {}

  /** Off: this person plays it alone, and sees nobody. */
  setOn(isOn: boolean): void {
    this.isOn = isOn;
    this.events.control({ isTogether: isOn });
    this.wants = undefined;
    this.change = 0;
    if (isOn) return;
    this.leave();
    this.showOthers([]);
  }

  private leave(): void {
    void this.ask({ ...this.body(), leaves: true }, true).catch(() => undefined);
  }

  private body() {
    const { name, head, viewer } = this.events.self();
    const { x, y, z, qx, qy, qz, qw } = head;
    return { key: this.key, name, viewer, head: [x, y, z, qx, qy, qz, qw] };
  }

  begin(): void {
    this.events.control({ isTogether: true });
    window.addEventListener('pagehide', () => this.leave());
    const again = () => void this.visit().finally(() => setTimeout(again, askEvery_ms));
    again();
  }

  show(state: PlaybackState): void {
    this.state = state;
  }

  /** This person has done something. */
  wanted({ seek_s, paused, speed }: PlaybackCommand): void {
    const { state } = this;
    if (!state || (seek_s === undefined && paused === undefined && speed === undefined)) return;
    const before = this.wants ?? state;
    this.wants = { position_s: seek_s ?? before.position_s, paused: paused ?? before.paused, speed: speed ?? before.speed };
  }

  /** A hub that does not answer, or is of an earlier version, leaves this person alone. */
  async visit(): Promise<void> {
    if (!this.state || !this.isOn) return;
    const { wants } = this;
    const answer = await this.ask({ ...this.body(), ...(wants && { wants }) }).catch(() => undefined);
    if (!this.isOn) return;
    if (!answer) return this.showOthers([]);
    if (this.wants === wants) this.wants = undefined;
    this.showOthers(answer.people);
    this.follow(answer);
  }

  private showOthers(people: PartyAnswer['people']): void {
    this.names = people.map(({ id, name }) => name || texts.somebody(id));
    this.events.people(people.map(entryOf), people.map(poseOf));
  }

  private follow({ change, own, playing }: PartyAnswer): void {
    const isNew = change !== this.change;
    this.change = change;
    if (change === 0 || this.wants || !this.state) return;
    const { length_s, loops, position_s, paused, speed, isWaiting } = this.state;
    const goal_s = loops && length_s > 0 ? playing.position_s % length_s : Math.min(playing.position_s, length_s);
    const off_s = Math.abs(goal_s - position_s);
    if (isNew && !own) {
      const seek = off_s > near_s ? { seek_s: goal_s } : {};
      const isOther = playing.paused !== paused || playing.speed !== speed;
      if (isOther || off_s > near_s) this.events.control({ ...seek, paused: playing.paused, speed: playing.speed });
      return;
    }
    const atEnd = playing.position_s >= length_s;
    const mayAgain = this.now_ms() - this.soughtAt_ms > rest_ms;
    if (own || atEnd || isWaiting || playing.paused || off_s < far_s || !mayAgain) return;
    this.soughtAt_ms = this.now_ms();
    this.events.control({ seek_s: goal_s });
  }
}

type Person = PartyAnswer['people'][number];

// As from a roster. They are written out because Protobuf’s own functions would be loaded with every page.

function idOf({ id, viewer = 0 }: Person): number {
  return viewer > 0 ? fellowOf(viewer) : silentFellowOf(id);
}

function entryOf(person: Person): ViewerEntry {
  const { id, name } = person;
  const shown = texts.withYou(name || texts.somebody(id));
  const usual = { hubsAway: 0, through: 0, relays: false, records: false, recordsVoices: false };
  return { $typeName: 'roomcast.wire.pb.ViewerEntry', id: idOf(person), name: shown, colorRgb: colors[id % colors.length]!, ...usual };
}

function poseOf(person: Person): ViewerPose {
  const [x, y, z, qx, qy, qz, qw] = person.head;
  const head: Pose = { $typeName: 'roomcast.wire.pb.Pose', x: x!, y: y!, z: z!, qx: qx!, qy: qy!, qz: qz!, qw: qw! };
  return { $typeName: 'roomcast.wire.pb.ViewerPose', viewerId: idOf(person), head, viewHalfAngle: 0, viewHalfWidth: 0, viewHalfHeight: 0 };
}
