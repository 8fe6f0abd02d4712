// Turns the data of the page into branches, whose points are known at any place of the sweep.

/** The data of the page, which `film_json.hpp` writes with places relative to `origin`. */
function madeWith() {
  const data = JSON.parse(document.getElementById("film").textContent);
  for (const branch of data.branches) {
    branch.points = placed(numbersOf(branch.points), 2, data.origin);
    branch.outputs = placed(numbersOf(branch.outputs), 6, data.origin);
    branch.spreads = numbersOf(branch.spreads);
    branch.angles = numbersOf(branch.angles);
    branch.transmissions = numbersOf(branch.transmissions);
    branch.forces = numbersOf(branch.forces);
  }
  return data;
}

/** Numbers of 32 bits from text in base 64. */
function numbersOf(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  return new Float32Array(bytes.buffer);
}

/** Rows of numbers, each of which begins with x and y, with x and y in the scene's coordinates. */
function placed(numbers, width, origin) {
  const there = Float64Array.from(numbers);
  for (let at = 0; at < there.length; at += width) {
    there[at] += origin[0];
    there[at + 1] += origin[1];
  }
  return there;
}

/** The number that about a tenth of some numbers exceed; 0 if there are no numbers. */
function nearlyLargest(numbers) {
  numbers.sort((one, other) => one - other);
  return numbers.length === 0 ? 0 : numbers[Math.floor(0.9 * (numbers.length - 1))];
}

/** The largest number of 1, 2 or 5 times a power of ten that is not above a positive one. */
function roundBelow(most) {
  const power = 10 ** Math.floor(Math.log10(most));
  // The logarithm of a number just below a power of ten may be rounded up, so 0.5 comes last.
  return [5, 2, 1, 0.5].map((factor) => factor * power).find((one) => one <= most);
}

/** Rows theta, omega, alpha of each link, with theta continued by whole turns from step to step. */
function unwrapped(numbers, count) {
  const there = Float64Array.from(numbers);
  const width = there.length / count;
  for (let at = width; at < there.length; ++at) {
    const change = there[at] - there[at - width];
    if (at % width % 3 === 0 && Number.isFinite(change)) {
      there[at] -= 2 * Math.PI * Math.round(change / (2 * Math.PI));
    }
  }
  return there;
}

/** The stretches of steps at which a branch exists, as [first, last]. */
function stretchesOf(rows) {
  const stretches = [];
  for (let step = 0; step < rows.count; ++step) {
    if (Number.isNaN(rows.value(step, 0))) {
      continue;
    }
    const last = stretches.at(-1);
    last?.[1] === step - 1 ? last[1] = step : stretches.push([step, step]);
  }
  return stretches;
}

/** Rows of numbers, one for each step. */
class Rows {
  constructor(numbers, count) {
    this.numbers = numbers;
    this.width = this.numbers.length / count;
    this.count = count;
  }

  /** The row at a place between two steps, linear between them; null where its first number is not
   * known: where there is no branch. */
  at(place) {
    const step = Math.min(Math.floor(place), this.count - 1);
    const part = place - step;
    const next = Math.min(step + 1, this.count - 1);
    const row = new Float64Array(this.width);
    for (let column = 0; column < this.width; ++column) {
      const here = this.numbers[step * this.width + column];
      const there = this.numbers[next * this.width + column];
      row[column] = part === 0 ? here : here + part * (there - here);
    }
    return this.width > 0 && Number.isNaN(row[0]) ? null : row;
  }

  value(step, column) {
    return this.numbers[step * this.width + column];
  }
}

/** The largest length of vectors that stand in rows from a column on, one every few columns. Near dead
 * centres lengths have no bound, so the longest tenth is left out. */
function longestOf(rows, first, step) {
  const lengths = [];
  for (let row = 0; row < rows.numbers.length; row += rows.width) {
    for (let column = first; column + 1 < rows.width; column += step) {
      const length = Math.hypot(rows.numbers[row + column], rows.numbers[row + column + 1]);
      if (Number.isFinite(length)) {
        lengths.push(length);
      }
    }
  }
  return nearlyLargest(lengths);
}

/** A branch: the places of its points; x, y, vx, vy, ax, ay of each output; if outputs vary, the
 * variance of x, the covariance and the variance of y of each output; and, if they are known, the
 * angle, its rate and the rate of that of each link, the transmission angles, and the efforts of the
 * drivers with x and y of each force in a joint. */
