// SPDX-License-Identifier: Apache-2.0
// The people and microphones that are heard: a player for each, at its head, with a volume of its own. Metres, world frame.
import type { PlainPose } from '../stream/protocol';
import { isFellow } from './fellow_speaker';
import type { JitterFigures } from './jitter_buffer';

const nearest_m = 1; // within it nobody is louder
const rolloff = 0.8;
const smoothing_s = 0.03;

interface Speaker {
  node: AudioWorkletNode;
  gain: GainNode;
  panner: PannerNode;
  figures: JitterFigures | undefined;
}

function glide(param: AudioParam, value: number): void {
  param.setTargetAtTime(value, 0, smoothing_s);
}

/** The direction in which a part of this pose looks (-z), and its up (y). */
function axesOf({ qx: x, qy: y, qz: z, qw: w }: PlainPose) {
  return {
    ahead: [-2 * (x * z + w * y), -2 * (y * z - w * x), -(1 - 2 * (x * x + y * y))] as const,
    up: [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)] as const,
  };
}

export class Speakers {
  private readonly speakers = new Map<number, Speaker>();
  private readonly played: GainNode; // voices of a recording
  private readonly volumes = new Map<number, number>();

  constructor(
    private readonly context: AudioContext,
    private readonly out: AudioNode,
  ) {
    this.played = new GainNode(context);
    this.played.connect(out);
  }

  /** The voices of a recording; who plays it together with this person is heard as before. */
  hearRecording(wanted: boolean): void {
    this.played.gain.value = wanted ? 1 : 0;
  }

  get ids(): number[] {
    return [...this.speakers.keys()];
  }

  figuresOf(speaker: number): JitterFigures | undefined {
    return this.speakers.get(speaker)?.figures;
  }

  /** Its packets are to be sent to the returned port. */
  add(id: number): MessagePort {
    this.remove(id);
    const { context } = this;
    const node = new AudioWorkletNode(context, 'roomcast-player', { numberOfInputs: 0, outputChannelCount: [1] });
    const gain = new GainNode(context, { gain: this.volumeOf(id) });
    const panner = new PannerNode(context, {
      panningModel: 'HRTF',
      distanceModel: 'inverse',
      refDistance: nearest_m,
      rolloffFactor: rolloff,
    });
    node.connect(gain).connect(panner).connect(isFellow(id) ? this.out : this.played);
    const speaker: Speaker = { node, gain, panner, figures: undefined };
    node.port.onmessage = ({ data }: MessageEvent<JitterFigures>) => (speaker.figures = data);
    this.speakers.set(id, speaker);
    const { port1, port2 } = new MessageChannel();
    node.port.postMessage(port1, [port1]);
    return port2;
  }

  remove(id: number): void {
    const speaker = this.speakers.get(id);
    this.speakers.delete(id);
    if (!speaker) return;
    speaker.node.port.postMessage(null);
    speaker.node.disconnect();
    speaker.panner.disconnect();
  }

  volumeOf(id: number): number {
    return this.volumes.get(id) ?? 1;
  }

  /** 1: as it is sent; 0: not heard. */
  setVolume(id: number, volume: number): void {
    this.volumes.set(id, volume);
    const gain = this.speakers.get(id)?.gain.gain;
    if (gain) glide(gain, volume);
  }

  /** Somebody without a head is heard from where the listener is. */
  place(own: PlainPose, headOf: (speaker: number) => PlainPose | undefined): void {
    this.placeListener(own);
    for (const [id, { panner }] of this.speakers) {
      const { x, y, z } = headOf(id) ?? own;
      glide(panner.positionX, x);
      glide(panner.positionY, y);
      glide(panner.positionZ, z);
    }
  }

  private placeListener(own: PlainPose): void {
    const { listener } = this.context;
    const { ahead, up } = axesOf(own);
    if (!('positionX' in listener)) {
      // Firefox has the older methods only.
      const older = listener as AudioListener;
      older.setPosition(own.x, own.y, own.z);
      older.setOrientation(...ahead, ...up);
      return;
    }
    const values: [AudioParam, number][] = [
      [listener.positionX, own.x],
      [listener.positionY, own.y],
      [listener.positionZ, own.z],
      [listener.forwardX, ahead[0]],
      [listener.forwardY, ahead[1]],
      [listener.forwardZ, ahead[2]],
      [listener.upX, up[0]],
      [listener.upY, up[1]],
      [listener.upZ, up[2]],
    ];
    values.forEach(([param, value]) => glide(param, value));
  }
}
