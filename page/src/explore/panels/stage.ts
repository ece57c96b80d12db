// The tower in three dimensions, with the controls of its motion.

import { TowerView, isSupported } from "../../view/index.js";
import type { Drag, Handle, Tap, TowerScene } from "../../view/scene.js";
import { byId, make, setClass, setHidden, setText, swatch } from "../dom.js";
import { Player, type Moving, type Turning } from "../modes/player.js";
import type { Word } from "../protocol.js";
import { film, picture, type Axes, type Caption } from "./picture.js";

/** From the pointer to the text above it, in pixels. */
const ABOVE = 16;

export interface StageEvents {
  /** Whether the next tower is about to come. */
  isAwaited(): boolean;
  drag(drag: Drag): void;
  /** A picture of the tower, for browsers that do not draw in three dimensions. */
  flatPicture(): Promise<Blob>;
}

export class Stage {
  readonly player: Player;
  private view: TowerView | null = null;
  private flat: HTMLImageElement | null = null;
  private present: Moving | null = null;
  private amplitude = byId<HTMLInputElement>("amplitude");
  private speed = byId<HTMLInputElement>("speed");
  private lastTap: Tap | null = null;
  /** What is in the hand, beside the pointer. */
  private held = make("p", "held");
  /** Whether the tower moves again when the hand lets go. */
  private goesOn = false;
  private hasHandles = false;

  constructor(private events: StageEvents) {
    this.player = new Player((pose, beside) => this.view?.pose(pose, beside), () => this.events.isAwaited());
    this.open();
    this.listen();
    this.readControls();
  }

  private open(): void {
    const host = byId("view");
    if (isSupported()) {
      this.held.hidden = true;
      host.append(this.held);
      this.view = new TowerView(host, "The tower", {
        drag: (drag) => this.events.drag(drag),
        tap: (tap) => this.release(tap),
      });
      return;
    }
    this.flat = make("img");
    this.flat.alt = "The tower to scale";
    host.append(make("p", "remark", "This browser does not draw in three dimensions (WebGL). Everything else works."), this.flat);
    byId("motion").hidden = true;
  }

  private listen(): void {
    byId("play").addEventListener("click", () => this.toggle());
    byId("one-mode").addEventListener("click", () => this.setTap(null));
    byId("after-tap").addEventListener("click", () => this.tapTop());
    byId("camera").addEventListener("click", () => this.view?.reset());
    for (const input of [this.amplitude, this.speed]) {
      input.addEventListener("input", () => {
        this.readControls();
        this.player.refresh();
        this.showMotion();
      });
    }
  }

  /** The positions of the controls, for a reload. */
  get controls(): { amplitude: string; speed: string } {
    return { amplitude: this.amplitude.value, speed: this.speed.value };
  }

  set controls({ amplitude, speed }: { amplitude: string; speed: string }) {
    this.amplitude.value = amplitude;
    this.speed.value = speed;
    this.readControls();
  }

  private readControls(): void {
    this.player.setting.amplitude = Number(this.amplitude.value);
    this.player.setting.screen_hz = 10 ** Number(this.speed.value);
  }

  /** Shows a solved tower, and A beside it. */
  show(present: Moving, other: Moving | null, handles: Handle[]): void {
    this.present = present;
    const { turning } = this.player.setting;
    if (turning !== null) this.view?.show(turning.scene, null);
    else this.view?.show(present.answer.scene, other?.answer.scene ?? null);
    this.view?.handles(handles);
    this.hasHandles = this.view !== null && handles.length > 0;
    setHidden(byId("beside"), other === null || turning !== null || this.view === null);
    this.player.show(present, other);
    if (this.view !== null && this.player.isPlaying) this.player.paint();
    this.showMotion();
  }

  /** Draws the flat picture again, where there is no other. */
  async refreshFlat(): Promise<void> {
    if (this.flat === null) return;
    const picture = URL.createObjectURL(await this.events.flatPicture());
    URL.revokeObjectURL(this.flat.src);
    this.flat.src = picture;
  }

  choose(id: number): void {
    this.player.setting.chosen = id;
    this.player.setting.turning = null;
    this.setTap(null);
  }

  /** The turbine in place of the tower, from the next `show` on; null is the tower. */
  turn(turning: Turning | null): void {
    this.player.setting.turning = turning;
    if (turning !== null) this.player.setting.tap = null;
    this.player.refresh();
  }

  toggle(): void {
    if (this.player.isPlaying) this.player.pause();
    else this.player.play();
    this.showMotion();
  }

  play(): void {
    this.player.play();
    this.showMotion();
  }

