// The gears in space: faces by a depth buffer, and lines of contact over them.

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

/** Layers of faces: opaque ones, translucent ones over them, and those under load, which hide all others. */
const OPAQUE = 0, TRANSLUCENT = 1, LOADED = 2;

/** Part of what is seen through a translucent face that is its own. */
const COVER = 0.55;

/** Pixels of faces: in each layer those of the face nearest to the eye. */
class DepthBuffer {
  constructor(width, height) {
    [this.width, this.height] = [width, height];
    this.layers = [OPAQUE, TRANSLUCENT, LOADED].map(() => ({
      near: new Float32Array(width * height).fill(-Infinity), colour: new Uint32Array(width * height) }));
  }

  /** Fill a triangle, whose corners are [right, down, near], with a colour 0xrrggbb. */
  triangle(layer, [a, b, c], colour) {
    const { near, colour: colours } = this.layers[layer], edges = [[a, b], [b, c], [c, a]];
    const area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
    if (Math.abs(area) < 1e-9) return;
    const alongX = ((b[2] - a[2]) * (c[1] - a[1]) - (c[2] - a[2]) * (b[1] - a[1])) / area;
    const alongY = ((c[2] - a[2]) * (b[0] - a[0]) - (b[2] - a[2]) * (c[0] - a[0])) / area;
    const first = Math.max(0, Math.ceil(Math.min(a[1], b[1], c[1]) - 0.5));
    const last = Math.min(this.height - 1, Math.floor(Math.max(a[1], b[1], c[1]) - 0.5));
    for (let row = first; row <= last; row++) {
      const y = row + 0.5;
      let left = Infinity, right = -Infinity;
      for (const [p, q] of edges) {
        if ((p[1] <= y) === (q[1] <= y)) continue;
        const x = p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0]);
        [left, right] = [Math.min(left, x), Math.max(right, x)];
      }
      const stop = Math.min(this.width, Math.ceil(right - 0.5));
      for (let column = Math.max(0, Math.ceil(left - 0.5)); column < stop; column++) {
        const depth = a[2] + alongX * (column + 0.5 - a[0]) + alongY * (y - a[1]), n = row * this.width + column;
        if (depth <= near[n]) continue;
        near[n] = depth;
        colours[n] = colour;
      }
    }
  }

  /** The layers one over the other, on a canvas. */
  picture() {
    const canvas = document.createElement("canvas"), [opaque, translucent, loaded] = this.layers;
    [canvas.width, canvas.height] = [this.width, this.height];
    const pen = canvas.getContext("2d"), image = pen.createImageData(this.width, this.height), data = image.data;
    for (let n = 0; n < opaque.near.length; n++) {
      const front = loaded.near[n] > -Infinity ? loaded : opaque;
      const over = front === opaque && translucent.near[n] > opaque.near[n];
      if (front.near[n] === -Infinity && !over) continue;
      const behind = front.near[n] > -Infinity ? front.colour[n] : 0xffffff, cover = translucent.colour[n];
      for (let k = 0, bits = 16; k < 3; k++, bits -= 8) {
        const below = behind >> bits & 255;
        data[4 * n + k] = over ? COVER * (cover >> bits & 255) + (1 - COVER) * below : below;
      }
      data[4 * n + 3] = 255;
    }
    pen.putImageData(image, 0, 0);
    return canvas;
  }
}

/** Draw the faces of a shape; `to` turns what the view sees into pixels. */
function drawShape(buffer, shape, points, pressures, most, to) {
  const heat = coloursOf({ colours: "inferno" }), base = bodyColours[shape.body], step = pressures ? 1 : shape.stride;
  const layer = shape.body === 1 && !page.space.lines.length ? TRANSLUCENT : OPAQUE;
  for (let row = 0; row + step < shape.rows; row += step) for (let column = 0; column + step < shape.columns; column += step) {
    const first = row * shape.columns + column, below = first + step * shape.columns;
    const corners = [first, first + step, below + step, below], at = corners.map((n) => points[n]);
    if (at.some((of) => !Number.isFinite(of[0]))) continue;
    const [u, v] = [[at[2], at[0]], [at[3], at[1]]].map(([end, from]) => end.map((of, n) => of - from[n]));
    const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const area = Math.hypot(...normal);
    if (area < 1e-6 * page.space.size ** 2) continue;
    const light = Math.min(1, 0.45 + 0.55 * Math.abs(0.3 * normal[0] + 0.3 * normal[1] + normal[2]) / (1.2 * area));
    const load = pressures ? Math.max(...corners.map((n) => pressures[n])) : 0, loaded = load > 0.05 * most;
    const [red, green, blue] = loaded ? heat(load, 0, most) : base.map((of) => Math.round(of * light));
    const colour = red << 16 | green << 8 | blue, [a, b, c, d] = at.map(to);
    for (const triangle of [[a, b, c], [a, c, d]]) buffer.triangle(loaded ? LOADED : layer, triangle, colour);
  }
}

function drawSpace() {
  const canvas = element("space");
  if (!page.space || !canvas.clientWidth) return;  // nothing is seen before the page has a width
  const ratio = window.devicePixelRatio || 1, width = canvas.clientWidth, height = 420;
  [canvas.width, canvas.height] = [width * ratio, height * ratio];
  canvas.style.height = `${height}px`;
  const pen = canvas.getContext("2d"), view = viewOf(), finer = Math.max(1, 2 / ratio);  // two pixels: smooth edges
  const { shapes, lines, size } = page.space, touching = shapes.find((of) => of.pressures.length);
  const middle = touching ? centre(touching) : meanOf(lines.flat());
  const most = touching ? span(touching.pressures.map(unpacked))[1] : 1;
  const scale = ratio * state.near * Math.min(width, height) / size;
  const across = (x) => canvas.width / 2 + scale * x, down = (y) => 0.62 * canvas.height - scale * y;
  const buffer = new DepthBuffer(Math.round(finer * canvas.width), Math.round(finer * canvas.height));
  for (const shape of shapes) for (const [number, copy] of [0, ...shape.copies].entries()) {
    const points = seen(shape, turnOf(shape) + copy, view, middle);
    const pressures = number === 0 && shape.pressures.length ? unpacked(shape.pressures[state.scene]) : null;
    drawShape(buffer, shape, points, pressures, most, ([x, y, near]) => [finer * across(x), finer * down(y), near]);
  }
  pen.drawImage(buffer.picture(), 0, 0, canvas.width, canvas.height);
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
