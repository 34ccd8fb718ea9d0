// Questions that take longer than a frame go to a second solver, beside the page. A newer question
// of the same kind replaces one that waits; one that runs too long is given up.
(() => {
  const longest = 20000; // ms

  const loop = (Solver) => {
    let solver;
    self.onmessage = ({ data: { module, id, question, text } }) => {
      if (module) solver = new Solver(module);
      if (!question) return;
      try {
        self.postMessage({ id, answer: solver.ask(question, text) });
      } catch (refusal) {
        self.postMessage({ id, refusal: refusal.message });
      }
    };
  };

  class Background {
    constructor(module) {
      this.module = module;
      this.waiting = [];
      this.start();
    }

    start() {
      const source = `const Refusal = ${play.Refusal}; const Solver = ${play.Solver};
        (${loop})(Solver);`;
      const address = URL.createObjectURL(new Blob([source], { type: 'text/javascript' }));
      this.worker = new Worker(address);
      URL.revokeObjectURL(address);
      this.worker.onmessage = ({ data }) => this.finish(data);
      this.worker.postMessage({ module: this.module });
    }

    /// A promise of the answer; null if another question of its kind came before it was asked.
    ask(kind, question, text) {
      return new Promise((resolve, reject) => {
        this.withdraw((job) => job.kind === kind && job !== this.running);
        this.waiting.push({ kind, question, text, resolve, reject });
        this.next();
      });
    }

    /// Nobody waits for the questions of that kind any longer.
    drop(kind) {
      this.withdraw((job) => job.kind === kind);
      if (this.running?.kind !== kind) return;
      clearTimeout(this.timer);
      this.running = null;
      this.restart();
      this.next();
    }

    withdraw(is_gone) {
      for (const job of this.waiting.filter(is_gone)) job.resolve(null);
      this.waiting = this.waiting.filter((job) => !is_gone(job));
    }

    restart() {
      this.worker.terminate();
      this.start();
    }

    next() {
      if (this.running || this.waiting.length === 0) return;
      [this.running] = this.waiting;
      const { question, text } = this.running;
      this.worker.postMessage({ question, text });
      this.timer = setTimeout(() => {
        this.restart();
        this.finish({ refusal: `no answer after ${longest / 1000} s` });
      }, longest);
    }

    finish({ answer, refusal }) {
      clearTimeout(this.timer);
      const job = this.running;
      this.running = null;
      this.waiting = this.waiting.filter((other) => other !== job);
      if (refusal === undefined) job.resolve(answer);
      else job.reject(new play.Refusal(refusal));
      this.next();
    }
  }

  play.Background = Background;
})();
