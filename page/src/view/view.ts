import type { Handle, Pose, TowerScene, ViewEvents } from "./scene.js";

/** Whether the browser draws in three dimensions (WebGL). */
export function isSupported(): boolean {
  return false;
}

/** The tower in three dimensions in an element of a page. Colours are the variables `--tm-*` of the page. */
export class TowerView {
  /** Fills an element, and follows its size and the theme. */
  constructor(host: HTMLElement, label: string, events: ViewEvents = {}) {
    void [host, label, events];
  }

  /** Shows a tower, and a second one beside it, paler, to compare with. The camera stays where the user put it; the first call frames the tower. */
  show(tower: TowerScene, beside: TowerScene | null = null): void {
    void [tower, beside];
  }

  /** Moves the towers from rest; null is at rest. Draws at once. */
  pose(tower: Pose | null, beside: Pose | null = null): void {
    void [tower, beside];
  }

  /** The stations that can be dragged; drawn as handles while the pointer is over the view or the view has the focus. */
  handles(stations: Handle[]): void {
    void stations;
  }

  /** The direction of the eye: azimuth about the tower from the upwind side and elevation, degrees. */
  look(azimuth: number, elevation: number): void {
    void [azimuth, elevation];
  }

  /** The first camera again, on the present tower. */
  reset(): void {}

  /** Reads the colours again. */
  recolour(): void {}

  /** The picture as PNG. */
  png(): Promise<Blob> {
    return Promise.reject(new Error("not drawn"));
  }

  /** Frees everything. */
  dispose(): void {}
}
