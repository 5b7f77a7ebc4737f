// SPDX-License-Identifier: Apache-2.0
// The microphone: asks for it, with the browser's echo cancellation, and passes its samples to the voice worker.
import type { Store } from '../storage';

const storeKey = 'roomcast.microphone';
const lastBlocks_ms = 100; // after turning it off, so that the packet that ends is sent

export interface MicrophoneDevice {
  id: string;
  label: string;
}

export class Microphone {
  private stream: MediaStream | undefined;
  private source: MediaStreamAudioSourceNode | undefined;
  private node: AudioWorkletNode | undefined;

  constructor(
    private readonly context: AudioContext,
    private readonly store: Store,
    /** It was unplugged, or the permission was withdrawn. */
    private readonly lost: () => void,
  ) {}

  get deviceId(): string {
    return this.stream?.getAudioTracks()[0]?.getSettings().deviceId ?? '';
  }

  /** Opens it. The blocks go to the returned port. Rejects as getUserMedia does. */
  async open(deviceId = this.store.getItem(storeKey) ?? ''): Promise<MessagePort> {
    const stream = await this.ask(deviceId);
    this.close();
    this.stream = stream;
    if (deviceId) this.store.setItem(storeKey, deviceId);
    stream.getAudioTracks()[0]!.onended = this.lost;
    this.source = this.context.createMediaStreamSource(stream);
    this.node = new AudioWorkletNode(this.context, 'roomcast-microphone', { numberOfOutputs: 0, channelCount: 1 });
    this.source.connect(this.node);
    const { port1, port2 } = new MessageChannel();
    this.node.port.postMessage(port1, [port1]);
    return port2;
  }

  /** The last blocks still go out. */
  close(): void {
    const { stream, source, node } = this;
    this.stream = this.source = this.node = undefined;
    if (!stream) return;
    stream.getAudioTracks().forEach((track) => (track.onended = null));
    setTimeout(() => {
      stream.getTracks().forEach((track) => track.stop());
      node?.port.postMessage(null);
      source?.disconnect();
    }, lastBlocks_ms);
  }

  /** Names of devices are known only to a page that has been let at one. */
  async devices(): Promise<MicrophoneDevice[]> {
    const all = await navigator.mediaDevices.enumerateDevices();
    return all
      .filter(({ kind, deviceId }) => kind === 'audioinput' && deviceId !== '')
      .map(({ deviceId, label }) => ({ id: deviceId, label }));
  }

  private async ask(deviceId: string): Promise<MediaStream> {
    const wanted = { echoCancellation: true, noiseSuppression: true, autoGainControl: true, channelCount: 1 };
    try {
      const audio = deviceId ? { ...wanted, deviceId: { exact: deviceId } } : wanted;
      return await navigator.mediaDevices.getUserMedia({ audio });
    } catch (error) {
      if (!deviceId || (error as DOMException).name !== 'OverconstrainedError') throw error;
      this.store.removeItem(storeKey); // it is not there any more
      return navigator.mediaDevices.getUserMedia({ audio: wanted });
    }
  }
}
