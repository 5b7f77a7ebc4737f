// SPDX-License-Identifier: Apache-2.0
// Voice in the page: the microphone to the hub, and the people who speak to the ear. The sound itself goes from worker to
// AudioWorklet past the page's own thread; this class makes the connections and knows what is on.
import type { Store } from '../storage';
import type { PlainPose } from '../stream/protocol';
import { voiceTexts as texts } from '../texts';
import { Microphone, type MicrophoneDevice } from './microphone';
import { microphoneFault, soundSupport, speakingObstacle, type Rights } from './obstacle';
import type { FromVoiceWorker, ToVoiceWorker } from './protocol';
import { Speakers } from './speakers';
import type { TalkMode } from './talk_gate';
import { encoderConfig } from './voice_encoder';
import { sampleRate_hz } from './voice_packet';
import workletUrl from './worklet?worker&url';

const placing_ms = 50;

/** What the page knows of heads; metres, world frame. */
export interface Heads {
  own(): PlainPose;
  of(speaker: number): PlainPose | undefined;
}

export interface VoiceParts {
  heads: Heads;
  store: Store;
  /** Connects the voice worker with the worker that owns the socket. */
  connectHub(port: MessagePort): void;
}

export interface VoiceEvents {
  /** Something to be shown has changed. */
  changed(): void;
  level(loudness: number): void;
}

export class Voice {
  readonly speakers: Speakers;
  isOn = false; // the microphone
  isSending = false; // what it records, at the moment
  isPushed = false;
  mode: TalkMode = 'voice';
  problem = ''; // why the microphone is off although it was wanted
  devices: MicrophoneDevice[] = [];
  private rights: Rights = { maySpeak: false, isMuted: false };
  private readonly microphone: Microphone;
  private readonly worker = new Worker(new URL('./voice_worker.ts', import.meta.url), { type: 'module', name: 'voice' });

  private constructor(
    readonly context: AudioContext,
    private readonly master: GainNode,
    private readonly parts: VoiceParts,
    private readonly events: VoiceEvents,
  ) {
    this.speakers = new Speakers(context, master);
    this.microphone = new Microphone(context, parts.store, () => this.lost());
    this.worker.onmessage = ({ data }: MessageEvent<FromVoiceWorker>) => this.receive(data);
    const { port1, port2 } = new MessageChannel();
    parts.connectHub(port1);
    this.tell({ kind: 'hub', port: port2 }, [port2]);
    setInterval(() => this.place(), placing_ms);
    context.onstatechange = () => this.events.changed();
    this.resumeOnGesture();
  }

  /** Rejects where the browser cannot play sound. */
  static async open(parts: VoiceParts, events: VoiceEvents): Promise<Voice> {
    const context = new AudioContext({ sampleRate: sampleRate_hz, latencyHint: 'interactive' });
    await context.audioWorklet.addModule(workletUrl);
    const master = new GainNode(context);
    master.connect(context.destination);
    return new Voice(context, master, parts, events);
  }

  /** Why this user cannot speak; empty if nothing is in the way. */
  get obstacle(): string {
    return speakingObstacle(soundSupport(), this.rights);
  }

  /** Browsers play no sound before the user has done something. */
  get awaitsGesture(): boolean {
    return this.context.state !== 'running';
  }

  get isHearing(): boolean {
    return this.master.gain.value > 0;
  }

  get deviceId(): string {
    return this.microphone.deviceId;
  }

  setRights(rights: Rights): void {
    this.rights = rights;
    if (this.isOn && this.obstacle) this.turnOff();
    this.events.changed();
  }

  hearOthers(wanted: boolean): void {
    this.master.gain.value = wanted ? 1 : 0;
    this.events.changed();
  }

  async toggleMicrophone(): Promise<void> {
    if (this.isOn) this.turnOff();
    else await this.turnOn();
  }

  async choose(deviceId: string): Promise<void> {
    await this.turnOn(deviceId);
  }

  setMode(mode: TalkMode): void {
    this.mode = mode;
    this.tellTalk();
  }

  /** The key or the button for push to talk. */
  push(isPushed: boolean): void {
    if (isPushed === this.isPushed) return;
    this.isPushed = isPushed;
    this.tellTalk();
  }

  /** The people and sensors in the room have changed: these may be heard. */
  follow(speakers: readonly number[]): void {
    const present = new Set(speakers);
    for (const id of this.speakers.ids) {
      if (present.has(id)) continue;
      this.speakers.remove(id);
      this.tell({ kind: 'gone', speaker: id });
    }
  }

  private async turnOn(deviceId?: string): Promise<void> {
    this.problem = '';
    try {
      if (this.obstacle) return;
      const { supported } = await AudioEncoder.isConfigSupported(encoderConfig);
      if (!supported) throw new Error(texts.noEncoder);
      void this.context.resume();
      const port = await this.microphone.open(deviceId);
      this.isOn = true;
      this.tell({ kind: 'microphone', port }, [port]);
      this.tellTalk();
      this.devices = await this.microphone.devices();
    } catch (error) {
      this.problem = error instanceof DOMException ? microphoneFault(error) : (error as Error).message;
    } finally {
      this.events.changed();
    }
  }

  private turnOff(): void {
    this.isOn = this.isSending = false;
    this.tellTalk();
    this.microphone.close();
    this.events.level(0);
    this.events.changed();
  }

  private lost(): void {
    this.turnOff();
    this.problem = texts.lost;
    this.events.changed();
  }

  private receive(message: FromVoiceWorker): void {
    switch (message.kind) {
      case 'speaks': {
        const port = this.speakers.add(message.speaker);
        this.place();
        return this.tell({ kind: 'player', speaker: message.speaker, port }, [port]);
      }
      case 'level': {
        if (!this.isOn) return;
        const changes = message.isSent !== this.isSending;
        this.isSending = message.isSent;
        this.events.level(message.loudness);
        if (changes) this.events.changed();
        return;
      }
      case 'fault':
        if (this.isOn) this.turnOff();
        this.problem = texts.failed(message.sentence);
        return this.events.changed();
    }
  }

  private place(): void {
    if (this.speakers.ids.length > 0) this.speakers.place(this.parts.heads.own(), (id) => this.parts.heads.of(id));
  }

  private resumeOnGesture(): void {
    for (const kind of ['pointerdown', 'keydown'] as const) {
      window.addEventListener(kind, () => this.awaitsGesture && void this.context.resume(), { capture: true });
    }
  }

  private tellTalk(): void {
    const { mode, isPushed, isOn } = this;
    this.tell({ kind: 'talk', mode, isPushed, isOn });
    this.events.changed();
  }

  private tell(message: ToVoiceWorker, transfer: Transferable[] = []): void {
    this.worker.postMessage(message, transfer);
  }
}
