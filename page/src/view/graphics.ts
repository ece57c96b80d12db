// Draws vertices by WebGL: colours of the page, a light that stands behind the reader.

import { NUMBERS, type Vertices } from "./buffer.js";
import type { Rgb } from "./colours.js";
import type { Eye } from "./eye.js";

/** Four columns of four numbers. */
export type Matrix = number[];

/**
 * How vertices are drawn: `wall` may be seen from inside, `clear` shows what is behind it, `hidden`
 * is seen through walls, `dot` is in front of everything.
 */
export type Look = "wall" | "surface" | "line" | "clear" | "hidden" | "dot";

/** Vertices, how they are drawn, where, and how far they are faded to the colour of the paper. */
export interface Item {
  vertices: Vertices;
  look: Look;
  place: Matrix;
  fade: number;
}

const VERTEX = `#version 300 es
precision highp float;
uniform mat4 view, place;
uniform vec3 light, paper;
uniform float fade, nearer, size;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 colour;
layout(location = 2) in vec3 normal;
out vec3 shade;
void main() {
  vec3 turned = mat3(place) * normal;
  float lit = dot(turned, turned) > 0.0 ? 0.62 + 0.42 * max(0.0, dot(normalize(turned), light)) : 1.0;
  shade = mix(colour * lit, paper, fade);
  gl_Position = view * place * vec4(position, 1.0);
  gl_Position.z -= nearer;
  gl_PointSize = size;
}`;

const FRAGMENT = `#version 300 es
precision highp float;
uniform vec3 paper;
uniform float opacity;
uniform bool isDot;
in vec3 shade;
out vec4 seen;
void main() {
  float r = isDot ? length(gl_PointCoord - 0.5) : 0.0;
  if (r > 0.5) discard;
  seen = vec4(r > 0.36 ? paper : shade, opacity);
}`;

/** In the order in which they are drawn. */
const LOOKS: Record<Look, { opacity: number; isCulled: boolean; isTested: boolean; nearer: number }> = {
  wall: { opacity: 1, isCulled: false, isTested: true, nearer: 0 },
  surface: { opacity: 1, isCulled: true, isTested: true, nearer: 0 },
  line: { opacity: 1, isCulled: false, isTested: true, nearer: 2e-4 },
  clear: { opacity: 0.4, isCulled: true, isTested: true, nearer: 0 },
  hidden: { opacity: 0.75, isCulled: true, isTested: false, nearer: 0 },
  dot: { opacity: 1, isCulled: false, isTested: false, nearer: 0 },
};

/** From where the light comes: to the right, upwards, towards the reader. */
const LIGHT = [-0.42, 0.36, 0.83] as const;

interface Uploaded {
  buffers: WebGLBuffer[];
  array: WebGLVertexArrayObject;
  version: number;
}

/** What a context of WebGL draws with; a context that was lost needs a new one. */
export class Graphics {
  private readonly program: WebGLProgram;
  private readonly uploaded = new WeakMap<Vertices, Uploaded>();

  constructor(private readonly gl: WebGL2RenderingContext) {
    this.program = gl.createProgram();
    ([[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]] as const).forEach(([kind, source]) => {
      const shader = gl.createShader(kind)!;
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(this.program, shader);
    });
    gl.linkProgram(this.program);
    gl.useProgram(this.program);
    gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
  }

  /** Draws items on paper; everything is within a distance of the level of the eye. */
  draw(items: Item[], eye: Eye, distance: number, paper: Rgb, dotSize: number): void {
    const { gl } = this;
    gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
    gl.depthMask(true);
    gl.clearColor(...paper, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const axes = eye.axes;
    gl.uniformMatrix4fv(this.at("view"), false, eye.matrix(distance));
    gl.uniform3fv(this.at("light"), [0, 1, 2].map((i) => LIGHT.reduce((sum, part, k) => sum + part * axes[k]![i]!, 0)));
    gl.uniform3fv(this.at("paper"), paper);
    gl.uniform1f(this.at("size"), dotSize);
    (Object.keys(LOOKS) as Look[]).forEach((look) => {
      this.take(look);
      items.filter((item) => item.look === look && item.vertices.count > 0).forEach((item) => this.drawItem(item));
    });
  }

  private at(name: string): WebGLUniformLocation | null {
    return this.gl.getUniformLocation(this.program, name);
  }

  private take(look: Look): void {
    const { gl } = this;
    const { opacity, isCulled, isTested, nearer } = LOOKS[look];
    const set = (what: number, isOn: boolean): void => (isOn ? gl.enable(what) : gl.disable(what));
    set(gl.CULL_FACE, isCulled);
    set(gl.DEPTH_TEST, isTested);
    set(gl.BLEND, opacity < 1);
    gl.depthMask(opacity === 1);
    gl.uniform1f(this.at("opacity"), opacity);
    gl.uniform1f(this.at("nearer"), nearer);
    gl.uniform1i(this.at("isDot"), Number(look === "dot"));
  }

  private drawItem({ vertices, look, place, fade }: Item): void {
    const { gl } = this;
    this.upload(vertices);
    gl.uniformMatrix4fv(this.at("place"), false, place);
    gl.uniform1f(this.at("fade"), fade);
    const mode = look === "line" ? gl.LINES : look === "dot" ? gl.POINTS : gl.TRIANGLES;
    if (vertices.index === null) gl.drawArrays(mode, 0, vertices.count);
    else gl.drawElements(mode, vertices.index.length, gl.UNSIGNED_INT, 0);
  }

  /** Hands the vertices to the graphics, if they have changed, and takes them for drawing. */
  private upload(vertices: Vertices): void {
    const { gl } = this;
    const known = this.uploaded.get(vertices) ?? { ...this.layout(), version: -1 };
    gl.bindVertexArray(known.array);
    if (known.version === vertices.version) return;
    this.uploaded.set(vertices, Object.assign(known, { version: vertices.version }));
    gl.bindBuffer(gl.ARRAY_BUFFER, known.buffers[0]!);
    gl.bufferData(gl.ARRAY_BUFFER, vertices.data.subarray(0, NUMBERS * vertices.count), gl.DYNAMIC_DRAW);
    if (vertices.index !== null) gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, vertices.index, gl.DYNAMIC_DRAW);
  }

  private layout(): Omit<Uploaded, "version"> {
    const { gl } = this;
    const array = gl.createVertexArray();
    const buffers = [gl.createBuffer(), gl.createBuffer()];
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffers[0]!);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffers[1]!);
    [0, 1, 2].forEach((location) => {
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, 3, gl.FLOAT, false, 4 * NUMBERS, 12 * location);
    });
    return { array, buffers };
  }
}
