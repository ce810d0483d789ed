// The field of one contact over its tangent plane.

const map = new Panel("map", 420, 76);

function drawMap() {
  const one = scene(), of = quantity(), [low, high] = fieldLimits();
  element("field-title").textContent = `${label(of)}, ${one.name}${one.converged ? "" : ` - NOT CONVERGED: ${one.stopped}`}`;
  if (!one.y) return;
  map.height = Math.max(240, Math.min(420, map.canvas.clientWidth * 0.34));
  map.begin(one.x.slice(0, 2), one.y.slice(0, 2));
  map.image(fieldOf(one), one.x, one.y, of, low, high);
  outline(map, one);
  map.frame("x / mm (scales of x and y differ)", "y / mm");
  map.bar(of, low, high);
  map.mark(...one.least, "#fff");
  if (state.picked) {
    map.line(one.x.slice(0, 2), [state.picked[1], state.picked[1]], "#e03131", 1, [5, 4]);
    map.line([state.picked[0], state.picked[0]], one.y.slice(0, 2), "#e03131", 1, [5, 4]);
  }
}

/** Outline of the dry contact, whose pressure falls to it as a root: its square is linear between nodes. */
function outline(panel, one) {
  const dry = one.fields.dry_pressure && unpacked(one.fields.dry_pressure), [nx, ny] = [one.x[2], one.y[2]];
  if (!dry) return;
  const pen = panel.pen, level = (0.05 * span([dry])[1]) ** 2;
  const height = (column, row) => dry[row * nx + column] ** 2 - level;
  pen.strokeStyle = "rgba(255, 255, 255, 0.9)";
  pen.lineWidth = 1.3;
  pen.beginPath();
  for (let row = 0; row + 1 < ny; row++) for (let column = 0; column + 1 < nx; column++) {
    const corners = [[column, row], [column + 1, row], [column + 1, row + 1], [column, row + 1]], cuts = [];
    corners.forEach((from, n) => {
      const to = corners[(n + 1) % 4], [a, b] = [height(...from), height(...to)];
      if (a > 0 !== b > 0) cuts.push(from.map((of, k) => of + (to[k] - of) * a / (a - b)));
    });
    cuts.forEach(([x, y], n) => pen[n % 2 ? "lineTo" : "moveTo"](panel.right(place(one.x, x)), panel.down(place(one.y, y))));
  }
  pen.stroke();
}

function readMap(event) {
  const one = scene(), at = one.y && map.under(event);
  if (!at) return;
  const n = node(one.y, at[1]) * one.x[2] + node(one.x, at[0]);
  const values = Object.keys(page.fields).filter((name) => one.fields[name]).map((name) => {
    const of = page.fields[name];
    return `${of.label} ${shownNumber(unpacked(one.fields[name])[n])} ${of.unit}`;
  });
  element("map-read").textContent = `x ${at[0].toFixed(3)} mm, y ${at[1].toFixed(3)} mm: ${values.join(", ")}`;
}

map.canvas.addEventListener("mousemove", readMap);
map.canvas.addEventListener("click", (event) => {
  const at = scene().y && map.under(event);
  if (at) { state.picked = at; update(); }
});
