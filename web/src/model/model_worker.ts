// SPDX-License-Identifier: Apache-2.0
// The worker that decodes the room's model, so that the page goes on drawing meanwhile.
import { decodePiece, loadDecoder, type ModelGeometry } from './draco_decoder';
import { readModelMessage } from './model_message';

/** What the page gets for each answer of the hub. */
export interface DecodedModel {
  isWhole: boolean;
  version: bigint;
  pieces: { key: string; geometry: ModelGeometry | undefined }[]; // undefined: there is none there any more
}
export type FromModelWorker = DecodedModel | { problem: string };

const decoder = loadDecoder();

async function decode(bytes: ArrayBuffer): Promise<void> {
  const module = await decoder;
  const { isWhole, version, pieces } = readModelMessage(bytes);
  const decoded = pieces.map(({ key, draco }) => ({
    key,
    geometry: draco.length === 0 ? undefined : decodePiece(module, draco),
  }));
  const buffers = decoded.flatMap(({ geometry }) =>
    geometry ? [geometry.positions.buffer, geometry.colors.buffer, geometry.indices.buffer] : [],
  );
  const message: FromModelWorker = { isWhole, version, pieces: decoded };
  (self as unknown as Worker).postMessage(message, buffers as ArrayBuffer[]);
}

self.onmessage = ({ data }: MessageEvent<ArrayBuffer>) => {
  decode(data).catch((error: unknown) => self.postMessage({ problem: String(error) } satisfies FromModelWorker));
};
