// Extremes over the cycle on the wheel's flank, and where the contact shown lies on it.

const flankPanel = new Panel("flank", 300, 76);
const grown = ([low, high], part) => [low - part * (high - low), high + part * (high - low)];

function drawFlank() {
  const flank = page.flank;
  if (!flank) return;
  const of = page.maps[state.flankField], values = unpacked(flank.fields[state.flankField]);
  const [low, high] = limits(of, [values]);
  flankPanel.begin(grown(span([flank.rim[0]]), 0.03), grown(span([flank.rim[1]]), 0.06), 520);
  flankPanel.image(values, flank.face, flank.radius, of, low, high);
  drawContact(flank);
  flankPanel.line(...flank.rim, "#343a40", 1.5);
  flankPanel.line(...flank.path, "#868e96", 1, [4, 3]);
  flankPanel.frame(`face width coordinate / mm${scalesOf(flankPanel)}`, "radius / mm");
  flankPanel.bar(of, low, high);
  const at = onFlank(scene(), state.scene);
  if (at) flankPanel.mark(...at, "#e03131");
}

/** The nodes that the contact shown loads, at their places on the flank. */
function drawContact(flank) {
  const places = flank.places[state.scene];
  if (!places) return;
  const [face, radius, loaded] = ["face", "radius", "loaded"].map((name) => unpacked(places[name]));
  flankPanel.pen.fillStyle = "rgba(134, 142, 150, 0.28)";
  for (let n = 0; n < face.length; n++)
    if (loaded[n] > 0.5) flankPanel.pen.fillRect(flankPanel.right(face[n]) - 1, flankPanel.down(radius[n]) - 1, 2.5, 2.5);
}

/** Place on the flank of the place picked in a contact. */
function onFlank(one, number) {
  const places = page.flank.places[number];
  if (!places || !one.y) return null;
  const [column, row] = picked(one), n = row * one.x[2] + column;
  return [unpacked(places.face)[n], unpacked(places.radius)[n]];
}

/** The contact that loads a place of the flank most, and the node of it nearest to that. */
function loadedMost(face, radius) {
  let best = null;
  page.scenes.forEach((one, number) => {
    const places = page.flank.places[number];
    if (!places || !one.fields.pressure) return;
    const [faces, radii] = [unpacked(places.face), unpacked(places.radius)], pressure = unpacked(one.fields.pressure);
    let nearest = -1, least = 1;  // mm2: a place farther off is none of this contact
    for (let n = 0; n < faces.length; n++) {
      const off = (faces[n] - face) ** 2 + (radii[n] - radius) ** 2;
      if (off < least) [least, nearest] = [off, n];
    }
    if (nearest >= 0 && (!best || pressure[nearest] > best.pressure)) best = { number, nearest, pressure: pressure[nearest] };
  });
  return best;
}

flankPanel.canvas.addEventListener("mousemove", (event) => {
  const at = page.flank && flankPanel.under(event);
  if (!at) return;
  const [column, row] = [node(page.flank.face, at[0]), node(page.flank.radius, at[1])];
  if (!inside(page.flank.face, column) || !inside(page.flank.radius, row)) return;
  const values = Object.entries(page.maps).map(([name, of]) =>
    `${of.label} ${shownNumber(unpacked(page.flank.fields[name])[row * page.flank.face[2] + column])} ${of.unit}`);
  element("flank-read").textContent = `face ${at[0].toFixed(2)} mm, radius ${at[1].toFixed(2)} mm: ${values.join(", ")}`;
});
flankPanel.canvas.addEventListener("click", (event) => {
  const at = page.flank && flankPanel.under(event), found = at && loadedMost(...at);
  if (!found || !(found.pressure > 0)) return;
  const one = page.scenes[found.number];
  state.scene = found.number;
  state.picked = [place(one.x, found.nearest % one.x[2]), place(one.y, Math.floor(found.nearest / one.x[2]))];
  update();
});
