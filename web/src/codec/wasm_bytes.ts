// SPDX-License-Identifier: Apache-2.0
// A WebAssembly module from the page's server.

async function fetchModule(url: string): Promise<ArrayBuffer> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`the server answered ${response.status}`);
  return response.arrayBuffer();
}

/** The module with SIMD, or the plain one where the browser's WebAssembly has no SIMD. */
export async function wasmBytes(url: string, plainUrl: string): Promise<ArrayBuffer> {
  const fast = await fetchModule(url);
  return WebAssembly.validate(fast) ? fast : fetchModule(plainUrl);
}
