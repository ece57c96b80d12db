// The script of a report.

import type { TowerScene } from "../view/scene.js";
import { offerExports } from "./exports.js";
import { offerFiles } from "./files.js";
import { preparePage } from "./page.js";
import { animateTower } from "./tower.js";
import { animateTurbine, type Turbine } from "./turbine.js";

/** The data of an animation, if the page has it. */
function dataOf<Data>(id: string): Data | null {
  const text = document.getElementById(`${id}-data`)?.textContent;
  return text == null ? null : JSON.parse(text) as Data;
}

preparePage();
offerFiles();
offerExports();
const tower = dataOf<TowerScene>("animation");
if (tower !== null) animateTower(tower);
const turbine = dataOf<Turbine>("whirl");
if (turbine !== null) animateTurbine(turbine);
