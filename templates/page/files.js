// Turns what the page shows into files and the clipboard, and dropped files into scenes.

/** The steps of a branch as CSV, with the names of `assur solve --format csv`; angles are in
 * radians, without jumps. */
function csvOfBranch(film, branch) {
  const quoted = (name) => (/[",\n]/.test(name) ? `"${name.replaceAll('"', '""')}"` : name);
  const columns = [];
  const add = (name, parts, rows, from) => parts.forEach((part, place) =>
    columns.push([quoted(`${name}.${part}`), (step) => branch[rows].value(step, from + place)]));
  if (film.hasAngles) {
    film.links.forEach((name, link) => add(name, ["theta", "omega", "alpha"], "angles", 3 * link));
    film.transmissions.forEach((name, dyad) => add(name, ["transmission"], "transmissions", dyad));
  }
  film.efforts.forEach((name, driver) => add(name, ["effort"], "forces", driver));
  film.forces.forEach(({ joint, link }, one) => {
    const isAlone = film.forces.filter((other) => other.joint === joint).length === 1;
    add(isAlone ? joint : `${joint}.${link}`, ["fx", "fy"], "forces", film.efforts.length + 2 * one);
  });
  film.outputs.forEach((name, output) =>
    add(name, ["x", "y", "vx", "vy", "ax", "ay"], "outputs", 6 * output));
  const isSwept = film.count > 1;
  const head = ["step", "branch", ...(isSwept ? [quoted(film.parameter)] : [])];
  const tail = isSwept ? ["circuit"] : [];
  const lines = [[...head, ...columns.map(([name]) => name), ...tail].join(",")];
  for (const [first, last] of branch.stretches) {
    for (let step = first; step <= last; ++step) {
      const numbers = columns.map(([, value]) => value(step));
      lines.push([step, branch.number, ...(isSwept ? [film.parameterAt(step)] : []),
        ...numbers.map((number) => (Number.isFinite(number) ? number : "")),
        ...(isSwept ? [branch.circuit] : [])].join(","));
    }
  }
  return `${lines.join("\n")}\n`;
}

/** A name for a file, from a title. */
function fileName(title, ending) {
  const words = title.toLowerCase().match(/[\p{L}\p{N}]+/gu) ?? ["scene"];
  return `${words.slice(0, 5).join("_")}.${ending}`;
}

function saveFile(name, text, type) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/** Copies a text, or shows it in a box from which it can be copied where a browser does not allow
 * more. Returns whether it was copied. */
async function copyText(text, box) {
  box.value = text;
  try {
    await navigator.clipboard.writeText(text);
    box.classList.add("none");
    return true;
  } catch {
    box.classList.remove("none");
    box.focus();
    box.select();
    return false;
  }
}

/** Calls `take` with the text of each file that is dropped on the page. */
function listenToDrops(take) {
  document.addEventListener("dragover", (event) => {
    event.preventDefault();
    document.body.classList.add("dropping");
  });
  document.addEventListener("dragleave", (event) =>
    event.relatedTarget === null && document.body.classList.remove("dropping"));
  document.addEventListener("drop", async (event) => {
    event.preventDefault();
    document.body.classList.remove("dropping");
    const file = event.dataTransfer.files[0];
    if (file) {
      take(await file.text());
    }
  });
}
