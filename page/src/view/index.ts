// The tower in three dimensions, in the explorer and in reports.

export type * from "./scene.js";
export { TowerView, isSupported } from "./view.js";
export * as motion from "./motion.js";
export { Pictures } from "./pictures.js";