  /** Releases the tower from a push at its top in a slanting direction, or as it was tapped
   * last. */
  tapTop(): void {
    const top: TowerScene | undefined = this.present?.answer.scene;
    if (top === undefined) return;
    this.release(this.lastTap ?? { height_m: top.height_m.at(-1) ?? 0, direction: [Math.SQRT1_2, Math.SQRT1_2] });
  }

  private release(tap: Tap): void {
    this.lastTap = tap;
    this.setTap(tap);
    this.play();
  }

  /** The tower stands still in the hand, and what is dragged stands beside the pointer; null lets
   * go. */
  hold(held: { text: string; place: [number, number] } | null): void {
    const { player } = this;
    if (held === null) {
      setHidden(this.held, true);
      if (this.goesOn) this.play();
      this.goesOn = false;
      return;
    }
    this.goesOn ||= player.isPlaying;
    player.pause();
    setText(this.held, held.text);
    setHidden(this.held, false);
    // Above the pointer, within the view.
    const [x, y] = held.place;
    const most = byId("view").clientWidth - this.held.offsetWidth;
    const left = Math.max(0, Math.min(x - this.held.offsetWidth / 2, most));
    this.held.style.transform = `translate(${left}px, ${Math.max(0, y - this.held.offsetHeight - ABOVE)}px)`;
  }

  private setTap(tap: Tap | null): void {
    this.player.setting.tap = tap;
    if (tap !== null && this.player.setting.turning !== null && this.present !== null) {
      this.player.setting.turning = null;
      this.view?.show(this.present.answer.scene, null);
    }
    this.player.restart();
    if (this.player.isPlaying) this.player.paint();
    this.showMotion();
  }

  private showMotion(): void {
    const { setting, isPlaying } = this.player;
    setText(byId("play"), isPlaying ? "Pause" : "Play");
    byId("play").setAttribute("aria-pressed", String(isPlaying));
    byId("one-mode").setAttribute("aria-pressed", String(setting.tap === null));
    byId("after-tap").setAttribute("aria-pressed", String(setting.tap !== null));
    setText(byId("amplitude-text"), `${(100 * setting.amplitude).toFixed(1)} % of the height`);
    setText(byId("speed-text"), paceText(this.player.timeFactor()));
    const tap = setting.tap;
    setClass(byId("motion-text"), tap === null ? "remark hint" : "remark");
    setText(byId("motion-text"), tap === null ? this.hint() :
      `Pushed at ${tap.height_m.toFixed(1)} m and released, without damping.`);
  }

  /** What a hand can do in the view: its handles are seen only under the pointer. */
  private hint(): string {
    return this.hasHandles ? "Drag the view to turn it, or a station to change the tower." : "";
  }

  /** The mode that is shown, in large figures. */
  readout(mode: Readout | undefined, series: number): void {
    setText(byId("readout-name"), mode?.label ?? "");
    setClass(byId("readout-swatch"), swatch(series));
    setText(byId("readout-frequency"), mode ? `${mode.frequency} Hz` : "");
    setText(byId("readout-verdict"), mode?.verdict?.word.toUpperCase() ?? "");
    setClass(byId("readout-verdict"), `verdict ${mode?.verdict?.word ?? ""}`);
  }

  /** The view with its words. */
  png(file: string): Promise<Blob> {
    const { view } = this;
    if (view === null) return Promise.reject(new Error("This browser does not draw in three dimensions."));
    return picture(view.picture, this.caption(file), (on, { ink, font }) => view.drawAxes(on, ink, font));
  }

  /** The mode that is shown, for one period; a turbine until its rotor has turned once, at most
   * twenty seconds. */
  async film(file: string): Promise<Blob> {
    const { view, player } = this;
    if (view === null) throw new Error("This browser does not draw in three dimensions.");
    const wasPlaying = player.isPlaying;
    player.pause();
    const seconds = Math.min(20, player.period_s());
    try {
      const axes: Axes = (on, { ink, font }) => view.drawAxes(on, ink, font);
      return await film(view.picture, this.caption(file), axes, seconds, (moment) => player.paintAt(moment * seconds));
    } finally {
      player.restart();
      if (wasPlaying) this.play();
    }
  }

  private caption(file: string): Caption {
    const text = (id: string): string => byId(id).textContent ?? "";
    return {
      file,
      mode: `${text("readout-name")}, ${text("readout-frequency")}`,
      amplitude: `Amplitude ${text("amplitude-text")}, ${text("speed-text")}`,
    };
  }
}

/** A mode in large figures. */
export interface Readout {
  label: string;
  frequency: string;
  verdict: { word: Word } | null;
}

/** How the motion on the screen relates to the real one. */
function paceText(factor: number): string {
  if (Math.abs(factor - 1) < 0.05) return "as fast as real";
  return factor > 1 ? `${factor.toPrecision(2)}× faster than real` : `${(1 / factor).toPrecision(2)}× slower than real`;
}
