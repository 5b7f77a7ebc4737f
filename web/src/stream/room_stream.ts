// SPDX-License-Identifier: Apache-2.0
// Main class of the worker: follows the roster, decodes every sensor's frames, and offers the newest frame sets to the
// page.
import type { CodecModule } from '../codec/codec_module';
import type { Intrinsics, Roster, UnseenSensors } from '../gen/control_pb';
import { silence, type HeardPacket, type SpokenPacket } from '../voice/voice_packet';
import type { AudioHeader } from '../wire/audio_header';
import { roomRoster } from '../room_roster';
import type { FrameHeader } from '../wire/frame_header';
import { problemTexts } from '../texts';
import { BufferPool } from './buffer_pool';
import { crc32 } from './crc32';
import { FrameMailbox } from './frame_mailbox';
import { FrameSetAssembly } from './frame_set_assembly';
import { HubConnection } from './hub_connection';
import { LateQueue } from './late_queue';
import { MotionFinder } from './motion_finder';
import {
  buffersOf,
  pageTime_ms,
  type Body,
  type DecodedRecord,
  type FromWorker,
  type StartOptions,
  type ToWorker,
  type ViewFrame,
} from './protocol';
import type { RoomEvents, RoomSource } from './room_source';
import { SensorStream } from './sensor_stream';
import { SetPace } from './set_pace';

const statusInterval_ms = 250;
const keyRequestInterval_ms = 500; // the hub forwards requests no more often

type Post = (message: FromWorker, transfer?: Transferable[]) => void;

export class RoomStream {
  private readonly buffers = new BufferPool();
  private readonly sensors = new Map<number, SensorStream>();
  private readonly keyRequestedAt_ms = new Map<number, number>();
  private readonly sets = new FrameSetAssembly<ViewFrame>(
    (set) => this.offer(set.setId, set.frames),
    (frame) => this.recycle(frame),
  );
  private readonly mailbox = new FrameMailbox<ViewFrame>(
    (setId, frames) => this.sendFrames(setId, frames),
    (frame) => this.recycle(frame),
  );
  private codec: CodecModule | undefined;
  private color: VideoDecoderConfig | undefined;
  private options: StartOptions | undefined;
  private isOpening = false;
  private hub: RoomSource | undefined;
  private decoded: DecodedRecord[] = [];
  private voice: MessagePort | undefined;
  private hasSpoken = false; // the page knows that audio comes
  private readonly late = new LateQueue();
  private readonly motion = new MotionFinder();
  private readonly pace = new SetPace();

  constructor(private readonly post: Post) {}

  begin(codec: CodecModule, color: VideoDecoderConfig | undefined): void {
    this.codec = codec;
    this.color = color;
    this.connectWhenReady();
  }

  handle(message: ToWorker): void {
    switch (message.kind) {
      case 'start':
        this.options = message.options;
        return this.connectWhenReady();
      case 'shown':
        message.buffers.forEach((buffer) => this.buffers.giveBack(buffer));
        return this.mailbox.pageIsFree();
      case 'pose':
        return this.hub?.send({ case: 'viewerPose', value: poseMessage(message.body) });
      case 'nudge': {
        const { sensor, worldFromDepth } = message;
        return this.hub?.send({ case: 'nudge', value: { sensorId: sensor, worldFromDepth } });
      }
      case 'voice':
        return this.connectVoice(message.port);
      case 'mark':
        return this.hub?.send({ case: 'mark', value: message.mark });
      case 'removeMarks':
        return this.hub?.send({ case: 'removeMarks', value: { ids: message.ids } });
      case 'guide':
        return this.hub?.send({ case: 'guide', value: { on: message.on } });
      case 'playback':
        return this.hub?.control(message.command);
      case 'handicap':
        this.late.setDelay(message.handicap.latency_ms);
        return this.pace.set(message.handicap.fps);
      case 'rename':
        return this.hub?.rename(message.name);
      case 'motion':
        return this.motion.want(message.isWanted);
      case 'stats': {
        const { lastSetId, shownFps, latency_ms } = message;
        return this.hub?.send({ case: 'viewerStats', value: { lastSetId, shownFps, latencyMs: latency_ms } });
      }
    }
  }

