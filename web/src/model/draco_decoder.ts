// SPDX-License-Identifier: Apache-2.0
// Decodes a piece of the room's model. Google's decoder comes with three.js and is loaded with this file only. Source:
// https://github.com/google/draco, docs/spec/model.md.
import createModule from 'three/examples/jsm/libs/draco/gltf/draco_wasm_wrapper.js';
import decoderAddress from 'three/examples/jsm/libs/draco/gltf/draco_decoder.wasm?url';

export interface ModelGeometry {
  positions: Float32Array; // x, y, z; metres, world frame
  colors: Uint8Array; // red, green, blue; as on a screen
  indices: Uint32Array; // of triangles
}

/** What is used of the decoder's interface. */
interface Decoder {
  GetEncodedGeometryType(data: Int8Array): number;
  DecodeArrayToMesh(data: Int8Array, size: number, mesh: Mesh): { ok(): boolean };
  GetAttributeByUniqueId(mesh: Mesh, id: number): { ptr: number };
  GetAttributeDataArrayForAllPoints(mesh: Mesh, attribute: object, type: number, bytes: number, into: number): boolean;
  GetTrianglesUInt32Array(mesh: Mesh, bytes: number, into: number): boolean;
}
interface Mesh {
  ptr: number;
  num_faces(): number;
  num_points(): number;
}
export interface DracoModule {
  Decoder: new () => Decoder;
  Mesh: new () => Mesh;
  destroy(made: object): void;
  _malloc(bytes: number): number;
  _free(at: number): void;
  HEAPF32: Float32Array;
  HEAPU32: Uint32Array;
  DT_FLOAT32: number;
  TRIANGULAR_MESH: number;
}

const positionId = 0;
const colorId = 1;
const most = 20_000_000; // points or triangles of a piece: more are not of a room

export async function loadDecoder(): Promise<DracoModule> {
  const wasmBinary = await (await fetch(decoderAddress)).arrayBuffer();
  return createModule({ wasmBinary });
}

/** Red, green and blue from linear light, as sRGB has them. */
function screenLevel(linear: number): number {
  const level = linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;
  return Math.round(255 * Math.min(1, Math.max(0, level)));
}

/** Throws an Error for bytes that are no mesh with colours. */
export function decodePiece(module: DracoModule, draco: Uint8Array): ModelGeometry {
  const decoder = new module.Decoder();
  const mesh = new module.Mesh();
  try {
    const data = new Int8Array(draco.buffer, draco.byteOffset, draco.byteLength);
    if (decoder.GetEncodedGeometryType(data) !== module.TRIANGULAR_MESH) throw new Error('a piece is no mesh');
    const status = decoder.DecodeArrayToMesh(data, data.byteLength, mesh);
    if (!status.ok() || mesh.ptr === 0) throw new Error('a piece of the model is damaged');
    const [points, triangles] = [mesh.num_points(), mesh.num_faces()];
    if (points > most || triangles > most) throw new Error('a piece of the model is too large');
    const positions = floats(module, decoder, mesh, positionId, 3 * points);
    const colors = Uint8Array.from(floats(module, decoder, mesh, colorId, 3 * points), screenLevel);
    return { positions, colors, indices: triangleCorners(module, decoder, mesh, 3 * triangles) };
  } finally {
    module.destroy(mesh);
    module.destroy(decoder);
  }
}

function floats(module: DracoModule, decoder: Decoder, mesh: Mesh, id: number, count: number): Float32Array {
  const attribute = decoder.GetAttributeByUniqueId(mesh, id);
  if (attribute.ptr === 0) throw new Error('a piece of the model lacks places or colours');
  const at = module._malloc(4 * count);
  decoder.GetAttributeDataArrayForAllPoints(mesh, attribute, module.DT_FLOAT32, 4 * count, at);
  const values = module.HEAPF32.slice(at / 4, at / 4 + count);
  module._free(at);
  return values;
}

function triangleCorners(module: DracoModule, decoder: Decoder, mesh: Mesh, count: number): Uint32Array {
  const at = module._malloc(4 * count);
  decoder.GetTrianglesUInt32Array(mesh, 4 * count, at);
  const corners = module.HEAPU32.slice(at / 4, at / 4 + count);
  module._free(at);
  return corners;
}
