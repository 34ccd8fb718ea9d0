// The solver: text in, text out. wasm/refresh.py says how it is packed.
(() => {
  const alphabet = '0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz'
    + '!#%()*+,-./:=?@^_{|}~$;';

  /// The deflated bytes of five characters of base 85 for four of them.
  function bytes_of(text) {
    const value = new Uint8Array(128);
    for (let k = 0; k < alphabet.length; k += 1) value[alphabet.charCodeAt(k)] = k;
    const [header, ...lines] = text.trim().split('\n');
    const digits = lines.join('');
    const bytes = new DataView(new ArrayBuffer(digits.length / 5 * 4));
    for (let k = 0; k < digits.length / 5; k += 1) {
      let number = 0;
      for (let i = 0; i < 5; i += 1) number = number * 85 + value[digits.charCodeAt(5 * k + i)];
      bytes.setUint32(4 * k, number);
    }
    return new Uint8Array(bytes.buffer, 0, Number(header.split(' ')[1]));
  }

  async function module_of(text) {
    const inflated = new Blob([bytes_of(text)]).stream()
      .pipeThrough(new DecompressionStream('deflate-raw'));
    return WebAssembly.compile(await new Response(inflated).arrayBuffer());
  }

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

  Object.assign(play, { module_of, Solver, Refusal });
})();
