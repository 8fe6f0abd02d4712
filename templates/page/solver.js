// Turns a scene and values of its parameters into the data of a page, in a thread of its own.

/** The code that the thread runs: the mechanism library as a module of WebAssembly. The thread is
 * sent the packed module once, and then one question after the other, each of which it answers. */
function solverThread() {
  let library = null;  // as a promise
  let answer = null;

  onmessage = async ({ data }) => {
    try {
      if (library === null) {
        library = WebAssembly.compile(moduleOf(data.module));
        return;
      }
      answer ??= await startedLibrary(await library);
      postMessage(answer(data));
    } catch (error) {
      answer = null;  // a module that stopped in the middle cannot go on
      postMessage({ obstacle: `the solver stopped: ${error.message}` });
    }
  };
}

/** Solves scenes. The caller must wait for each answer before it asks again. */
class Solver {
  constructor(module) {
    const code = new Blob([`${unpacked}\n${moduleOf}\n${startedLibrary}\n(${solverThread})();`], { type: "text/javascript" });
    this.thread = new Worker(URL.createObjectURL(code));
    this.thread.postMessage({ module });
  }

  /** The data of a film, for a question as `question` in module.cpp takes it; rejects with an error
   * if there is none. */
  solve(question) {
    return new Promise((resolve, reject) => {
      this.thread.onmessage = ({ data }) =>
        (data.film ? resolve(data.film) : reject(new Error(data.obstacle)));
      this.thread.onerror = (event) => reject(new Error(event.message));
      this.thread.postMessage(question);
    });
  }
}

/** Asks the solver as often as the scene changes. What changes while the solver is busy is asked
 * once, when it is free. */
class Asker {
  /** `question` makes the present question; `take` gets an answer and its question; `tell` gets the
   * reason why there is no answer, or an empty text, the question, and whether any question was
   * answered so far: if not, the browser cannot solve at all. */
  constructor(module, question, take, tell) {
    Object.assign(this, { module, question, take, tell });
    [this.busy, this.waiting, this.works] = [false, false, false];
  }

  async ask() {
    this.waiting = this.busy;
    if (this.busy) {
      return;
    }
    this.busy = true;
    const question = this.question();
    let film = null;
    let obstacle = "";
    try {
      this.solver ??= new Solver(this.module);
      film = new Film(await this.solver.solve(question.asked));
      this.works = true;
    } catch (error) {
      obstacle = error.message;
    }
    this.busy = false;
    if (film !== null) {
      this.take(film, question);
    }
    this.tell(obstacle, question, this.works);
    if (this.waiting) {
      this.ask();
    }
  }
}
