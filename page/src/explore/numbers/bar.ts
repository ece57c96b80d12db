// The address bar follows the state, but not every step at once: browsers refuse pages that change
// their address hundreds of times in ten seconds.

import { toAddress } from "./address.js";
import type { State } from "../protocol.js";

const INTERVAL_MS = 250;

/** Writes the state into the address, at once if the last time is long ago, else soon. */
export class AddressBar {
  private wanted: State | null = null;
  private timer: ReturnType<typeof setTimeout> | null = null;

  /** Shows a state. */
  show(state: State): void {
    this.wanted = state;
    if (this.timer !== null) return;
    this.write();
    this.timer = setTimeout(() => {
      this.timer = null;
      this.write();
    }, INTERVAL_MS);
  }

  /** Writes what waits. */
  write(): void {
    if (this.wanted === null) return;
    const address = toAddress(this.wanted);
    this.wanted = null;
    // Without the numbers of before, also when there are none.
    window.history.replaceState(null, "", address === "" ? location.pathname + location.search : `#${address}`);
  }
}
