// SPDX-License-Identifier: Apache-2.0
// A room as a layer of another three.js scene: connects as a viewer and draws each sensor's surface by itself. What the
// page draws besides (blended surfaces, people, marks) is not in it.
import * as THREE from 'three';
import type { RoomRoster } from '../src/room_roster';
import { RoomLink } from '../src/stream/room_link';
import type { FromWorker, ViewFrame } from '../src/stream/protocol';
import { PlacedSensor } from '../src/view/placed_sensor';
import type { RoomLayer as Layer, RoomLayerOptions, RoomLayerState } from './room-layer';

const authorKeyBytes = 16;

export function layerSocket(hub: string): string {
  const url = new URL('/ws', hub);
  url.protocol = url.protocol === 'https:' ? 'wss:' : 'ws:';
  return url.href;
}

export class RoomLayer extends THREE.Group implements Layer {
  private readonly link: RoomLink;
  private readonly placed = new Map<number, PlacedSensor>();
  private readonly mode: 'mesh' | 'points';
  private readonly step: number;
  private waiting: ViewFrame[] = []; // for the next picture
  private drawn: ViewFrame[] = []; // their pixels go back to the worker
  private known: RoomLayerState = { phase: 'connecting', sentence: '', sensors: [], people: 0, sets: 0 };

  constructor(private readonly options: RoomLayerOptions) {
    super();
    const { hub, room, token = '', name = '', mode = 'mesh', step = 1 } = options;
    this.mode = mode;
    this.step = step;
    const authorKey = crypto.getRandomValues(new Uint8Array(authorKeyBytes));
    const access = { room, code: '', token };
    this.link = new RoomLink(
      { socketUrl: layerSocket(hub), room, name, record: false, hears: false, access, authorKey },
      (message) => this.receive(message),
    );
  }

  get state(): RoomLayerState {
    return this.known;
  }

  update(renderer: THREE.WebGLRenderer, camera: THREE.Camera): void {
    if (this.drawn.length) this.link.shown(this.drawn.splice(0));
    const pixels = renderer.getDrawingBufferSize(new THREE.Vector2()).y * camera.projectionMatrix.elements[5] * 0.5;
    this.placed.forEach(({ surface }) => surface.setPixelsPerUnit(pixels));
    if (!this.waiting.length) return;
    this.drawn = this.waiting.splice(0);
    for (const frame of this.drawn) this.show(frame, renderer);
    this.become({ sets: this.known.sets + 1 });
  }

  dispose(): void {
    this.link.end();
    this.follow({ sensors: [], viewers: [] });
    this.removeFromParent();
  }

  private receive(message: FromWorker): void {
    if (message.kind === 'connection') {
      const { phase, sentence } = message.state;
      this.become({ phase, sentence });
    } else if (message.kind === 'broken') this.become({ phase: 'broken', sentence: message.sentence });
    else if (message.kind === 'roster') this.follow(message.roster);
    else if (message.kind === 'frames') this.waiting.push(...message.frames);
  }

  private follow({ sensors, viewers }: RoomRoster): void {
    const listed = new Set(sensors.map(({ id }) => id));
    for (const [id, placed] of this.placed) {
      if (!listed.has(id)) this.take(id, placed);
    }
    for (const entry of sensors) {
      const before = this.placed.get(entry.id);
      if (before?.entry.name === entry.name) before.follow(entry, true);
      else {
        if (before) this.take(entry.id, before);
        this.put(entry.id, new PlacedSensor(entry, false));
      }
    }
    const online = sensors.filter((sensor) => sensor.online).map(({ name }) => name);
    this.become({ sensors: online, people: viewers.length });
  }

  private put(id: number, placed: PlacedSensor): void {
    placed.follow(placed.entry, true);
    placed.surface.setKind(this.mode);
    placed.setStep(this.step);
    placed.updateVisible('apart');
    this.placed.set(id, placed);
    this.add(placed.surface.root);
  }

  private take(id: number, placed: PlacedSensor): void {
    this.placed.delete(id);
    this.remove(placed.surface.root);
    placed.dispose();
  }

  private show(frame: ViewFrame, renderer: THREE.WebGLRenderer): void {
    const placed = this.placed.get(frame.sensor);
    if (placed?.pictures.lens.width !== frame.width || placed.pictures.lens.height !== frame.height) return;
    placed.pictures.show(frame, renderer);
    placed.updateVisible('apart');
  }

  private become(changes: Partial<RoomLayerState>): void {
    this.known = { ...this.known, ...changes };
    this.options.onState?.(this.known);
  }
}
