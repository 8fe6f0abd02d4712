// Turns a film into the quantities of its outputs and links that can be plotted.

const inDegrees = 180 / Math.PI;

/** What follows from a row x, y, vx, vy, ax, ay of an output. */
const quantitiesOfOutputs = [
  ["x", (row) => row[0]],
  ["y", (row) => row[1]],
  ["speed", (row) => Math.hypot(row[2], row[3])],
  ["v x", (row) => row[2]],
  ["v y", (row) => row[3]],
  ["acceleration", (row) => Math.hypot(row[4], row[5])],
  ["a x", (row) => row[4]],
  ["a y", (row) => row[5]],
];

/** What a row theta, omega, alpha of a link holds. */
const quantitiesOfLinks = ["angle [deg]", "turning [deg/s]", "turning, its rate [deg/s²]"];

/** The joint of a force, with the link on which it acts where the joint has several of them. */
function nameOfForce(film, { joint, link }) {
  const isAlone = film.forces.filter((one) => one.joint === joint).length === 1;
  return isAlone ? joint : `${joint} on ${link}`;
}

/** The quantities of a film, each with its label, its value on a branch at a step, and whether it
 * is a rate, which has no bound near dead centres. */
function quantitiesOf(film) {
  const quantities = [];
  const { hasRates } = film;
  film.outputs.forEach((name, output) => {
    quantitiesOfOutputs.slice(0, hasRates ? undefined : 2).forEach(([quantity, value], place) => {
      quantities.push({
        label: `${name}: ${quantity}`,
        isRate: place > 1,
        value: (branch, step) => value(Array.from({ length: 6 },
          (_, column) => branch.outputs.value(step, 6 * output + column))),
      });
    });
  });
  film.efforts.forEach((name, driver) => quantities.push({
    label: `${name}: effort`, isRate: true,
    value: (branch, step) => branch.forces.value(step, driver),
  }));
  film.forces.forEach((force, place) => quantities.push({
    label: `${nameOfForce(film, force)}: force`, isRate: true,
    value: (branch, step) => Math.hypot(...[0, 1].map((axis) =>
      branch.forces.value(step, film.efforts.length + 2 * place + axis))),
  }));
  if (!film.hasAngles) {
    return quantities;
  }
  const add = (label, rows, column, isRate) => quantities.push({
    label, isRate, value: (branch, step) => inDegrees * branch[rows].value(step, column),
  });
  film.links.forEach((name, link) => {
    quantitiesOfLinks.slice(0, hasRates ? undefined : 1).forEach((quantity, place) =>
      add(`${name}: ${quantity}`, "angles", 3 * link + place, place > 0));
  });
  film.transmissions.forEach((name, dyad) =>
    add(`${name}: transmission angle [deg]`, "transmissions", dyad, false));
  return quantities;
}
