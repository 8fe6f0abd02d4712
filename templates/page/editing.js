// Turns gestures and keys on drawn points into a changed drawing.

/** A step of coordinates that is no longer than a pixel: a power of ten. */
function grainAt(zoom) {
  return 10 ** Math.floor(Math.log10(1 / zoom));
}

/** A number on a grid of steps, with no more digits than the grid has. */
function onGrid(value, grain) {
  return Number((Math.round(value / grain) * grain).toPrecision(12));
}

class Editing {
  /** `ask` is called after each change, with whether it is complete. */
  constructor(ask) {
    this.ask = ask;
    this.isOn = false;
    this.begin(null);
  }

  /** Takes another scene. */
  begin(scene) {
    this.scene = scene;
    this.draft = null;          // the film of the drawn pose
    this.places = new Map();    // of the drawn points
    this.selected = null;
    this.undone = [];           // what `restore` of the scene takes, the last one last
  }

  /** Takes over where the points are. A point in hand is where the hand has it. */
  read(film) {
    this.places = new Map(film.drawing.map(({ name, x, y }) => [name, [x, y]]));
    if (!this.places.has(this.selected)) {
      this.selected = this.places.keys().next().value ?? null;
    }
  }

  canMove(point) {
    return [0, 1].some((axis) => this.scene.handle(point, axis).kind !== "formula");
  }

  /** The drawn point at a place on the stage; of several, the one that can be moved. */
  pointAt([x, y], reach, view) {
    const near = [...this.places].map(([name, place]) => {
      const [u, v] = view.at(...place);
      return { name, distance: Math.hypot(u - x, v - y), isFixed: !this.canMove(name) };
    }).filter(({ distance }) => distance <= reach);
    near.sort((one, other) => one.isFixed - other.isFixed || one.distance - other.distance);
    return near[0]?.name ?? null;
  }

  /** What follows a pointer that is put on a drawn point; null where there is none. */
  grip(at, reach, view, isHovering) {
    const point = this.pointAt(at, reach, view);
    if (point === null || isHovering) {
      return point;
    }
    this.selected = point;
    const begin = this.places.get(point);
    const under = view.under(at);
    let isMoved = false;
    return {
      move: (place, { shiftKey }) => {
        const now = view.under(place);
        const way = [0, 1].map((axis) => now[axis] - under[axis]);
        const axis = Math.abs(way[0]) < Math.abs(way[1]) ? 0 : 1;
        if (shiftKey) {
          way[axis] = 0;
        }
        if (!isMoved) {
          this.remember();
          isMoved = true;
        }
        const grain = grainAt(view.now.zoom);
        this.move(point, [0, 1].map((one) =>
          (way[one] === 0 ? begin[one] : onGrid(begin[one] + way[one], grain))), false);
      },
      end: () => isMoved && this.ask(true),
    };
  }

  remember() {
    this.undone.push(this.scene.remembered());
  }

  move(point, place, isComplete) {
    const there = this.places.get(point);
    this.places.set(point, place.map((value, axis) =>
      (this.scene.handle(point, axis).kind === "formula" ? there[axis] : value)));
    this.scene.movePoint(point, place);
    this.ask(isComplete);
  }

  /** Moves the selected point by numbers of grains, right and up. */
  nudge(right, up, grain) {
    if (this.selected === null || !this.canMove(this.selected)) {
      return;
    }
    this.remember();
    const [x, y] = this.places.get(this.selected);
    this.move(this.selected, [right === 0 ? x : onGrid(x + right * grain, grain),
      up === 0 ? y : onGrid(y + up * grain, grain)], true);
  }

  /** Gives a coordinate of the selected point a value. */
  set(axis, value) {
    if (this.selected === null || !Number.isFinite(value)) {
      return;
    }
    this.remember();
    const place = [...this.places.get(this.selected)];
    place[axis] = value;
    this.move(this.selected, place, true);
  }

  undo() {
    const last = this.undone.pop();
    if (last) {
      this.scene.restore(last);
      this.ask(true);
    }
  }
}
