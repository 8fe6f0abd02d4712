// Turns the reader's actions and time into what the page shows.

class Page {
  constructor(data) {
    const film = new Film(data);
    this.stage = new Stage(this.element("stage"));
    this.marks = new Marks(this.stage);
    this.chosen = film.chosen;
    this.forwards = true;
    this.last = null;
    this.scene = null;
    this.isSweepDue = false;  // while a drawing is edited, it is asked for less often than the pose
    this.offered = null;  // a scene that was dropped, until it is solved
    this.editing = new Editing((isComplete) => this.solve(isComplete));
    this.isPlaying = !matchMedia("(prefers-reduced-motion: reduce)").matches;
    this.use(film);
    listenFor(this);
    this.hide("#parameters, .solved", !data.scene);
    if (data.scene) {
      this.module = data.scene.module;
      this.begin(new Scene(data.scene), film);
      this.asker = new Asker(this.module, () => this.question(),
        (answer, question) => this.take(answer, question),
        (obstacle, question, works) => this.tell(obstacle, question, works));
      this.solve();
    }
    this.show();
    requestAnimationFrame((now) => this.tick(now));
  }

  element(name) {
    return document.getElementById(name);
  }

  hide(selector, hidden) {
    document.querySelectorAll(selector).forEach((one) => one.classList.toggle("none", hidden));
  }

  isChecked(name) {
    return this.element(name).checked;
  }

  get options() {
    return { chosen: this.chosen, ...Object.fromEntries(
      ["all", "ways", "names", "velocity", "acceleration", "force", "spread", "drawn"].map((name) =>
        [name, this.isChecked(name)])) };
  }

  get branch() {
    return this.film.branch(this.chosen);
  }

  /** Takes a scene, with the film that shows its parameters. */
  begin(scene, film) {
    this.scene = scene;
    this.editing.begin(scene);
    this.hide(".editable", !scene.isDrawn);
    this.addSliders(film);
  }

  addSliders(film) {
    this.sliders = new Sliders(this.element("sliders"), this.scene, film, () => this.solve());
    this.hide("#parameters", this.sliders.rows.length === 0);
    this.element("units").textContent =
      `lengths in ${film.unit || "the scene's unit"}, angles in rad`;
  }

  /** Shows a film, at the place in the sweep where the film before it was. */
  use(film, followed = film.chosen) {
    const before = this.film;
    const isSameSweep = before?.parameter === film.parameter && before.count > 1;
    this.film = film;
    this.stage.film = film;
    this.plot = new Plot(this.element("plot"), film);
    this.chosen = film.branch(followed) ? followed : film.chosen;
    if (isSameSweep && !this.editing.isOn) {
      this.place *= (film.count - 1) / (before.count - 1);
    } else {
      this.standAsDrawn();
    }
    showFilm(this);
    showQuantities(this);
  }

  /** Asks for the scene as it stands; during a drag, for the drawn pose alone. */
  solve(isComplete = true) {
    this.isSweepDue ||= isComplete;
    this.asker.ask();
    this.show();
  }

  /** The pose whose branch is to be followed; null where nothing is to be. */
  seen() {
    if (this.editing.isOn || !this.isChecked("follow")) {
      return null;
    }
    const place = this.branch.placeNear(this.place);
    const points = [...this.branch.points.at(place)];
    const part = this.film.count > 1 ? place / (this.film.count - 1) : 0;
    return points.every(Number.isFinite) ? { part, points } : null;
  }

  question() {
    const scene = this.offered ?? this.scene;
    const isDraft = this.editing.isOn && scene === this.scene && !this.isSweepDue;
    this.isSweepDue = false;
    const asked = scene.question(!isDraft);
    const seen = scene === this.scene ? this.seen() : null;
    if (seen) {
      asked.seen = seen;
    }
    return { scene, isDraft, asked, follows: seen !== null, chosen: this.chosen };
  }

