// Turns a place of the film into a picture of the mechanism on a canvas.

/** The colours of the page's style that were read so far, since reading takes long. */
const knownColours = new Map();

/** A colour of the page's style. */
function colour(name) {
  if (!knownColours.has(name)) {
    const style = getComputedStyle(document.documentElement);
    knownColours.set(name, style.getPropertyValue(`--${name}`).trim());
  }
  return knownColours.get(name);
}

/** Clears a canvas, at the size in which the screen shows it; returns its context in CSS pixels. */
function cleared(canvas) {
  const ratio = window.devicePixelRatio || 1;
  const width = Math.round(canvas.clientWidth * ratio);
  const height = Math.round(canvas.clientHeight * ratio);
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, canvas.clientWidth, canvas.clientHeight);
  context.lineCap = "round";
  context.lineJoin = "round";
  return context;
}

class Stage {
  /** `film` must be set before `draw` is called, and may be set again. */
  constructor(canvas) {
    this.canvas = canvas;
    this.view = new View();
    this.arrows = new Arrows(this);
    this.cornersOfNames = new Map();
  }

  /** `options`: chosen (a branch's number), all, ways, names, velocity, acceleration, force, spread. */
  draw(place, options) {
    const context = cleared(this.canvas);
    this.context = context;
    this.unit = Math.min(1.6, Math.max(1.05, this.canvas.clientWidth / 400));
    const chosen = this.film.branch(options.chosen);
    this.view.fit(options.all ? this.film.box : chosen.box, this.canvas.clientWidth,
      this.canvas.clientHeight, 30 * this.unit);
    if (options.all) {
      for (const branch of this.film.branches.filter((one) => one !== chosen)) {
        context.globalAlpha = 0.45;
        this.begin(branch, 1.1);
        context.setLineDash(branch.dash);
        this.outline(branch.points.at(place));
        context.setLineDash([]);
        this.ways(branch, options);
      }
      context.globalAlpha = 1;
    }
    const points = chosen.points.at(place) || chosen.points.at(chosen.placeNear(place));
    const isThere = chosen.points.at(place) !== null;
    this.ground(points);
    this.begin(chosen, 1.2);
    this.ways(chosen, options);
    if (isThere) {
      this.links(points, chosen);
      this.spreads(chosen, place, options);
      this.arrows.vectors(chosen, chosen.outputs.at(place), options);
      this.arrows.forces(chosen, points, place, options);
      if (options.names) {
        this.names(points);
      }
    }
    this.scale();
  }

  at(x, y) {
    return this.view.at(x, y);
  }

  point(points, place) {
    return this.at(points[2 * place], points[2 * place + 1]);
  }

  begin(branch, width) {
    this.context.strokeStyle = colour(`c${branch.colour}`);
    this.context.fillStyle = this.context.strokeStyle;
    this.context.lineWidth = width * this.unit;
  }

  path(corners, closed = false) {
    this.context.beginPath();
    corners.forEach((corner, place) =>
      place === 0 ? this.context.moveTo(...corner) : this.context.lineTo(...corner));
    if (closed) {
      this.context.closePath();
    }
  }

  line(corners, width, closed = false) {
    this.context.lineWidth = width * this.unit;
    this.path(corners, closed);
    this.context.stroke();
  }

  corners(shape, points) {
    return shape.points.map((place) => this.point(points, place));
  }

  outline(points) {
    if (points === null) {
      return;
    }
    for (const shape of this.film.shapes) {
      if (["bar", "plate", "rod", "tube"].includes(shape.symbol)) {
        this.path(this.corners(shape, points), shape.symbol === "plate");
        this.context.stroke();
      }
    }
  }

  ways(branch, options) {
    if (!options.ways) {
      return;
    }
    const { context } = this;
    const zoom = this.view.now.zoom * branch.size;
    context.save();
    context.transform(zoom, 0, 0, -zoom, ...this.at(branch.box[0], branch.box[1]));
    context.lineWidth /= zoom;
    context.stroke(branch.way);
    context.restore();
  }

