// The field of one contact over its tangent plane.

const map = new Panel("map", 420, 76);

function drawMap() {
  const one = scene(), of = quantity(), [low, high] = fieldLimits();
  element("field-title").textContent = `${label(of)}, ${one.name}${one.converged ? "" : ` - NOT CONVERGED: ${one.stopped}`}`;
  if (!one.y) return;
  map.height = Math.max(240, Math.min(420, map.canvas.clientWidth * 0.34));
  map.begin(one.x.slice(0, 2), one.y.slice(0, 2), 420);
  map.image(fieldOf(one), one.x, one.y, of, low, high);
  outline(map, one);
  map.frame(`x / mm${scalesOf(map)}`, "y / mm");
  map.bar(of, low, high);
  map.mark(...one.least, "#fff");
  if (state.picked) {
    map.line(one.x.slice(0, 2), [state.picked[1], state.picked[1]], "#e03131", 1, [5, 4]);
    map.line([state.picked[0], state.picked[0]], one.y.slice(0, 2), "#e03131", 1, [5, 4]);
  }
}

/** Outline of the dry contact, drawn from the solution's own grid. */
function outline(panel, one) {
  const pen = panel.pen;
  pen.save();
  pen.beginPath();
  pen.rect(...panel.box);
  pen.clip();
  pen.strokeStyle = "rgba(255, 255, 255, 0.9)";
  pen.lineWidth = 1.3;
  pen.lineJoin = "round";
  for (const line of one.outline) {
    pen.beginPath();
    line.forEach(([x, y], n) => pen[n ? "lineTo" : "moveTo"](panel.right(x), panel.down(y)));
    pen.stroke();
  }
  pen.restore();
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
