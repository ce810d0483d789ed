"use strict";
// Data, state and what all panels share.

const page = JSON.parse(document.getElementById("data").textContent);
const state = { scene: 0, field: Object.keys(page.fields)[0], range: "all", picked: null,
  flankField: Object.keys(page.maps)[0], turn: [-0.6, 0.4], near: 1 };
const element = (id) => document.getElementById(id);

/** Numbers of `packed` (packed.py); kept with what they came from. */
function unpacked(content) {
  if (!content.values) {
    const text = atob(content.data), count = text.length / 2;
    content.values = new Float32Array(count);
    for (let n = 0; n < count; n++) {
      const number = text.charCodeAt(2 * n) | (text.charCodeAt(2 * n + 1) << 8);
      const value = number === 65535 ? NaN : content.low + content.step * number;
      content.values[n] = content.logarithmic ? Math.exp(value) : value;
    }
    delete content.data;
  }
  return content.values;
}

const place = (axis, part) => axis[0] + (axis[1] - axis[0]) * part / (axis[2] - 1);
const node = (axis, at) => Math.round((at - axis[0]) / (axis[1] - axis[0]) * (axis[2] - 1));
const inside = (axis, n) => n >= 0 && n < axis[2];
const shownNumber = (value) => Number.isFinite(value) ? String(+value.toPrecision(4)) : "none";

/** Least and largest of some arrays, without what is missing. */
function span(arrays) {
  let low = Infinity, high = -Infinity;
  for (const values of arrays) for (const value of values) {
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return high > low ? [low, high] : [low - 0.5, low + 0.5];
}

/** Values between which colours and profiles of a quantity go; films end at some times the least. */
function limits(quantity, arrays) {
  const [low, high] = span(arrays);
  if (quantity.clip) return [low, Math.min(high, quantity.clip * low)];
  return low < 0.3 * high && low >= 0 ? [0, high] : [low, high];
}

function coloursOf(quantity) {
  const map = quantity.colours;
  if (typeof page.colours[map][0] === "string")
    page.colours[map] = page.colours[map].map((of) => [1, 3, 5].map((at) => parseInt(of.slice(at, at + 2), 16)));
  const steps = page.colours[map];
  return (value, low, high) => {
    const at = Math.floor((value - low) / (high - low) * steps.length);
    return steps[Math.max(0, Math.min(steps.length - 1, at))];
  };
}

/** Round places between two ends, about as many as asked for. */
function ticks(low, high, count) {
  const rough = (high - low) / count, size = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].find((of) => of * size >= rough) * size, found = [];
  for (let n = Math.ceil(low / step - 1e-9); n * step <= high + 1e-9 * step; n++) found.push(+(n * step).toPrecision(10));
  return found;
}

/** Least side of a panel with equal scales [pixels]. */
const SHORTEST_SIDE = 110;

/** Note of a label: scales of x and y are equal unless it says so. */
const scalesOf = (panel) => panel.even ? "" : " (scales of x and y differ)";

/** A canvas with its frame: scales of two axes, labels, and the way back from a pointer. */
class Panel {
  constructor(id, height, right = 16) {
    this.canvas = element(id);
    this.height = height;
    this.margin = { left: 64, right, top: 10, bottom: 38 };
  }

  /** Empty it at its present width; x and y are [low, high]. Up to a height their scales are equal (`even`), unless
   * a side would get too short to read. */
  begin(x, y, highest = 0) {
    const ratio = window.devicePixelRatio || 1, width = this.canvas.clientWidth, margin = this.margin;
    const room = width - margin.left - margin.right, spans = [x[1] - x[0], y[1] - y[0]];
    const scale = Math.min(room / spans[0], (highest - margin.top - margin.bottom) / spans[1]);
    this.even = Math.min(...spans) * scale >= SHORTEST_SIDE;
    const side = this.even ? spans[0] * scale : room;
    const height = this.even ? spans[1] * scale + margin.top + margin.bottom : this.height;
    this.canvas.width = width * ratio;
    this.canvas.height = height * ratio;
    this.canvas.style.height = `${height}px`;
    this.pen = this.canvas.getContext("2d");
    this.pen.scale(ratio, ratio);
    this.pen.font = "12px system-ui, 'DejaVu Sans', sans-serif";
    this.box = [margin.left + (room - side) / 2, margin.top, side, height - margin.top - margin.bottom];
    this.x = x;
    this.y = y;
    return this.pen;
  }

  right(value) { return this.box[0] + (value - this.x[0]) / (this.x[1] - this.x[0]) * this.box[2]; }
  down(value) { return this.box[1] + (this.y[1] - value) / (this.y[1] - this.y[0]) * this.box[3]; }

