// Turns a quantity of an output or a link into its curve along the sweep.

function shortNumber(value) {
  return String(Number(value.toPrecision(4)));
}

class Plot {
  constructor(canvas, film) {
    this.canvas = canvas;
    this.film = film;
    this.known = new Map();
  }

  /** The values of a quantity at all steps, by the numbers of the branches. */
  curves(quantity) {
    if (!this.known.has(quantity.label)) {
      this.known.set(quantity.label, new Map(this.film.branches.map((branch) => [
        branch.number,
        Array.from({ length: this.film.count }, (_, step) => quantity.value(branch, step)),
      ])));
    }
    return this.known.get(quantity.label);
  }

  /** The place of the film under a place of the canvas. */
  placeAt(x) {
    const part = (x - this.left) / (this.right - this.left);
    return Math.min(1, Math.max(0, part)) * (this.film.count - 1);
  }

  draw(place, options, quantity) {
    const context = cleared(this.canvas);
    const width = this.canvas.clientWidth;
    const height = this.canvas.clientHeight;
    const known = this.curves(quantity);
    const shown = this.film.branches.filter((one) => options.all || one.number === options.chosen);
    const curves = shown.map((branch) => [branch, known.get(branch.number)]);
    const own = curves.find(([branch]) => branch.number === options.chosen)[1].filter(Number.isFinite);
    const all = curves.flatMap(([, values]) => values).filter(Number.isFinite);
    // Near dead centres rates have no bound, so the scale is that of the chosen branch.
    const bounded = quantity.isRate && own.length > 0 ? own : all;
    let low = Math.min(...bounded);
    let high = Math.max(...bounded);
    // Values that differ by rounding alone count as constant.
    const isConstant = !(high - low > 1e-6 * Math.max(Math.abs(low), Math.abs(high)));
    [low, high] = isConstant ? [low - 1, high + 1] : [low, high];
    context.font = "12px system-ui, sans-serif";
    const texts = [shortNumber(high), shortNumber(low)];
    [this.left, this.right] = [8 + Math.max(...texts.map((text) => context.measureText(text).width)), width - 6];
    const [top, bottom] = [8, height - 20];
    const x = (step) => this.left + (this.right - this.left) * step / (this.film.count - 1);
    const y = (number) => bottom - (bottom - top) * (number - low) / (high - low);

    context.strokeStyle = colour("muted");
    context.fillStyle = colour("muted");
    context.lineWidth = 1;
    context.strokeRect(this.left, top, this.right - this.left, bottom - top);
    context.textAlign = "right";
    context.fillText(texts[0], this.left - 4, top + 9);
    context.fillText(texts[1], this.left - 4, bottom);
    context.fillText(shortNumber(this.film.to), this.right, height - 5);
    context.textAlign = "left";
    context.fillText(shortNumber(this.film.from), this.left, height - 5);
    context.textAlign = "center";
    context.fillText(this.film.parameter, (this.left + this.right) / 2, height - 5);

    context.save();
    context.beginPath();
    context.rect(this.left, top, this.right - this.left, bottom - top);
    context.clip();
    const line = (from, to) => {
      context.beginPath();
      context.moveTo(...from);
      context.lineTo(...to);
      context.stroke();
    };
    if (low < 0 && high > 0) {
      line([this.left, y(0)], [this.right, y(0)]);
    }
    context.setLineDash([3, 3]);
    for (const event of this.film.events) {
      const at = x(this.film.placeOf(event.parameter));
      line([at, top], [at, bottom]);
    }
    context.setLineDash([]);
    for (const [branch, values] of curves) {
      const strong = branch.number === options.chosen;
      context.globalAlpha = strong ? 1 : 0.45;
      context.lineWidth = strong ? 2 : 1;
      context.strokeStyle = colour(`c${branch.colour}`);
      context.beginPath();
      values.forEach((number, step) => {
        const goesOn = step > 0 && Number.isFinite(values[step - 1]);
        if (Number.isFinite(number)) {
          goesOn ? context.lineTo(x(step), y(number)) : context.moveTo(x(step), y(number));
        }
      });
      context.stroke();
    }
    context.globalAlpha = 1;
    context.restore();
    context.strokeStyle = colour("ink");
    context.lineWidth = 1;
    line([x(place), top], [x(place), bottom]);
  }
}