  private connectWhenReady(): void {
    if (!this.codec || !this.options || this.isOpening) return;
    this.isOpening = true;
    void this.open(this.options);
  }

  private async open(options: StartOptions): Promise<void> {
    const events: RoomEvents = {
      connection: (state) => this.post({ kind: 'connection', state }),
      welcome: (welcome) => this.post({ kind: 'welcome', welcome }),
      roster: (roster) => this.follow(roster),
      poses: (poses) => this.late.put(() => this.post({ kind: 'poses', poses })),
      marks: (marks) => this.post({ kind: 'marks', marks }),
      guide: (viewer) => this.post({ kind: 'guide', viewer }),
      frame: (header, payload, isHidden) => this.late.put(() => this.push(header, payload, isHidden)),
      unseen: (sensors) => this.late.put(() => this.followUnseen(sensors)),
      setEnded: (setId) => this.late.put(() => this.sets.close(setId)),
      voices: (voices) => this.late.put(() => this.post({ kind: 'voices', voices })),
      audio: (header, payload) => this.late.put(() => this.hear(header, payload)),
      disconnected: () => {
        this.late.clear();
        this.restartSensors();
      },
      rewound: () => this.rewindSensors(),
      silenced: () => this.voice?.postMessage(silence),
      line: (viewer, maySpeak) => this.post({ kind: 'line', viewer, maySpeak }),
      playback: (state) => this.post({ kind: 'playback', state }),
    };
    const source = await this.sourceFor(options, events);
    this.hub = source;
    source.connect();
    setInterval(() => this.reportStatus(source), statusInterval_ms);
  }

  /** What plays recordings is loaded only for that. */
  private async sourceFor(options: StartOptions, events: RoomEvents): Promise<RoomSource> {
    if (!options.playback) return new HubConnection(options, events);
    const { RecordingPlayer } = await import('../playback/recording_player');
    return new RecordingPlayer(options, options.playback, events);
  }

  private connectVoice(port: MessagePort): void {
    this.voice = port;
    port.onmessage = ({ data }: MessageEvent<SpokenPacket>) => {
      this.hub?.sendAudio(data.capture_ms, data.ends, data.payload);
    };
  }

  private hear({ speaker, seq, capture_ns, ends }: AudioHeader, payload: Uint8Array): void {
    if (this.voice) {
      const packet: HeardPacket = { speaker, seq, capture_ms: Number(capture_ns) / 1e6, ends, payload };
      this.voice.postMessage(packet);
    } else if (!this.hasSpoken) {
      this.hasSpoken = true;
      this.post({ kind: 'spoken' });
    }
  }

  private follow(roster: Roster): void {
    const listed = new Set(roster.sensors.map((entry) => entry.id));
    for (const [id, stream] of this.sensors) {
      if (!listed.has(id)) this.remove(id, stream);
    }
    for (const { id, calibration } of roster.sensors) {
      const lens = calibration!.depth!;
      const stream = this.sensors.get(id);
      if (stream?.hasLens(lens)) continue;
      if (stream) this.remove(id, stream);
      this.add(id, lens);
    }
    this.post({ kind: 'roster', roster: roomRoster(roster) });
  }

  private followUnseen({ baseOnly, paused, heldBack }: UnseenSensors): void {
    const incomplete = new Set([...baseOnly, ...paused, ...heldBack]);
    for (const [id, stream] of this.sensors) {
      stream.expectGaps(incomplete.has(id));
      stream.traffic.isHeldBack = heldBack.includes(id);
    }
    this.post({ kind: 'unseen', paused });
  }

