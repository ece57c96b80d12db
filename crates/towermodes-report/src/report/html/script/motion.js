// The tower of the page, and how it moves: as in the view in three dimensions, whose script comes before.

const tower = JSON.parse(document.getElementById("animation-data").textContent);
const { poseOf, placed, onShell } = towermodesView.motion;
const MOST_PERCENT = 20;

const reach = (mode, percent) => towermodesView.motion.reach(tower, mode, percent);
const sectionsAt = (mode, scale) => towermodesView.motion.sectionsAt(tower, mode, scale);
