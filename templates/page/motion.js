// Turns time into a place of the film: along the stretch of a branch, and over its ends.

/** The duration of a sweep in seconds. */
const sweepSeconds = 6;

/** What lies beyond an end of a branch's stretch: the branch, the place on it, and whether the sweep
 * goes on forwards there; null if the branch has to turn round. A branch that is closed always goes
 * on; over a fold, and to another branch at the sweep's end, only if `goesOn` says so. */
function beyond(film, branch, end, forwards, goesOn) {
  const last = film.count - 1;
  if (end === (forwards ? last : 0)) {
    const joined = film.branchOverEnd(branch, forwards);
    if (joined && (goesOn || joined === branch)) {
      return { number: joined.number, place: last - end, forwards };
    }
  }
  if (!goesOn) {
    return null;
  }
  const kind = forwards ? "fold" : "birth";
  const partners = film.events
    .filter(({ event, branches, parameter }) => event === kind &&
      branches.includes(branch.number) && Math.abs(film.placeOf(parameter) - end) < 1.01)
    .flatMap(({ branches }) => branches.filter((number) => number !== branch.number));
  const partner = film.branch(partners[0]);
  return partner ? { number: partner.number, place: partner.placeNear(end), forwards: !forwards }
    : null;
}

/** Where some steps of the sweep lead from a place on a branch: {number, place, forwards}. */
function advanced(film, { number, place, forwards }, steps, goesOn) {
  const branch = film.branch(number);
  const [first, last] = branch.stretchAt(place);
  const there = Math.min(Math.max(place, first), last) + (forwards ? steps : -steps);
  if (there <= last && there >= first) {
    return { number, place: there, forwards };
  }
  const end = there > last ? last : first;
  const over = Math.abs(there - end);
  const next = beyond(film, branch, end, forwards, goesOn);
  if (next === null) {
    return { number, place: end, forwards: !forwards };
  }
  const reached = next.place + (next.forwards ? over : -over);
  const [least, most] = film.branch(next.number).stretchAt(next.place);
  return { ...next, place: Math.min(Math.max(reached, least), most) };
}

/** The place of a film at which an output is nearest to a point, no farther than an eighth of the
 * sweep from the present place, along the branch. */
function placeOnPath(film, branch, output, [x, y], place) {
  const last = film.count - 1;
  const reach = Math.max(last / 8, 1);
  const isClosed = film.isClosed(branch);
  const round = (step) => (isClosed ? ((step % last) + last) % last : step);
  const at = (step) => [0, 1].map((axis) => branch.outputs.value(round(step), 6 * output + axis));
  let [best, least] = [place, Infinity];
  for (const sense of [1, -1]) {
    const begin = sense > 0 ? Math.floor(place) : Math.ceil(place);
    for (let step = begin; Math.abs(step - place) < reach; step += sense) {
      const [here, there] = [at(step), at(step + sense)];
      const along = [there[0] - here[0], there[1] - here[1]];
      if (!Number.isFinite(along[0])) {
        break;  // an end of the branch, or of the sweep
      }
      const square = along[0] ** 2 + along[1] ** 2;
      const part = square > 0
        ? ((x - here[0]) * along[0] + (y - here[1]) * along[1]) / square : 0;
      const inside = Math.min(Math.max(part, 0), 1);
      const distance = Math.hypot(here[0] + inside * along[0] - x, here[1] + inside * along[1] - y);
      if (distance < least - 1e-9 * film.size) {
        [best, least] = [step + sense * inside, distance];
      }
    }
  }
  return round(best);
}
