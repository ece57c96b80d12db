// The tower in three dimensions.

export type * from "./scene.js";
export { TowerView, isSupported } from "./view.js";
