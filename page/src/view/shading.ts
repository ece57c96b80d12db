// What surfaces, lines and handles look like: colours of the page, a light that stands behind the
// reader.

import { Color, DoubleSide, FrontSide, GLSL3, RawShaderMaterial } from "three";

import type { Rgb } from "./colours.js";

const SURFACE = `
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform mat3 normalMatrix;
uniform vec3 paper;
uniform float fade;
in vec3 position, normal, color;
out vec3 shade;
void main() {
  float light = 0.62 + 0.42 * max(0.0, dot(normalize(normalMatrix * normal), vec3(-0.42, 0.36, 0.83)));
  shade = mix(color * light, paper, fade);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const LINE = `
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform vec3 paper;
uniform float fade;
in vec3 position, color;
out vec3 shade;
void main() {
  shade = mix(color, paper, fade);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  gl_Position.z -= 2e-4;
}`;

const PLAIN = `
precision highp float;
uniform float opacity;
in vec3 shade;
out vec4 colour;
void main() { colour = vec4(shade, opacity); }`;

const DOT_VERTEX = `
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform float size;
in vec3 position, color;
out vec3 shade;
void main() {
  shade = color;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  gl_PointSize = size;
}`;

const DOT = `
precision highp float;
uniform vec3 paper;
in vec3 shade;
out vec4 colour;
void main() {
  float r = length(gl_PointCoord - 0.5);
  if (r > 0.5) discard;
  colour = vec4(r > 0.36 ? paper : shade, 1.0);
}`;

function material(vertexShader: string, fragmentShader: string, opacity: number): RawShaderMaterial {
  const uniforms = { paper: { value: new Color() }, fade: { value: 0 }, opacity: { value: opacity }, size: { value: 1 } };
  return new RawShaderMaterial({ glslVersion: GLSL3, vertexShader, fragmentShader, uniforms, transparent: opacity < 1 });
}

/** A closed surface; pushed back a little, so that lines on it are seen. */
export function surface(opacity = 1): RawShaderMaterial {
  const made = material(SURFACE, PLAIN, opacity);
  Object.assign(made, { side: FrontSide, depthWrite: opacity === 1 });
  return made;
}

/** The wall of a tube, which may be seen from inside. */
export function wall(): RawShaderMaterial {
  const made = surface();
  made.side = DoubleSide;
  return made;
}

/** What is seen through walls. */
export function xray(): RawShaderMaterial {
  const made = surface(0.75);
  made.depthTest = false;
  return made;
}

export const line = (): RawShaderMaterial => material(LINE, PLAIN, 1);

/** Dots of a fixed size in front of everything. */
export function dots(): RawShaderMaterial {
  const made = material(DOT_VERTEX, DOT, 1);
  Object.assign(made, { depthTest: false, transparent: true });
  return made;
}

/** How far a material is faded to the colour of the paper. */
export function tint(made: RawShaderMaterial, paper: Rgb, fade: number): void {
  (made.uniforms.paper!.value as Color).setRGB(...paper);
  made.uniforms.fade!.value = fade;
}

/** The size of dots, in pixels of the canvas. */
export function setSize(made: RawShaderMaterial, pixels: number): void {
  made.uniforms.size!.value = pixels;
}
