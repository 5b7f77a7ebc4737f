// SPDX-License-Identifier: Apache-2.0
// Paints single VP9 key frames, small, on canvases. One at a time.

const width = 144; // of a picture, for twice the size in which it is shown

export class KeyFramePainter {
  private readonly decoder: VideoDecoder;
  private newest: VideoFrame | undefined;

  constructor() {
    this.decoder = new VideoDecoder({
      output: (frame) => {
        this.newest?.close();
        this.newest = frame;
      },
      error: () => undefined, // flush() rejects
    });
  }

  /** Whether this browser can do it. */
  static get isPossible(): boolean {
    return typeof VideoDecoder !== 'undefined';
  }

  /** False: it cannot be decoded. */
  async paint(vp9: Uint8Array, canvas: HTMLCanvasElement): Promise<boolean> {
    try {
      if (this.decoder.state === 'unconfigured') this.decoder.configure({ codec: 'vp09.00.10.08' });
      this.decoder.decode(new EncodedVideoChunk({ type: 'key', timestamp: 0, data: vp9 }));
      await this.decoder.flush();
    } catch {
      return false;
    }
    const frame = this.newest;
    this.newest = undefined;
    if (!frame) return false;
    const { displayWidth, displayHeight } = frame;
    Object.assign(canvas, { width, height: Math.round((width * displayHeight) / displayWidth) });
    canvas.getContext('2d')!.drawImage(frame, 0, 0, canvas.width, canvas.height);
    frame.close();
    return true;
  }

  close(): void {
    if (this.decoder.state !== 'closed') this.decoder.close();
  }
}
