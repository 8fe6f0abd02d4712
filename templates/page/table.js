// Turns a place on a branch into a table of its outputs, links and transmission angles.

/** Efforts of drivers, and forces in joints on the links that are named. */
function addForces(film, branch, place, add, number) {
  if (!film.hasForces) {
    return;
  }
  const step = Math.round(place);
  const of = (column) => number(branch.forces.value(step, column));
  add(["driver", "effort"], "th");
  film.efforts.forEach((name, driver) => add([name, of(driver)], "td"));
  add(["force at", "x", "y"], "th");
  film.forces.forEach((force, one) => add([`${force.joint} on ${force.link}`,
    of(film.efforts.length + 2 * one), of(film.efforts.length + 2 * one + 1)], "td"));
}

function fillTable(table, film, branch, place) {
  table.replaceChildren();
  const number = (value) => (Number.isFinite(value) ? value.toPrecision(6) : "–");
  const degrees = (value) => (Number.isFinite(value) ? (inDegrees * value).toFixed(2) : "–");
  const { hasRates } = film;
  const width = hasRates ? 4 : 3;
  const add = (cells, kind) => {
    const line = table.insertRow();
    line.className = kind === "th" ? "heads" : "";
    cells.forEach((text, column) => {
      const cell = document.createElement(column === 0 ? "th" : kind);
      cell.textContent = text;
      cell.colSpan = column === cells.length - 1 ? width - column : 1;
      line.append(cell);
    });
  };
  const outputs = branch.outputs.at(place);
  if (film.outputs.length > 0) {
    add(["output", "x", "y", ...(hasRates ? ["speed"] : [])], "th");
  }
  film.outputs.forEach((name, output) => {
    const of = (column) => (outputs === null ? NaN : outputs[6 * output + column]);
    add([name, number(of(0)), number(of(1)),
      ...(hasRates ? [number(Math.hypot(of(2), of(3)))] : [])], "td");
  });
  addForces(film, branch, place, add, number);
  if (!film.hasAngles) {
    return;
  }
  const angles = branch.angles.at(place);
  add(["link", "angle °", ...(hasRates ? ["°/s", "°/s²"] : [])], "th");
  film.links.forEach((name, link) => {
    const of = (column) => (angles === null ? NaN : angles[3 * link + column]);
    add([name, degrees(of(0)), ...(hasRates ? [degrees(of(1)), degrees(of(2))] : [])], "td");
  });
  if (film.transmissions.length > 0) {
    add(["pin", "transmission angle °"], "th");
    const transmissions = branch.transmissions.at(place);
    film.transmissions.forEach((name, dyad) =>
      add([name, degrees(transmissions?.[dyad])], "td"));
  }
}
