// The view in space as a picture that is turned by hand. Where the browser does not draw in three dimensions, and on
// paper, it is a drawing like the other views.

// The eye of the view: its azimuth is counted from the upwind side, that of drawings from downwind.
const HALF_TURN = 180;

let pictures = null;

function openSpace() {
  if (!towermodesView.isSupported()) return null;
  const { azimuth, elevation } = VIEWS.space;
  try {
    return new towermodesView.Pictures(byId("animation-stage"), tower, MOST_PERCENT, azimuth + HALF_TURN, elevation, {
      changed: () => {
        if (pictures === null) return;
        followHand();
        draw();
      },
      lost: () => {
        pictures = null;
        build();
      },
    });
  } catch {
    // A browser may refuse what it said that it can do, for instance one context more.
    return null;
  }
}

// A canvas over the drawing of the view in space.
function addCanvas(shown) {
  shown.cell.classList.add("live");
  shown.canvas = document.createElement("canvas");
  const attributes = {
    tabindex: 0, role: "application", "aria-roledescription": "3-D view",
    "aria-label": `Mode ${shown.mode.number}, ${shown.mode.label}, in 3-D`,
    "aria-description": "Arrow keys turn the view, plus and minus zoom, 0 resets it.",
  };
  Object.entries(attributes).forEach(([key, value]) => shown.canvas.setAttribute(key, value));
  shown.cell.prepend(shown.canvas);
}

function fillSpace() {
  if (pictures === null) return;
  const inSpace = state.pictures.filter(({ name }) => name === "space");
  inSpace.forEach(addCanvas);
  pictures.use(inSpace.map(({ canvas }) => canvas), inSpace.map(({ mode }) => mode));
}

// The slider goes where the hand has turned the view.
function followHand() {
  const azimuth = pictures.azimuth - HALF_TURN;
  VIEWS.space.azimuth = azimuth < -HALF_TURN ? azimuth + 2 * HALF_TURN : azimuth;
  VIEWS.space.elevation = pictures.elevation;
  byId("animation-azimuth").value = VIEWS.space.azimuth;
  writeDirection();
}
