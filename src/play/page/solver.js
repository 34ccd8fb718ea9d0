// The solver: text in, text out.
(() => {
  /// What a person did wrong, as the solver says it.
  class Refusal extends Error {}

  class Solver {
    constructor(module) {
      this.module = module;
      this.start();
    }

    start() {
      this.exports = new WebAssembly.Instance(this.module, {}).exports;
      // eslint-disable-next-line no-underscore-dangle
      this.exports.__wasm_call_ctors();
    }

    said() {
      const { memory, answer, answer_size } = this.exports;
      return new TextDecoder().decode(new Uint8Array(memory.buffer, answer(), answer_size()));
    }

    /// The answer's text. A question that has none ends the module: a fresh one is begun.
    ask(question, text) {
      const bytes = new TextEncoder().encode(`${question}\n${text}`);
      const { exports } = this;
      const at = exports.input(bytes.length);
      new Uint8Array(exports.memory.buffer, at, bytes.length).set(bytes);
      try {
        exports.ask();
      } catch (trap) {
        const words = this.said();
        this.start();
        throw new Refusal(words || `the solver stopped: ${trap.message}`);
      }
      return this.said();
    }
  }

  Object.assign(play, { Solver, Refusal });
})();
