// SPDX-License-Identifier: Apache-2.0
// Detects software rendering, as far as the browser reveals it.

const softwareNames = /swiftshader|llvmpipe|softpipe|software|basic render/i;

export function drawsInSoftware(gl: WebGL2RenderingContext): boolean {
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  return softwareNames.test(String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER)));
}
