// Turns velocities, accelerations and forces into arrows on the stage. The arrows of one kind are
// scaled alike along a branch.

class Arrows {
  constructor(stage) {
    this.stage = stage;
  }

  /** Velocities and accelerations of the outputs. */
  vectors(branch, outputs, options) {
    const kinds = [["velocity", 2, "c1"], ["acceleration", 4, "c2"]];
    for (const [kind, offset, name] of kinds.filter(([kind]) => options[kind])) {
      const scale = 0.2 * this.stage.film.size / (branch.longest[kind] || 1);
      for (let column = 0; outputs !== null && column < outputs.length; column += 6) {
        const vector = [scale * outputs[column + offset], scale * outputs[column + offset + 1]];
        if (vector.every(Number.isFinite)) {
          const foot = [outputs[column], outputs[column + 1]];
          this.arrow(this.stage.at(...foot), this.stage.at(foot[0] + vector[0], foot[1] + vector[1]), colour(name));
        }
      }
    }
  }

  /** The forces in joints, at the joints, on the links that the table names. */
  forces(branch, points, place, options) {
    if (!options.force || !this.stage.film.hasForces) {
      return;
    }
    const scale = 0.2 * this.stage.film.size / (branch.longest.force || 1);
    const first = this.stage.film.efforts.length;
    this.stage.film.forces.forEach(({ joint }, one) => {
      const shape = this.stage.film.shapes.find(({ name, symbol }) => name === joint && symbol !== "tracer");
      const force = [0, 1].map((axis) =>
        scale * branch.forces.value(Math.round(place), first + 2 * one + axis));
      if (shape && force.every(Number.isFinite)) {
        const foot = [0, 1].map((axis) => points[2 * shape.points[0] + axis]);
        this.arrow(this.stage.at(...foot), this.stage.at(foot[0] + force[0], foot[1] + force[1]), colour("c3"));
      }
    });
  }

  /** An arrow between two places on the stage. */
  arrow(from, to, own) {
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    if (length < 2) {
      return;
    }
    const head = Math.min(8 * this.stage.unit, 0.6 * length);
    const [x, y] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
    this.stage.context.strokeStyle = own;
    this.stage.context.fillStyle = own;
    this.stage.line([from, [to[0] - 0.8 * head * x, to[1] - 0.8 * head * y]], 1.8);
    this.stage.path([to, [to[0] - head * (x - 0.4 * y), to[1] - head * (y + 0.4 * x)],
      [to[0] - head * (x + 0.4 * y), to[1] - head * (y - 0.4 * x)]], true);
    this.stage.context.fill();
  }
}
