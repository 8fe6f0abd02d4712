// Turns pointers on the stage into gestures: one that begins on a part drags it, another one moves
// the picture, two pinch it.

class Hand {
  /** `grip` takes a place on the stage and how far away from it parts may be, and returns what
   * follows a pointer that is put there, {move(place, event), end()}, or null for the picture. */
  constructor(canvas, view, { grip, changed }) {
    Object.assign(this, { canvas, view, grip, changed });
    this.pointers = new Map();
    this.held = null;
    const on = (name, act) => canvas.addEventListener(name, act);
    on("pointerdown", (event) => this.down(event));
    on("pointermove", (event) => this.move(event));
    for (const name of ["pointerup", "pointercancel"]) {
      on(name, (event) => this.up(event));
    }
    on("dblclick", () => {
      view.showAll();
      changed();
    });
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 30 : 1;
      view.enlarge(Math.exp(-0.0015 * lines * event.deltaY), [event.offsetX, event.offsetY]);
      changed();
    }, { passive: false });
  }

  reach(event) {
    return event.pointerType === "touch" ? 24 : 12;
  }

  down(event) {
    if (event.button > 0) {
      return;
    }
    // A pointer that is not on a screen, as in a test, cannot be captured.
    try {
      this.canvas.setPointerCapture(event.pointerId);
    } catch { /* it works without, until it leaves the stage */ }
    const place = [event.offsetX, event.offsetY];
    this.pointers.set(event.pointerId, place);
    if (this.pointers.size === 1) {
      this.held = this.grip(place, this.reach(event));
    } else {
      this.release();
    }
  }

  move(event) {
    const place = [event.offsetX, event.offsetY];
    const before = this.pointers.get(event.pointerId);
    if (!before) {
      this.canvas.style.cursor = this.grip(place, this.reach(event), true) ? "grab" : "";
      return;
    }
    const others = [...this.pointers].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
    this.pointers.set(event.pointerId, place);
    if (this.held) {
      this.held.move(place, event);
    } else if (others.length === 0) {
      this.view.pan(place[0] - before[0], place[1] - before[1]);
    } else {
      this.pinch(before, place, others[0]);
    }
    this.changed();
  }

  /** The places under both pointers stay under them. */
  pinch(before, now, other) {
    const distance = (from) => Math.hypot(from[0] - other[0], from[1] - other[1]);
    const middle = (from) => [0, 1].map((axis) => (from[axis] + other[axis]) / 2);
    const [old, next] = [middle(before), middle(now)];
    this.view.enlarge(distance(now) / (distance(before) || 1), old);
    this.view.pan(next[0] - old[0], next[1] - old[1]);
  }

  up(event) {
    this.pointers.delete(event.pointerId);
    this.release();
  }

  release() {
    this.held?.end();
    this.held = null;
  }
}
