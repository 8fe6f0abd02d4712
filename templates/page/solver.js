// Turns a scene and values of its parameters into the data of a page, in a thread of its own.

/** The code that the thread runs: the mechanism library as a module of WebAssembly. The thread is
 * sent the packed module once, and then one question after the other, each of which it answers. */
function solverThread() {
  let library = null;  // as a promise
  let memory = null;
  let calls = null;

  const start = async () => {
    // The library opens no file, so every call of a system function returns an error.
    const noSystem = new Proxy({}, { get: () => () => 8 });
    const { exports } = await WebAssembly.instantiate(await library, { wasi_snapshot_preview1: noSystem });
    exports._initialize();
    [calls, memory] = [exports, exports.memory];
  };
  const answer = (question) => {
    const bytes = new TextEncoder().encode(JSON.stringify(question));
    const place = calls.question(bytes.length);
    new Uint8Array(memory.buffer, place, bytes.length).set(bytes);
    const isFilm = calls.solve();
    const told = new Uint8Array(memory.buffer, calls.answer(), calls.answer_bytes());
    const text = new TextDecoder().decode(told);
    if (!isFilm) {
      return { obstacle: text };
    }
    const film = JSON.parse(text);
    for (const branch of film.branches) {
      for (const rows of ["points", "outputs", "spreads"]) {
        branch[rows] = new Float64Array(memory.buffer, ...branch[rows]).slice();
      }
    }
    return { film };
  };

  onmessage = async ({ data }) => {
    try {
      if (library === null) {
        const packed = Uint8Array.from(atob(data.module), (letter) => letter.charCodeAt(0));
        library = WebAssembly.compile(unpacked(packed));
        return;
      }
      if (calls === null) {
        await start();
      }
      postMessage(answer(data));
    } catch (error) {
      calls = null;  // a module that stopped in the middle cannot go on
      postMessage({ obstacle: `the solver stopped: ${error.message}` });
    }
  };
}

/** Solves a scene of the page. The caller must wait for each answer before it asks again. */
class Solver {
  constructor(scene) {
    this.scene = scene;
    const code = new Blob([`${unpacked}\n(${solverThread})();`], { type: "text/javascript" });
    this.thread = new Worker(URL.createObjectURL(code));
    this.thread.postMessage({ module: scene.module });
  }

  /** The data of the page at values of parameters; rejects with an error if there is none. */
  solve(values) {
    const settings = Object.entries(values).map(([name, value]) => `${name}=${value}`);
    return new Promise((resolve, reject) => {
      this.thread.onmessage = ({ data }) =>
        (data.film ? resolve(data.film) : reject(new Error(data.obstacle)));
      this.thread.onerror = (event) => reject(new Error(event.message));
      const { text } = this.scene;
      this.thread.postMessage({ text, settings: [...this.scene.settings, ...settings] });
    });
  }
}