class Branch {
  constructor(data, film) {
    this.number = data.number;
    this.circuit = data.circuit;  // 0 without a sweep
    this.next = data.next;        // the branch that goes on where this one ends the sweep, or 0
    this.points = new Rows(data.points, film.count);
    this.outputs = new Rows(data.outputs, film.count);
    this.spreads = new Rows(data.spreads, film.count);
    this.angles = new Rows(unwrapped(data.angles, film.count), film.count);
    this.transmissions = new Rows(data.transmissions, film.count);
    this.forces = new Rows(data.forces, film.count);
    this.stretches = stretchesOf(this.points);
    this.colour = (data.number - 1) % 6;
    this.dash = [[], [8, 5], [2, 4], [10, 4, 2, 4]][Math.floor((data.number - 1) / 6) % 4];
    this.box = this.extent();
    this.size = Math.max(this.box[2] - this.box[0], this.box[3] - this.box[1]) || 1;
    this.way = this.wayOfOutputs();
    this.longest = {
      velocity: longestOf(this.outputs, 2, 6),
      acceleration: longestOf(this.outputs, 4, 6),
      force: longestOf(this.forces, film.efforts.length, 2),
    };
    this.widest = this.widestSpread();
  }

  /** The curves of all outputs, from the corner of the branch's box and relative to its size,
   * because browsers drop curves whose coordinates are very small. */
  wayOfOutputs() {
    const way = new Path2D();
    const [left, low] = this.box;
    for (let column = 0; column < this.outputs.width; column += 6) {
      let goesOn = false;
      for (let step = 0; step < this.outputs.count; ++step) {
        const x = (this.outputs.value(step, column) - left) / this.size;
        const isThere = !Number.isNaN(x);
        if (isThere) {
          const y = (this.outputs.value(step, column + 1) - low) / this.size;
          goesOn ? way.lineTo(x, y) : way.moveTo(x, y);
        }
        goesOn = isThere;
      }
    }
    return way;
  }

  /** The largest deviation of the outputs, also without the largest tenth. */
  widestSpread() {
    const deviations = [];
    const { numbers } = this.spreads;
    for (let place = 0; place < numbers.length; place += 3) {
      const deviation = Math.sqrt(numbers[place] + numbers[place + 2]);
      if (Number.isFinite(deviation)) {
        deviations.push(deviation);
      }
    }
    return nearlyLargest(deviations);
  }

  /** The box of the branch: [least x, least y, greatest x, greatest y]. */
  extent() {
    const box = [Infinity, Infinity, -Infinity, -Infinity];
    const include = (rows, width) => {
      for (let place = 0; place < rows.numbers.length; place += width) {
        const x = rows.numbers[place];
        const y = rows.numbers[place + 1];
        if (Number.isFinite(x) && Number.isFinite(y)) {
          box[0] = Math.min(box[0], x);
          box[1] = Math.min(box[1], y);
          box[2] = Math.max(box[2], x);
          box[3] = Math.max(box[3], y);
        }
      }
    };
    include(this.points, 2);
    include(this.outputs, 6);
    return box;
  }

  /** The stretch of steps at or nearest to a place. */
  stretchAt(place) {
    const distance = ([first, last]) => Math.max(first - place, place - last, 0);
    return this.stretches.reduce((best, one) => (distance(one) < distance(best) ? one : best));
  }

  /** A place, or the one nearest to it at which the branch exists. */
  placeNear(place) {
    const [first, last] = this.stretchAt(place);
    return Math.min(Math.max(place, first), last);
  }
}

/** The factor by which ellipses are enlarged, so that the widest is at most a tenth of the picture:
 * 1, 2 or 5 times a power of ten; 0 where nothing varies. */
function magnification(widest, size) {
  if (!(widest > 0)) {
    return 0;
  }
  return roundBelow(0.1 * size / widest);
}

class Film {
  constructor(data) {
    Object.assign(this, data);
    this.branches = data.branches.map((branch) => new Branch(branch, data));
    const boxes = this.branches.map((branch) => branch.box);
    this.box = [0, 1, 2, 3].map((side) =>
      (side < 2 ? Math.min : Math.max)(...boxes.map((box) => box[side])));
    this.size = Math.hypot(this.box[2] - this.box[0], this.box[3] - this.box[1]) || 1;
    for (const branch of this.branches) {
      branch.magnification = magnification(branch.widest, this.size);
    }
    this.own = data.parameters.find(({ name }) => name === data.parameter)?.value ?? null;
    this.hasSpreads = this.branches.some((branch) => branch.magnification > 0);
    this.hasRates = this.branches.some((branch) => branch.longest.velocity > 0);
    this.hasForces = this.branches.some((branch) => branch.forces.width > 0);
    this.hasAngles = this.branches.some((branch) => branch.angles.width > 0);
    this.quantities = quantitiesOf(this);
  }

  /** The branch that is at the first step where another is at the last one, or the other way round;
   * undefined if there is none. */
  branchOverEnd(branch, forwards) {
    return forwards ? this.branch(branch.next)
      : this.branches.find((one) => one.next === branch.number);
  }

  isClosed(branch) {
    return branch.next === branch.number;
  }

  branch(number) {
    return this.branches.find((branch) => branch.number === number);
  }

  /** The swept parameter at a place. */
  parameterAt(place) {
    return this.count === 1 ? this.from : this.from + (this.to - this.from) * place / (this.count - 1);
  }

  placeOf(parameter) {
    return this.from === this.to ? 0 : (parameter - this.from) / (this.to - this.from) * (this.count - 1);
  }
}