  /** Draws what does not move: supports, guides and slots of the ground. */
  ground(points) {
    this.context.strokeStyle = colour("muted");
    for (const shape of this.film.shapes.filter((one) => one.fixed && one.symbol !== "tracer")) {
      const at = this.corners(shape, points);
      if (shape.symbol === "pin") {
        this.support(at[0]);
      } else {
        const isSlot = shape.symbol === "slot";
        this.hatching(at[0], at[1], isSlot ? 4.3 * this.unit : 0);
        isSlot ? this.slot(at, colour("muted")) : this.line(at, 1.4);
      }
    }
  }

  support([x, y]) {
    const [wide, high] = [7 * this.unit, 10 * this.unit];
    this.line([[x, y], [x - wide, y + high], [x + wide, y + high]], 1.1, true);
    this.hatching([x - 1.3 * wide, y + high], [x + 1.3 * wide, y + high], 0);
    this.line([[x - 1.3 * wide, y + high], [x + 1.3 * wide, y + high]], 1.3);
  }

  /** Short strokes on the lower side of a line. */
  hatching(from, to, aside) {
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    const along = length > 0 ? [(to[0] - from[0]) / length, (to[1] - from[1]) / length] : [1, 0];
    const turn = along[0] < 0 || (along[0] === 0 && along[1] > 0) ? -1 : 1;
    const side = [-turn * along[1], turn * along[0]];
    const step = 5.5 * this.unit;
    const stroke = 4.8 * this.unit;
    for (let far = (length % step) / 2; far <= length; far += step) {
      const foot = [0, 1].map((axis) => from[axis] + far * along[axis] + aside * side[axis]);
      const end = [0, 1].map((axis) => foot[axis] + stroke * (0.8 * side[axis] - 0.6 * along[axis]));
      this.line([foot, end], 0.7);
    }
  }

  slot(at, edge) {
    this.context.strokeStyle = edge;
    this.line(at, 8.6);
    this.context.strokeStyle = colour("paper");
    this.line(at, 6.2);
    this.context.strokeStyle = edge;
  }

  /** A rectangle about a line, filled with the colour of the page. */
  rectangle(from, to, half) {
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
    const aside = [-half * (to[1] - from[1]) / length, half * (to[0] - from[0]) / length];
    const corner = (end, sign) => [end[0] + sign * aside[0], end[1] + sign * aside[1]];
    this.path([corner(from, 1), corner(to, 1), corner(to, -1), corner(from, -1)], true);
    this.context.fillStyle = colour("paper");
    this.context.fill();
    this.context.lineWidth = 1.3 * this.unit;
    this.context.stroke();
  }

  /** Draws the links from back to front. */
  links(points, branch) {
    const order = ["plate", "bar", "rod", "tube", "guide", "slot", "block", "pin", "tracer"];
    const own = colour(`c${branch.colour}`);
    for (const symbol of order) {
      for (const shape of this.film.shapes.filter((one) => one.symbol === symbol)) {
        const isOfGround = shape.fixed && (symbol === "slot" || symbol === "guide");
        if (!isOfGround) {
          this.context.strokeStyle = own;
          this.context.fillStyle = own;
          this.symbol(symbol, this.corners(shape, points), own);
        }
      }
    }
  }

  symbol(symbol, at, own) {
    const towards = (from, to, far) => {
      const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
      return [from[0] + far * (to[0] - from[0]) / length, from[1] + far * (to[1] - from[1]) / length];
    };
    if (symbol === "plate") {
      this.path(at, true);
      this.context.globalAlpha = 0.16;
      this.context.fill();
      this.context.globalAlpha = 1;
      this.line(at, 1.5, true);
    } else if (symbol === "bar") {
      this.line(at, 2.8);
    } else if (symbol === "rod") {
      this.line(at, 2.2);
    } else if (symbol === "tube") {
      const begin = towards(at[0], at[1], 5 * this.unit);
      this.line([at[0], begin], 2.8);
      this.rectangle(begin, at[1], 4 * this.unit);
    } else if (symbol === "guide") {
      this.line(at, 1);
    } else if (symbol === "slot") {
      this.slot(at, own);
    } else if (symbol === "block") {
      const half = 7.5 * this.unit;
      this.rectangle(towards(at[0], at[1], -half), towards(at[0], at[1], half), 4.8 * this.unit);
    } else {
      const isPin = symbol === "pin";
      this.context.beginPath();
      this.context.arc(...at[0], (isPin ? 3.2 : 1.8) * this.unit, 0, 2 * Math.PI);
      this.context.fillStyle = isPin ? colour("paper") : own;
      this.context.fill();
      if (isPin) {
        this.context.strokeStyle = colour("ink");
        this.context.lineWidth = 1.1 * this.unit;
        this.context.stroke();
      }
    }
  }

