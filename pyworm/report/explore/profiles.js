// Profiles of the field shown through the place picked.

const profiles = { x: new Panel("along-x", 230), y: new Panel("along-y", 230) };

/** Places and values along an axis through the place picked. */
function profile(one, values, axis) {
  if (!one.y) return [Array.from({ length: one.x[2] }, (_, n) => place(one.x, n)), Array.from(values)];
  const [column, row] = picked(one), along = one[axis];
  const places = Array.from({ length: along[2] }, (_, n) => place(along, n));
  return [places, places.map((_, n) => axis === "x" ? values[row * one.x[2] + n] : values[n * one.x[2] + column])];
}

/** Node picked, by default that of the thinnest film, within the window of the contact. */
function picked(one) {
  const at = state.picked || one.least;
  return [one.x, one.y].map((axis, n) => Math.max(0, Math.min(axis[2] - 1, node(axis, at[n]))));
}

function drawProfile(axis) {
  const one = scene(), panel = profiles[axis], of = quantity(), [low, high] = fieldLimits();
  const room = 0.05 * (high - low), fields = [[fieldOf(one), "#1864ab", 2, []]];
  const dry = one.fields.dry_pressure;
  if (state.field === "pressure" && dry) fields.push([unpacked(dry), "#868e96", 1.2, [6, 4]]);
  panel.begin(one[axis].slice(0, 2), [low - (low === 0 ? 0 : room), high + room]);
  for (const [values, ...style] of fields) panel.line(...profile(one, values, axis), ...style);
  panel.frame(`${axis} / mm`, label(of));
  const other = axis === "x" ? "y" : "x";
  element(`${axis}-read`).textContent = !one.y ? "" :
    `at ${other} ${place(one[other], picked(one)[axis === "x" ? 1 : 0]).toFixed(3)} mm${fields.length > 1 ? "; dashed: dry contact" : ""}`;
}

function drawProfiles() {
  drawProfile("x");
  element("y-part").hidden = !scene().y;
  if (scene().y) drawProfile("y");
}

profiles.x.canvas.addEventListener("mousemove", (event) => readProfile("x", event));
profiles.y.canvas.addEventListener("mousemove", (event) => readProfile("y", event));

function readProfile(axis, event) {
  const at = profiles[axis].under(event), one = scene();
  if (!at) return;
  const n = node(one[axis], at[0]), value = profile(one, fieldOf(one), axis)[1][n];
  element(`${axis}-read`).textContent = `${axis} ${at[0].toFixed(3)} mm: ${quantity().label} ${shownNumber(value)} ${quantity().unit}`;
}
