// SPDX-License-Identifier: Apache-2.0
// A list on the screen that follows a list of items: an item with the same key keeps its element, so that the keyboard's
// focus, and what a screen reader is at, survive newcomers and news.

export interface Row<Item> {
  root: HTMLElement;
  update(item: Item): void;
}

export class KeyedList<Item, ItemRow extends Row<Item> = Row<Item>> {
  private readonly rows = new Map<string, ItemRow>();

  /** `make` need not fill the row: `update` follows. `empty` is shown where there are no items. */
  constructor(
    private readonly root: HTMLElement,
    private readonly keyOf: (item: Item) => string,
    private readonly make: (item: Item) => ItemRow,
    private readonly empty?: HTMLElement,
  ) {}

  get shown(): Iterable<ItemRow> {
    return this.rows.values();
  }

  show(items: readonly Item[]): void {
    const keys = items.map(this.keyOf);
    for (const [key, { root }] of this.rows) {
      if (keys.includes(key)) continue;
      root.remove();
      this.rows.delete(key);
    }
    items.forEach((item, i) => this.place(keys[i]!, item, i));
    if (items.length > 0) this.empty?.remove();
    else if (this.empty) this.root.append(this.empty);
  }

  /** Elements that stay in order are not moved: moving one takes the focus from it. */
  private place(key: string, item: Item, index: number): void {
    let row = this.rows.get(key);
    if (!row) this.rows.set(key, (row = this.make(item)));
    const there = this.root.children[index];
    if (there !== row.root) this.root.insertBefore(row.root, there ?? null);
    row.update(item);
  }
}