  take(film, { scene, isDraft, follows, chosen }) {
    if (scene !== (this.offered ?? this.scene)) {
      return;
    }
    scene.isSolved = true;
    if (isDraft && !this.editing.isOn) {
      return;
    }
    if (isDraft) {
      this.editing.draft = film;
      if (this.stage.view.own === null) {
        this.frame(film);
      }
    } else if (scene === this.offered) {
      this.adopt(film);
    } else if (follows && chosen !== this.chosen) {
      this.solve();  // another branch was chosen in the meantime
      return;
    } else {
      this.ended = follows && !film.followed;
      this.use(film, film.followed && follows || this.editing.isOn ? film.chosen : this.chosen);
      if (this.editing.isOn) {
        this.asker.ask();  // the drawn pose follows
      }
    }
    if (!this.isDragging) {
      this.editing.read(film);
    }
    const names = film.parameters.filter(({ name, own }) => own && name !== film.parameter);
    if (!isDraft && names.some(({ name }) => !this.sliders.made.has(name) &&
        !(this.scene.helpers ?? []).includes(name))) {
      this.addSliders(film);
    }
    this.sliders.read(film);
    this.show();
  }

  /** Shows the scene that was dropped in place of the one before. */
  adopt(film) {
    const scene = this.offered;
    this.offered = null;
    this.leave();
    this.film = null;
    this.stage.view.showAll();
    this.begin(scene, film);
    this.use(film);
    const title = film.title || "A mechanism";
    document.title = title;
    this.element("title").textContent = title;
    this.isPlaying = this.isPlaying && film.count > 1;
  }

  tell(obstacle, { scene }, works) {
    if (obstacle && scene.helpers && !scene.isSolved) {
      scene.turns = false;  // its first driver cannot be turned: the scene stands still
      scene.helpers = null;
      this.solve();
      return;
    }
    if (obstacle && scene === this.offered) {
      this.offered = null;
    }
    const text = obstacle && (works
      ? `Not shown: ${obstacle}. The picture still shows the previous values.`
      : `This browser cannot solve the scene anew: ${obstacle}.`);
    this.element("obstacle").textContent = text || (this.ended
      ? "The assembly that was shown ends here: " +
        `branch ${this.chosen} is shown, because of its number.` : "");
    this.element("view").classList.toggle("behind", works && obstacle !== "");
    this.sliders.setDisabled(!works);
  }

  choose(number) {
    this.chosen = number;
    this.ended = false;
    this.show();
  }

  play(isPlaying) {
    this.leave();
    this.isPlaying = isPlaying && this.film.count > 1;
    this.show();
  }

  seek(place) {
    this.leave();
    this.isPlaying = false;
    this.place = Math.min(Math.max(place, 0), this.film.count - 1);
    this.show();
  }

  enlarge(factor) {
    const { clientWidth, clientHeight } = this.element("stage");
    this.stage.view.enlarge(factor, [clientWidth / 2, clientHeight / 2]);
    this.show();
  }

  fit() {
    this.stage.view.showAll();
    if (this.editing.isOn) {
      this.frame(this.editing.draft ?? this.film);
    }
    this.show();
  }

  /** Shows all of a drawing and of the way that it moves, and keeps that view. */
  frame(film) {
    const { clientWidth, clientHeight } = this.element("stage");
    const boxes = [this.branch.box, ...film.branches.map(({ box }) => box)];
    const box = [0, 1, 2, 3].map((side) =>
      (side < 2 ? Math.min : Math.max)(...boxes.map((one) => one[side])));
    this.stage.view.fit(box, clientWidth, clientHeight, 45);
    this.stage.view.hold();
  }

  /** Goes to the drawn pose, whose points can then be moved. */
  edit() {
    if (!this.scene?.isDrawn || this.editing.isOn) {
      return;
    }
    this.isPlaying = false;
    this.editing.isOn = true;
    this.keptView = this.stage.view.own;
    this.standAsDrawn();
    this.solve(false);
  }

  leave() {
    if (!this.editing.isOn) {
      return;
    }
    this.editing.isOn = false;
    this.editing.draft = null;
    this.stage.view.own = this.keptView;
    this.standAsDrawn();
    this.show();
  }

  /** Goes to the swept parameter's own value, or to the beginning if that is not in the sweep. */
  standAsDrawn() {
    const { film } = this;
    const own = film.own === null ? 0 : film.placeOf(film.own);
    this.place = this.branch.placeNear(own >= 0 && own <= film.count - 1 ? own : 0);
  }

  reset() {
    this.editing.remember();
    this.scene.reset();
    this.solve();
  }

  /** Offers a scene file to the page: it is shown if it can be solved. */
  offer(text) {
    if (!this.asker) {
      return;
    }
    this.offered = new Scene({ text, settings: [] });
    this.solve();
  }