  private add(id: number, lens: Intrinsics): void {
    const { codec, buffers, motion } = this;
    const color = this.color && { ...this.color, codedWidth: lens.width, codedHeight: lens.height };
    const stream = new SensorStream(
      id,
      lens,
      { codec: codec!, color, buffers, motion },
      {
        decoded: (header, depth_mm) => this.options!.record && this.record(header, depth_mm),
        settled: (setId, frame) => this.sets.settle(setId, frame),
        keyFrameNeeded: (sensor) => this.requestKeyFrame(sensor),
      },
    );
    this.sensors.set(id, stream);
  }

  private remove(id: number, stream: SensorStream): void {
    this.sensors.delete(id);
    stream.destroy();
  }

  private restartSensors(): void {
    this.sensors.forEach((stream) => stream.restart());
    this.sets.clear();
  }

  private rewindSensors(): void {
    this.sensors.forEach((stream) => stream.rewind());
    this.sets.clear();
    this.mailbox.clear();
  }

  private push(header: FrameHeader, payload: Uint8Array, isHidden = false): void {
    const stream = this.sensors.get(header.sensor);
    if (!stream) return; // the sensor has left the roster
    if (!isHidden) this.sets.arrive(header.setId, header.last);
    stream.push(header, payload, isHidden);
  }

  /** The bytes as little-endian u16, which is the memory layout on every machine that runs a browser. */
  private record({ sensor, seq, setId, capture_ns }: FrameHeader, depth_mm: Uint16Array): void {
    const bytes = new Uint8Array(depth_mm.buffer, depth_mm.byteOffset, depth_mm.byteLength);
    this.decoded.push({ sensor, seq, setId, capture_ns, depthCrc32: crc32(bytes) });
  }

  /** Sets that are too many are decoded, because later ones need them, and not shown. */
  private offer(setId: bigint, frames: ViewFrame[]): void {
    if (this.pace.takes(performance.now())) this.mailbox.put(setId, frames);
    else frames.forEach((frame) => this.recycle(frame));
  }

  private requestKeyFrame(sensor: number): void {
    const now = performance.now();
    const before = this.keyRequestedAt_ms.get(sensor);
    if (before !== undefined && now - before < keyRequestInterval_ms) return;
    this.keyRequestedAt_ms.set(sensor, now);
    this.hub?.send({ case: 'keyRequest', value: { sensorId: sensor } });
  }

  private sendFrames(setId: bigint, frames: ViewFrame[]): void {
    const pixels = frames.flatMap(buffersOf);
    this.post({ kind: 'frames', setId, frames, decodedAt_ms: pageTime_ms() }, pixels);
  }

  private recycle(frame: ViewFrame): void {
    buffersOf(frame).forEach((buffer) => this.buffers.giveBack(buffer));
  }

  private reportStatus(hub: RoomSource): void {
    const estimate = hub.clock.estimate();
    const clock = estimate && {
      roomFromPage_ms: estimate.offset_ms - performance.timeOrigin,
      error_ms: estimate.error_ms,
    };
    const sensors = [...this.sensors.values()].map((stream) => stream.traffic);
    const noColor = self.isSecureContext ? problemTexts.noColor : problemTexts.noColorInsecure;
    const colorProblem = this.color ? '' : noColor;
    const { decoded } = this;
    this.decoded = [];
    const { received_bytes } = hub;
    this.post({ kind: 'status', status: { clock, received_bytes, sensors, decoded, colorProblem } });
  }
}

/** Hands that are not tracked, and a pointer that is off, are left out of the message. */
function poseMessage({ head, leftHand, rightHand, pointer, view }: Body) {
  const angles = view && { viewHalfAngle: view.halfAngle, viewHalfWidth: view.halfWidth, viewHalfHeight: view.halfHeight };
  return { head, ...angles, ...(leftHand && { leftHand }), ...(rightHand && { rightHand }), ...(pointer && { pointer }) };
}
