// SPDX-License-Identifier: Apache-2.0
// The worker: one hub connection, one decoder per sensor, newest frame sets to the page.
import { colorDecoderConfig } from '../codec/color_decoder';
import { CodecModule } from '../codec/codec_module';
import { wasmBytes } from '../codec/wasm_bytes';
import type { FromWorker, ToWorker } from './protocol';
import { problemTexts } from '../texts';
import { RoomStream } from './room_stream';
import codecUrl from 'roomcast_codec.wasm?url';
import plainCodecUrl from 'roomcast_codec_plain.wasm?url';

interface WorkerPort {
  postMessage(message: FromWorker, transfer?: Transferable[]): void;
  onmessage: ((event: MessageEvent<ToWorker>) => void) | null;
}

const port = self as unknown as WorkerPort;

async function main(): Promise<void> {
  const room = new RoomStream((message, transfer) => port.postMessage(message, transfer));
  port.onmessage = ({ data }) => room.handle(data);
  try {
    room.begin(await CodecModule.load(await wasmBytes(codecUrl, plainCodecUrl)), await colorDecoderConfig(512, 424));
  } catch (error) {
    const reason = (error as Error).message;
    port.postMessage({
      kind: 'broken',
      sentence: problemTexts.noDecoder(reason),
    });
  }
}

void main();
