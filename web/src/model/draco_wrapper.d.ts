// SPDX-License-Identifier: Apache-2.0
// The script that starts Google's decoder, as three.js has it.
declare module 'three/examples/jsm/libs/draco/gltf/draco_wasm_wrapper.js' {
  import type { DracoModule } from './draco_decoder';
  export default function createModule(options: { wasmBinary: ArrayBuffer }): Promise<DracoModule>;
}
declare module '*.wasm?url' {
  const address: string;
  export default address;
}
