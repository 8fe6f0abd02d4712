// Turns a drawing into marks on the stage: its links dashed, a square at each point, and a label with
// the coordinates and lengths at the chosen one.

class Marks {
  constructor(stage) {
    this.stage = stage;
  }

  /** The listed links where they are drawn. */
  pose(scene, places) {
    const { context, unit } = this.stage;
    context.strokeStyle = colour("muted");
    context.lineWidth = 1.1 * unit;
    context.setLineDash([5, 4]);
    for (const [name, list] of Object.entries(scene.json.links)) {
      if (name === "ground" || !Array.isArray(list)) {
        continue;
      }
      const corners = list.filter((point) => places.has(point))
        .map((point) => this.stage.at(...places.get(point)));
      this.stage.path(corners, corners.length > 2);
      context.stroke();
    }
    context.setLineDash([]);
  }

  squares(editing) {
    const { context, unit } = this.stage;
    const half = 6 * unit;
    for (const [name, place] of editing.places) {
      const [x, y] = this.stage.at(...place);
      const isSelected = name === editing.selected;
      context.strokeStyle = colour(!editing.canMove(name) ? "muted" : isSelected ? "c1" : "c0");
      context.lineWidth = (isSelected ? 2.2 : 1.2) * unit;
      context.strokeRect(x - half, y - half, 2 * half, 2 * half);
    }
    if (editing.selected !== null) {
      this.label(editing);
    }
  }

  label({ scene, places, selected }) {
    const { context, unit, canvas } = this.stage;
    const [x, y] = places.get(selected);
    const lines = [`${selected}  x ${shortNumber(x)}  y ${shortNumber(y)}`];
    const lengths = scene.lengthsAt(selected, places).slice(0, 6).map(({ name, length, isFixed }) =>
      `${name} ${shortNumber(length)}${isFixed ? " (fixed)" : ""}`);
    for (let first = 0; first < lengths.length; first += 2) {
      lines.push(lengths.slice(first, first + 2).join("   "));
    }
    context.font = `${12 * Math.min(unit, 1.2)}px system-ui, sans-serif`;
    context.textAlign = "left";
    const high = 17 * Math.min(unit, 1.2);
    const width = 16 + Math.max(...lines.map((line) => context.measureText(line).width));
    const height = 8 + high * lines.length;
    const [u, v] = this.stage.at(x, y);
    const gap = 16 * unit;
    const room = [canvas.clientWidth - width - 2, canvas.clientHeight - height - 2];
    // On a narrow stage the label would hide the drawing, and stands in a corner.
    const isNarrow = canvas.clientWidth < 480;
    const beside = [u - width - gap > 2 ? u - width - gap : u + gap,
      v - height - gap > 2 ? v - height - gap : v + gap];
    const [left, top] = isNarrow ? [2, 2]
      : beside.map((one, axis) => Math.max(2, Math.min(one, room[axis])));
    context.fillStyle = colour("paper");
    context.strokeStyle = colour("c1");
    context.lineWidth = 1.2;
    context.beginPath();
    context.roundRect(left, top, width, height, 4);
    context.fill();
    context.stroke();
    lines.forEach((line, place) => {
      context.fillStyle = colour(place === 0 ? "ink" : "muted");
      context.fillText(line, left + 8, top + high * (place + 0.9));
    });
  }
}
