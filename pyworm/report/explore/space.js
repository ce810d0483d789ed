// The drive in space: quadrangles sorted by depth, drawn from behind to the front, and lines of contact over them.

const bodyColours = { 1: [173, 181, 189], 2: [214, 184, 130] };

/** A point turned right-handed about an axis through a point. */
function turned(point, origin, axis, angle) {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)], d = point.map((of, n) => of - origin[n]);
  const along = d[0] * axis[0] + d[1] * axis[1] + d[2] * axis[2];
  const cross = [axis[1] * d[2] - axis[2] * d[1], axis[2] * d[0] - axis[0] * d[2], axis[0] * d[1] - axis[1] * d[0]];
  return d.map((of, n) => origin[n] + cos * (of - along * axis[n]) + along * axis[n] + sin * cross[n]);
}

/** Turn of a shape at the contact shown. */
const turnOf = (shape) => shape.turns[state.scene];

/** Points of a shape, turned, as seen: right, up, towards the eye. */
function seen(shape, turn, view, middle) {
  const points = unpacked(shape.points), found = new Array(points.length / 3);
  for (let n = 0; n < found.length; n++) {
    const at = turned([points[3 * n], points[3 * n + 1], points[3 * n + 2]], shape.axisPoint, shape.axis, turn);
    found[n] = view(at.map((of, k) => of - middle[k]));
  }
  return found;
}

/** Turn of the view about what is up in it and across that. */
function viewOf() {
  const [a, b] = state.turn, [ca, sa, cb, sb] = [Math.cos(a), Math.sin(a), Math.cos(b), Math.sin(b)];
  return (at) => {
    const [right, up, near] = page.space.view.map((axis) => axis[0] * at[0] + axis[1] * at[1] + axis[2] * at[2]);
    const turnedRight = ca * right + sa * near, depth = -sa * right + ca * near;
    return [turnedRight, cb * up - sb * depth, sb * up + cb * depth];
  };
}

/** Quadrangles of a shape with depth and colour; those that carry load lie before all others. */
function quadrangles(shape, points, pressures, most) {
  const found = [], heat = coloursOf({ colours: "inferno" }), base = bodyColours[shape.body];
  const step = pressures ? 1 : shape.stride;
  for (let row = 0; row + step < shape.rows; row += step) for (let column = 0; column + step < shape.columns; column += step) {
    const first = row * shape.columns + column, below = first + step * shape.columns;
    const corners = [first, first + step, below + step, below];
    const at = corners.map((n) => points[n]);
    if (at.some((of) => !Number.isFinite(of[0]))) continue;
    const [u, v] = [[at[2], at[0]], [at[3], at[1]]].map(([to, from]) => to.map((of, n) => of - from[n]));
    const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const area = Math.hypot(...normal);
    if (area < 1e-6 * page.space.size ** 2) continue;
    const light = 0.45 + 0.55 * Math.abs(0.5 * normal[0] * 0.6 + 0.3 * normal[1] + normal[2]) / (1.2 * area);
    const load = pressures ? Math.max(...corners.map((n) => pressures[n])) : 0;
    const loaded = load > 0.05 * most, shade = base.map((of) => Math.round(of * Math.min(1, light)));
    const depth = at[0][2] + at[1][2] + at[2][2] + at[3][2] + (loaded ? 1e6 : 0);
    const see = shape.body === 1 && !page.space.lines.length ? 0.55 : 1;
    found.push({ at, depth, colour: loaded ? `rgb(${heat(load, 0, most)})` : `rgba(${shade}, ${see})`, edge: see === 1 });
  }
  return found;
}

function drawSpace() {
  const canvas = element("space");
  if (!page.space) return;
  const ratio = window.devicePixelRatio || 1, width = canvas.clientWidth, height = 420;
  [canvas.width, canvas.height] = [width * ratio, height * ratio];
  canvas.style.height = `${height}px`;
  const pen = canvas.getContext("2d"), view = viewOf(), faces = [];
  const { shapes, lines, size } = page.space, touching = shapes.find((of) => of.pressures.length);
  const middle = touching ? centre(touching) : meanOf(lines.flat());
  const most = touching ? span(touching.pressures.map(unpacked))[1] : 1;
  for (const shape of shapes) for (const [number, copy] of [0, ...shape.copies].entries()) {
    const points = seen(shape, turnOf(shape) + copy, view, middle);
    const pressures = number === 0 && shape.pressures.length ? unpacked(shape.pressures[state.scene]) : null;
    faces.push(...quadrangles(shape, points, pressures, most));
  }
  faces.sort((one, other) => one.depth - other.depth);
  const scale = ratio * state.near * Math.min(width, height) / size;
  const across = (x) => canvas.width / 2 + scale * x, down = (y) => 0.62 * canvas.height - scale * y;
  for (const { at, colour, edge } of faces) {
    pen.fillStyle = pen.strokeStyle = colour;
    pen.lineWidth = 0.7;
    pen.beginPath();
    at.forEach(([x, y], n) => pen[n ? "lineTo" : "moveTo"](across(x), down(y)));
    pen.closePath();
    pen.fill();
    if (edge) pen.stroke();  // or the page shows between neighbours
  }
  if (!lines.length) return;
  const line = lines[state.scene].map((at) => view(at.map((of, k) => of - middle[k])));
  for (const [colour, thick] of [["#fff", 5], ["#e03131", 3]]) {
    [pen.strokeStyle, pen.lineWidth, pen.lineCap] = [colour, ratio * thick, "round"];
    pen.beginPath();
    line.forEach(([x, y], n) => pen[n ? "lineTo" : "moveTo"](across(x), down(y)));
    pen.stroke();
  }
}

const meanOf = (points) => [0, 1, 2].map((k) => points.reduce((sum, at) => sum + at[k], 0) / points.length);

/** Middle of the loaded tooth at mid-cycle, about which the view turns. */
function centre(shape) {
  const points = unpacked(shape.points), turn = shape.turns[Math.floor(shape.turns.length / 2)], found = [];
  for (let n = 0; n < points.length; n += 3) if (Number.isFinite(points[n]))
    found.push(turned([points[n], points[n + 1], points[n + 2]], shape.axisPoint, shape.axis, turn));
  return meanOf(found);
}

function watchSpace() {
  const canvas = element("space");
  const title = page.bodies.join(" and ");
  element("space-title").textContent = title[0].toUpperCase() + title.slice(1);
  element("space-read").textContent = `Drag to turn, wheel to come nearer. ${page.space.drawn}`;
  canvas.addEventListener("mousemove", (event) => {
    if (!(event.buttons & 1)) return;
    state.turn[0] += event.movementX * 0.01;
    state.turn[1] = Math.max(-1.5, Math.min(1.5, state.turn[1] + event.movementY * 0.01));
    requestAnimationFrame(drawSpace);
  });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    state.near = Math.max(0.3, Math.min(8, state.near * Math.exp(-event.deltaY * 0.001)));
    requestAnimationFrame(drawSpace);
  }, { passive: false });
}