  /** The ellipse of each output's covariance: the image of a circle under a root of the matrix. */
  spreads(branch, place, options) {
    const rows = branch.spreads.at(place);
    const outputs = branch.outputs.at(place);
    if (!options.spread || rows === null || outputs === null) {
      return;
    }
    const size = branch.magnification;
    for (let output = 0; 3 * output < rows.length; ++output) {
      const [xx, xy, yy] = rows.subarray(3 * output, 3 * output + 3);
      const wide = Math.sqrt(xx);
      const slant = wide > 0 ? xy / wide : 0;
      const high = Math.sqrt(Math.max(yy - slant * slant, 0));
      this.path(Array.from({ length: 72 }, (_, part) => {
        const [cos, sin] = [Math.cos(part * Math.PI / 36), Math.sin(part * Math.PI / 36)];
        return this.at(outputs[6 * output] + size * wide * cos,
          outputs[6 * output + 1] + size * (slant * cos + high * sin));
      }), true);
      this.context.fillStyle = colour("c3");
      this.context.strokeStyle = colour("c3");
      this.context.globalAlpha = 0.25;
      this.context.fill();
      this.context.globalAlpha = 1;
      this.context.lineWidth = 1.4 * this.unit;
      this.context.stroke();
    }
  }

  /** Writes each name once per point, in a corner of the point that is free of other names: that of
   * the previous picture, if it is free, so that names do not jump. */
  names(points) {
    const height = 11 * Math.min(this.unit, 1.4);
    this.context.fillStyle = colour("ink");
    this.context.font = `italic ${height}px system-ui, sans-serif`;
    const told = new Set();
    const taken = [];
    for (const shape of this.film.shapes.filter((one) => ["pin", "tracer"].includes(one.symbol))) {
      const key = `${shape.points[0]} ${shape.name}`;
      if (told.has(key)) {
        continue;
      }
      told.add(key);
      const [x, y] = this.point(points, shape.points[0]);
      const width = this.context.measureText(shape.name).width;
      const far = 5 * this.unit;
      const corners = [[far, -far], [far, far + 0.7 * height], [-far - width, -far],
        [-far - width, far + 0.7 * height]];
      const box = ([right, down]) => [x + right, y + down - height, x + right + width, y + down + 2];
      const isFree = (corner) => taken.every((other) => {
        const own = box(corner);
        return own[0] > other[2] || other[0] > own[2] || own[1] > other[3] || other[1] > own[3];
      });
      const before = this.cornersOfNames.get(key) || 0;
      const order = [before, ...[0, 1, 2, 3].filter((one) => one !== before)];
      const corner = order.find((one) => isFree(corners[one]));
      if (corner !== undefined) {
        this.cornersOfNames.set(key, corner);
        taken.push(box(corners[corner]));
        this.context.fillText(shape.name, x + corners[corner][0], y + corners[corner][1]);
      }
    }
  }

  scale() {
    const length = roundBelow(90 * this.unit / this.view.now.zoom);
    const [x, y] = [12, this.canvas.clientHeight - 14];
    const end = x + length * this.view.now.zoom;
    this.context.strokeStyle = colour("ink");
    this.context.fillStyle = colour("ink");
    this.line([[x, y], [end, y]], 1.1);
    this.line([[x, y - 4], [x, y + 4]], 1.1);
    this.line([[end, y - 4], [end, y + 4]], 1.1);
    this.context.font = "13px system-ui, sans-serif";
    this.context.fillText(`${Number(length.toPrecision(6))} ${this.film.unit}`.trim(), end + 6, y + 4);
  }
}
