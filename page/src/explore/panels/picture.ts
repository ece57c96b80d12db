// The view with its words as a picture, and the mode in motion as a film.

/** What stands in a picture beside the tower. */
export interface Caption {
  /** "monopile.toml". */
  file: string;
  /** "1st fore-aft bending, 0.2765 Hz". */
  mode: string;
  /** "amplitude 5.0 % of the height". */
  amplitude: string;
}

interface Look {
  paper: string;
  ink: string;
  muted: string;
  font: string;
}

/** Room for the caption, as a multiple of the size of its text. */
const LINES = 4.6;
const TEXT_PX = 14;
const FRAMES_HZ = 30;
/** The formats of a film, the best first. */
const FORMATS = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm", "video/mp4"];

function lookOf(canvas: HTMLCanvasElement): Look {
  const style = getComputedStyle(canvas);
  const colour = (name: string, otherwise: string): string => style.getPropertyValue(`--tm-${name}`).trim() || otherwise;
  return { paper: colour("paper", "#fff"), ink: colour("ink", "#000"), muted: colour("muted", "#555"), font: style.fontFamily };
}

/** Draws a view with its caption. */
class Sheet {
  readonly canvas = document.createElement("canvas");
  private look: Look;
  private ratio: number;

  constructor(private view: HTMLCanvasElement, private caption: Caption, private axes: (on: CanvasRenderingContext2D, look: Look) => void) {
    this.look = lookOf(view);
    this.ratio = view.width / Math.max(1, view.clientWidth);
    // A film has an even number of pixels.
    this.canvas.width = 2 * Math.ceil(view.width / 2);
    this.canvas.height = 2 * Math.ceil((view.height + LINES * TEXT_PX * this.ratio) / 2);
  }

  draw(): void {
    const on = this.canvas.getContext("2d");
    if (on === null) throw new Error("the browser gives no picture");
    const { look, ratio, caption, canvas, view } = this;
    on.setTransform(1, 0, 0, 1, 0, 0);
    on.fillStyle = look.paper;
    on.fillRect(0, 0, canvas.width, canvas.height);
    const top = LINES * TEXT_PX;
    on.drawImage(view, 0, Math.round(top * ratio));
    on.setTransform(ratio, 0, 0, ratio, 0, 0);
    const write = (text: string, line: number, colour: string, weight: string): void => {
      on.fillStyle = colour;
      on.font = `${weight} ${TEXT_PX}px ${look.font}`;
      on.fillText(text, TEXT_PX, line * 1.35 * TEXT_PX, canvas.width / ratio - 2 * TEXT_PX);
    };
    write(caption.mode, 1, look.ink, "600");
    write(caption.amplitude, 2, look.muted, "400");
    write(caption.file, 3, look.muted, "400");
    on.setTransform(ratio, 0, 0, ratio, 0, Math.round(top * ratio));
    this.axes(on, look);
  }
}

export type Axes = ConstructorParameters<typeof Sheet>[2];

/** A picture as PNG. */
export function picture(view: HTMLCanvasElement, caption: Caption, axes: Axes): Promise<Blob> {
  const sheet = new Sheet(view, caption, axes);
  sheet.draw();
  return new Promise((resolve, reject) => sheet.canvas.toBlob((blob) => {
    if (blob === null) reject(new Error("the browser gives no picture"));
    else resolve(blob);
  }));
}

/** The format of films that the browser makes; null if it makes none. */
export function filmFormat(): string | null {
  if (typeof MediaRecorder === "undefined") return null;
  return FORMATS.find((format) => MediaRecorder.isTypeSupported(format)) ?? null;
}

/**
 * A film of so many seconds; `paint` draws the view at a moment, from 0 to 1. It is as long as the
 * browser takes to draw it.
 */
export async function film(
  view: HTMLCanvasElement, caption: Caption, axes: Axes, seconds: number, paint: (moment: number) => void,
): Promise<Blob> {
  const format = filmFormat();
  if (format === null) throw new Error("This browser does not record films.");
  const sheet = new Sheet(view, caption, axes);
  const recorder = new MediaRecorder(sheet.canvas.captureStream(FRAMES_HZ), { mimeType: format, videoBitsPerSecond: 4e6 });
  const parts: Blob[] = [];
  recorder.ondataavailable = ({ data }) => parts.push(data);
  const ended = new Promise<void>((resolve, reject) => {
    recorder.onstop = () => resolve();
    recorder.onerror = () => reject(new Error("the browser has stopped recording"));
  });
  recorder.start();
  await run(seconds, (moment) => {
    paint(moment);
    sheet.draw();
  });
  recorder.stop();
  await ended;
  return new Blob(parts, { type: format.split(";")[0] ?? format });
}

function run(seconds: number, draw: (moment: number) => void): Promise<void> {
  return new Promise((resolve, reject) => {
    const begun = performance.now();
    const frame = (now: number): void => {
      const moment = Math.max(0, now - begun) / (1000 * seconds);
      try {
        draw(Math.min(1, moment));
      } catch (error) {
        reject(error as Error);
        return;
      }
      if (moment >= 1) resolve();
      else requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  });
}