  async copy() {
    if (this.scene) {
      const isCopied = await copyText(this.scene.written(), this.element("text"));
      this.element("copy_scene").textContent = isCopied ? "Copied" : "Copy scene";
      setTimeout(() => (this.element("copy_scene").textContent = "Copy scene"), 1500);
    }
  }

  /** What a pointer at a place on the stage drags: a drawn point, an output along its path, or, for
   * null, the picture. */
  grip(at, reach, isHovering = false) {
    const { view } = this.stage;
    if (this.editing.isOn) {
      const held = this.editing.grip(at, reach, view, isHovering);
      this.isDragging = held !== null && !isHovering;
      return held && !isHovering
        ? { ...held, end: () => { this.isDragging = false; held.end(); } } : held;
    }
    const outputs = this.branch.outputs.at(this.place);
    const output = outputs === null || this.film.count === 1 ? -1
      : this.film.outputs.findIndex((_, one) => {
        const [x, y] = view.at(outputs[6 * one], outputs[6 * one + 1]);
        return Math.hypot(x - at[0], y - at[1]) <= reach;
      });
    if (output < 0) {
      return null;
    }
    return {
      move: (place) => this.seek(placeOnPath(this.film, this.branch, output, view.under(place),
        this.place)),
      end: () => {},
    };
  }

  tick(now) {
    if (this.isPlaying && this.last !== null && this.film.count > 1) {
      const seconds = Math.min((now - this.last) / 1000, 0.1);
      const steps = seconds * Number(this.element("speed").value) * (this.film.count - 1) / sweepSeconds;
      const { chosen, place, forwards } = this;
      const next = advanced(this.film, { number: chosen, place, forwards }, steps,
        this.element("end").value === "go on");
      [this.chosen, this.place, this.forwards] = [next.number, next.place, next.forwards];
      this.show();
    }
    this.last = now;
    requestAnimationFrame((next) => this.tick(next));
  }

  show() {
    const { options, film, editing } = this;
    const isDrafted = editing.isOn && editing.draft !== null;
    if (isDrafted) {
      this.showDraft(options);
    } else {
      this.stage.film = film;
      this.stage.draw(this.place, options);
      if (options.drawn && this.scene?.isDrawn) {
        this.marks.pose(this.scene, editing.places);
      }
    }
    if (film.count > 1 && film.quantities.length > 0) {
      const label = this.element("quantity").value;
      this.plot.draw(this.place, options, film.quantities.find((one) => one.label === label));
    }
    this.element("play").textContent = this.isPlaying ? "Pause" : "Play";
    this.element("place").value = this.place;
    this.element("parameter").textContent = film.count > 1 ? this.toldParameter() : "";
    [...this.element("branches").querySelectorAll("button")].forEach((button, place) => {
      const branch = film.branches[place];
      button.setAttribute("aria-pressed", branch.number === this.chosen);
      button.classList.toggle("absent", branch.points.at(this.place) === null);
    });
    this.element("circuit").textContent = toldCircuit(film, this.branch);
    this.element("magnified").textContent =
      `${film.spread}, × ${shortNumber(this.branch.magnification)}`;
    showStretches(this);
    showEditing(this);
    const shown = isDrafted ? editing.draft : film;
    fillTable(this.element("readout"), shown, shown.branch(isDrafted ? shown.chosen : this.chosen),
      isDrafted ? 0 : this.place);
  }

  /** The swept parameter in numbers, an angle in degrees, too. */
  toldParameter() {
    const { parameter } = this.film;
    const value = this.film.parameterAt(this.place);
    const degrees = this.scene?.isAngle(parameter) ? ` (${(inDegrees * value).toFixed(1)}°)` : "";
    return `${parameter} = ${value.toFixed(4)}${degrees}`;
  }

  /** The drawn pose, with the paths of the branch on which it lies. */
  showDraft(options) {
    const { draft, places } = this.editing;
    this.stage.film = draft;
    this.stage.draw(0, { ...options, chosen: draft.chosen, all: false, ways: false });
    this.stage.begin(this.branch, 1.2);
    this.stage.ways(this.branch, options);
    this.marks.pose(this.scene, places);
    this.marks.squares(this.editing);
  }
}

window.page = new Page(madeWith());
