// Turns the mechanism library, a module of WebAssembly, into a function that makes films of scenes.

/** Starts the library. The function that the promise returns takes a question as `question` in
 * module.cpp does, and returns `{ film }`, or `{ obstacle }` with the reason why there is none. */
async function startedLibrary(library) {
  // The library opens no file, so every call of a system function returns an error.
  const noSystem = new Proxy({}, { get: () => () => 8 });
  const { exports } = await WebAssembly.instantiate(library, { wasi_snapshot_preview1: noSystem });
  exports._initialize();
  const { memory } = exports;
  return (question) => {
    const bytes = new TextEncoder().encode(JSON.stringify(question));
    const place = exports.question(bytes.length);
    new Uint8Array(memory.buffer, place, bytes.length).set(bytes);
    const isFilm = exports.solve();
    const told = new Uint8Array(memory.buffer, exports.answer(), exports.answer_bytes());
    const text = new TextDecoder().decode(told);
    if (!isFilm) {
      return { obstacle: text };
    }
    const film = JSON.parse(text);
    for (const branch of film.branches) {
      for (const rows of ["points", "outputs", "spreads", "angles", "transmissions",
        "forces"]) {
        branch[rows] = new Float64Array(memory.buffer, ...branch[rows]).slice();
      }
    }
    return { film };
  };
}

/** The bytes of a module that was packed as LZMA and written in base 64. */
function moduleOf(packed) {
  return unpacked(Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0)));
}
