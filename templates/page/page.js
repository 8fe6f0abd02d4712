// Turns the reader's actions and time into what the page shows.

/** The duration of a sweep. */
const sweepSeconds = 6;

class Page {
  constructor(film) {
    this.stage = new Stage(this.element("stage"));
    this.chosen = film.chosen;
    this.place = 0;
    this.forwards = true;
    this.last = null;
    this.isPlaying = film.count > 1 && !matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.addQuantities(film);
    this.use(film);
    this.addSliders();
    this.listen();
    this.show();
    requestAnimationFrame((now) => this.tick(now));
  }

  /** Shows a film, at the place in the sweep where the film before it was. */
  use(film) {
    const part = this.film && this.film.count > 1 ? this.place / (this.film.count - 1) : 0;
    this.film = film;
    this.place = part * (film.count - 1);
    this.stage.film = film;
    this.plot = new Plot(this.element("plot"), film);
    this.closed = film.branches.map((branch) => branch.isClosed(film.size));
    if (!film.branch(this.chosen)) {
      this.chosen = film.chosen;
    }
    this.addControls();
  }

  element(name) {
    return document.getElementById(name);
  }

  get options() {
    const on = (name) => this.element(name).checked;
    return { chosen: this.chosen, all: on("all"), ways: on("ways"), names: on("names"),
      velocity: on("velocity"), acceleration: on("acceleration"), spread: on("spread") };
  }

  addControls() {
    const { film } = this;
    this.element("branches").replaceChildren(...film.branches.map((branch) => {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = branch.number;
      button.style.borderBottomColor = `var(--c${branch.colour})`;
      button.addEventListener("click", () => this.choose(branch.number));
      return button;
    }));
    if (film.left_out > 0) {
      this.element("branches").append(`and ${film.left_out} more`);
    }
    this.element("marks").replaceChildren(...film.events.map((event) => {
      const mark = document.createElement("span");
      mark.className = event.event;
      mark.style.left = `${100 * film.placeOf(event.parameter) / (film.count - 1)}%`;
      mark.title = `${event.event} ${event.branches.join(" ")} at ${film.parameter} = ` +
        shortNumber(event.parameter);
      return mark;
    }));
    this.element("place").max = film.count - 1;
    this.hide(".spreads", !film.hasSpreads);
  }

  addQuantities(film) {
    const { hasRates } = film;
    film.outputs.forEach((name, output) => {
      for (const [quantity] of quantities.slice(0, hasRates ? quantities.length : 2)) {
        this.element("quantity").add(new Option(`${name}: ${quantity}`, `${output} ${quantity}`));
      }
    });
    this.hide(".rates", !hasRates);
    this.hide(".moving, #time", film.count === 1);
    this.hide("#plots", film.count === 1 || film.outputs.length === 0);
  }

  addSliders() {
    const { scene, unit } = this.film;
    this.hide("#parameters", !scene);
    if (!scene) {
      return;
    }
    this.element("units").textContent =
      `lengths in ${unit || "the scene's unit"}, angles in rad`;
    const tell = (obstacle, works) => {
      this.element("obstacle").textContent = obstacle && (works
        ? `Not shown: ${obstacle}. The picture still shows the previous values.`
        : `This browser cannot solve the scene anew: ${obstacle}.`);
      this.element("view").classList.toggle("behind", works && obstacle !== "");
    };
    this.sliders = new Sliders(this.element("sliders"), scene, (film) => {
      this.use(film);
      this.show();
    }, tell);
    this.element("reset").addEventListener("click", () => this.sliders.reset());
  }

  hide(selector, hidden) {
    document.querySelectorAll(selector).forEach((one) => one.classList.toggle("none", hidden));
  }