  /** Values under the pointer; null beside the frame. */
  under(event) {
    const [left, top, width, height] = this.box, at = [event.offsetX - left, event.offsetY - top];
    if (at[0] < 0 || at[1] < 0 || at[0] > width || at[1] > height) return null;
    return [this.x[0] + at[0] / width * (this.x[1] - this.x[0]), this.y[1] - at[1] / height * (this.y[1] - this.y[0])];
  }

  frame(labelX, labelY) {
    const pen = this.pen, [left, top, width, height] = this.box;
    pen.strokeStyle = "#5d6b7c";
    pen.fillStyle = "#1c2430";
    pen.lineWidth = 1;
    pen.strokeRect(left, top, width, height);
    pen.textAlign = "center";
    for (const at of ticks(...this.x, Math.max(3, width / 90))) {
      pen.fillRect(this.right(at) - 0.5, top + height, 1, 4);
      pen.fillText(at, this.right(at), top + height + 17);
    }
    pen.fillText(labelX, left + width / 2, top + height + 33);
    pen.textAlign = "right";
    for (const at of ticks(...this.y, Math.max(2, height / 50))) {
      pen.fillRect(left - 4, this.down(at) - 0.5, 4, 1);
      pen.fillText(at, left - 7, this.down(at) + 4);
    }
    pen.save();
    pen.translate(left - 51, top + height / 2);
    pen.rotate(-Math.PI / 2);
    pen.textAlign = "center";
    pen.fillText(labelY, 0, 0);
    pen.restore();
  }

  /** Values row by row over axes [first, last, count], as colours; what is missing stays white. */
  image(values, axisX, axisY, quantity, low, high) {
    const picture = document.createElement("canvas"), colour = coloursOf(quantity);
    [picture.width, picture.height] = [axisX[2], axisY[2]];
    const pen = picture.getContext("2d"), data = pen.createImageData(axisX[2], axisY[2]);
    for (let row = 0; row < axisY[2]; row++) for (let column = 0; column < axisX[2]; column++) {
      const value = values[row * axisX[2] + column], at = 4 * ((axisY[2] - 1 - row) * axisX[2] + column);
      if (Number.isFinite(value)) data.data.set([...colour(value, low, high), 255], at);
    }
    pen.putImageData(data, 0, 0);
    const half = [axisX, axisY].map((axis) => (axis[1] - axis[0]) / (axis[2] - 1) / 2);
    const left = this.right(axisX[0] - half[0]), top = this.down(axisY[1] + half[1]);
    this.pen.save();
    this.pen.beginPath();
    this.pen.rect(...this.box);
    this.pen.clip();
    this.pen.drawImage(picture, left, top, this.right(axisX[1] + half[0]) - left, this.down(axisY[0] - half[1]) - top);
    this.pen.restore();
  }

  /** The colours with their values, right of the frame. */
  bar(quantity, low, high) {
    const pen = this.pen, [left, top, width, height] = this.box, x = left + width + 14, colour = coloursOf(quantity);
    for (let n = 0; n < height; n++) {
      pen.fillStyle = `rgb(${colour(high - (high - low) * n / height, low, high)})`;
      pen.fillRect(x, top + n, 14, 1.5);
    }
    pen.fillStyle = "#1c2430";
    pen.textAlign = "left";
    for (const at of ticks(low, high, Math.max(2, height / 40)))
      pen.fillText(at, x + 18, top + height * (high - at) / (high - low) + 4);
  }

  line(xs, ys, colour, width = 1.5, dash = []) {
    const pen = this.pen;
    pen.save();
    pen.beginPath();
    pen.rect(...this.box);
    pen.clip();
    pen.beginPath();
    pen.strokeStyle = colour;
    pen.lineWidth = width;
    pen.setLineDash(dash);
    let down = false;
    for (let n = 0; n < xs.length; n++) {
      if (!Number.isFinite(ys[n])) { down = false; continue; }
      pen[down ? "lineTo" : "moveTo"](this.right(xs[n]), this.down(ys[n]));
      down = true;
    }
    pen.stroke();
    pen.restore();
  }

  mark(x, y, colour) {
    this.pen.beginPath();
    this.pen.arc(this.right(x), this.down(y), 5, 0, 7);
    this.pen.fillStyle = colour;
    this.pen.fill();
    this.pen.strokeStyle = "#1c2430";
    this.pen.lineWidth = 1.5;
    this.pen.stroke();
  }
}

const scene = () => page.scenes[state.scene];
const quantity = () => page.fields[state.field];
const label = (of) => of.unit ? `${of.label} / ${of.unit}` : of.label;
const fieldOf = (one) => one.fields[state.field] ? unpacked(one.fields[state.field]) : new Float32Array(0);

/** The limits of the field shown, of this contact or of all. */
function fieldLimits() {
  const arrays = state.range === "one" ? [fieldOf(scene())] : page.scenes.map(fieldOf);
  return limits(quantity(), arrays);
}
