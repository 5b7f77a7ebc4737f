// SPDX-License-Identifier: Apache-2.0
// Reports when the graphics processor has finished all submitted work. Draw calls return long before that.

const poll_ms = 2;
const longestWait_ms = 5000; // a lost context never signals

export function whenDrawn(gl: WebGL2RenderingContext, done: () => void): void {
  const sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  if (!sync) return void setTimeout(done, poll_ms);
  gl.flush();
  const deadline = performance.now() + longestWait_ms;
  const poll = () => {
    const finished = gl.getSyncParameter(sync, gl.SYNC_STATUS) !== gl.UNSIGNALED;
    if (!finished && performance.now() < deadline && !gl.isContextLost()) return void setTimeout(poll, poll_ms);
    gl.deleteSync(sync);
    done();
  };
  setTimeout(poll, poll_ms);
}
