// SPDX-License-Identifier: Apache-2.0
// Whether a page of another site shows this one in a frame. What it does there could be steered by that site, so it has
// no console, and uses no token that was given to another page of this tab.
import type { Store } from '../storage';

export function isFramed(): boolean {
  return window.parent !== window;
}

/** The tab's storage. Throws in a frame, as where the browser blocks it. */
export function visitStorage(): Store {
  if (isFramed()) throw new Error('a page in a frame keeps nothing');
  return sessionStorage;
}

/** Classes of the page for its style sheets. */
export function dressPage(controls: boolean): void {
  document.documentElement.classList.toggle('bare', !controls);
  document.documentElement.classList.toggle('framed', isFramed());
}
