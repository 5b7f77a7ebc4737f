// SPDX-License-Identifier: Apache-2.0
// Dark or light theme: the system's setting, or the user's choice, which is stored in this browser.
import { keptIn } from './storage';

export const themes = ['auto', 'dark', 'light'] as const;
export type Theme = (typeof themes)[number];

const storeKey = 'roomcast.theme';

export class Look {
  private chosen: Theme;
  private readonly store = keptIn(() => localStorage).store;
  private readonly system = matchMedia('(prefers-color-scheme: light)');

  constructor(private readonly changed: (isLight: boolean) => void) {
    this.chosen = themes.find((theme) => theme === this.store.getItem(storeKey)) ?? 'auto';
    this.system.addEventListener('change', () => this.apply());
  }

  get theme(): Theme {
    return this.chosen;
  }

  choose(theme: Theme): void {
    this.chosen = theme;
    this.store.setItem(storeKey, theme);
    this.apply();
  }

  apply(): void {
    const isLight = this.chosen === 'light' || (this.chosen === 'auto' && this.system.matches);
    document.documentElement.dataset.theme = isLight ? 'light' : 'dark';
    this.changed(isLight);
  }
}
