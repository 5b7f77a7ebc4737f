// SPDX-License-Identifier: Apache-2.0
// Loaded with its module only when motion is wanted (stream/motion_finder.ts).
import flowUrl from 'roomcast_flow.wasm?url';
import plainFlowUrl from 'roomcast_flow_plain.wasm?url';
import { SceneFlowModule } from './scene_flow_module';
import { wasmBytes } from './wasm_bytes';

export { SceneFlow } from './scene_flow_module';

export async function loadSceneFlow(): Promise<SceneFlowModule> {
  return SceneFlowModule.load(await wasmBytes(flowUrl, plainFlowUrl));
}
