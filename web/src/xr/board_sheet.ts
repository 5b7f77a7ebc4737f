// SPDX-License-Identifier: Apache-2.0
// What a board in the headset shows: words and rows of buttons. `SheetHolder` is what somebody else (a study) has to say
// to the wearer; it comes before the headset's own panel.

export interface BoardButton {
  id: string;
  text: string;
  isOn?: boolean; // chosen, or switched on
}

export interface BoardRow {
  text?: string;
  buttons: BoardButton[];
}

export interface BoardSheet {
  title: string;
  words: string[];
  rows: BoardRow[];
  press(id: string): void;
}

export class SheetHolder {
  private read: (() => BoardSheet | undefined) | undefined;
  private readBar: (() => BoardSheet | undefined) | undefined;

  /** `read` is called for each picture; undefined: nothing to say. */
  show(read: (() => BoardSheet | undefined) | undefined): void {
    this.read = read;
  }

  /** Likewise, for what is shown beside the room while one is in it. */
  showBar(read: (() => BoardSheet | undefined) | undefined): void {
    this.readBar = read;
  }

  get bar(): BoardSheet | undefined {
    return this.readBar?.();
  }

  get sheet(): BoardSheet | undefined {
    return this.read?.();
  }
}