  listen() {
    this.element("play").addEventListener("click", () => this.play(!this.isPlaying));
    this.element("place").addEventListener("input", (event) => this.seek(Number(event.target.value)));
    this.element("plot").addEventListener("pointerdown", (event) =>
      this.seek(this.plot.placeAt(event.offsetX)));
    for (const name of ["all", "ways", "names", "velocity", "acceleration", "spread", "quantity"]) {
      this.element(name).addEventListener("change", () => this.show());
    }
    new ResizeObserver(() => this.show()).observe(document.querySelector("main"));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
      knownColours.clear();
      this.show();
    });
    document.addEventListener("keydown", (event) => this.key(event));
  }

  key(event) {
    if (event.ctrlKey || event.altKey || event.metaKey || event.target.closest?.("select, #parameters")) {
      return;
    }
    const far = event.shiftKey ? 10 : 1;
    const step = Math.round(this.place);
    const digit = Number(event.key);
    const actions = {
      " ": () => this.play(!this.isPlaying),
      ArrowLeft: () => this.seek(step - far),
      ArrowRight: () => this.seek(step + far),
      Home: () => this.seek(0),
      End: () => this.seek(this.film.count - 1),
      a: () => this.element("all").click(),
    };
    const action = actions[event.key] ||
      (this.film.branch(digit) ? () => this.choose(digit) : null);
    if (action !== null) {
      event.preventDefault();
      action();
    }
  }

  choose(number) {
    this.chosen = number;
    this.show();
  }

  play(isPlaying) {
    this.isPlaying = isPlaying && this.film.count > 1;
    this.show();
  }

  seek(place) {
    this.isPlaying = false;
    this.place = Math.min(Math.max(place, 0), this.film.count - 1);
    this.show();
  }

  /** Goes round where the branch is closed, and back and forth where it is not. */
  advance(steps) {
    const last = this.film.count - 1;
    this.place += this.forwards ? steps : -steps;
    const branch = this.film.branches.findIndex((one) => one.number === this.chosen);
    if (this.closed[branch]) {
      this.forwards = true;
      this.place = (this.place % last + last) % last;
    } else if (this.place > last || this.place < 0) {
      this.forwards = this.place < 0;
      this.place = Math.min(Math.max(this.place, 0), last);
    }
  }

  tick(now) {
    if (this.isPlaying && this.last !== null) {
      const seconds = Math.min((now - this.last) / 1000, 0.1);
      const speed = Number(this.element("speed").value);
      this.advance(seconds * speed * (this.film.count - 1) / sweepSeconds);
      this.show();
    }
    this.last = now;
    requestAnimationFrame((next) => this.tick(next));
  }

  show() {
    const { options, film } = this;
    this.stage.draw(this.place, options);
    if (film.count > 1 && film.outputs.length > 0) {
      const [output, ...quantity] = this.element("quantity").value.split(" ");
      this.plot.draw(this.place, options, Number(output), quantity.join(" "));
    }
    this.element("play").textContent = this.isPlaying ? "Pause" : "Play";
    this.element("place").value = this.place;
    this.element("parameter").textContent =
      film.count > 1 ? `${film.parameter} = ${film.parameterAt(this.place).toFixed(4)}` : "";
    [...this.element("branches").querySelectorAll("button")].forEach((button, place) => {
      const branch = film.branches[place];
      button.setAttribute("aria-pressed", branch.number === this.chosen);
      button.classList.toggle("absent", branch.points.at(this.place) === null);
    });
    this.element("magnified").textContent =
      `${film.spread}, × ${shortNumber(film.branch(this.chosen).magnification)}`;
    this.tell();
  }

  /** The outputs of the branch in numbers. */
  tell() {
    const row = this.film.branch(this.chosen).outputs.at(this.place);
    const { hasRates } = this.film;
    const number = (value) => (Number.isFinite(value) ? value.toPrecision(6) : "–");
    const lines = this.film.outputs.map((name, output) => {
      const of = (column) => (row === null ? NaN : row[6 * output + column]);
      const cells = [of(0), of(1), ...(hasRates ? [Math.hypot(of(2), of(3))] : [])];
      return [name, ...cells.map(number)];
    });
    const table = this.element("readout");
    table.replaceChildren();
    const add = (cells, kind) => {
      const line = (kind === "th" ? table.createTHead() : table).insertRow();
      cells.forEach((text, place) => {
        const cell = document.createElement(place === 0 ? "th" : kind);
        cell.textContent = text;
        line.append(cell);
      });
    };
    if (lines.length > 0) {
      add(["output", "x", "y", ...(hasRates ? ["speed"] : [])], "th");
      lines.forEach((cells) => add(cells, "td"));
    }
  }
}

window.page = new Page(new Film(madeWith()));
