// A path of pivots, recorded or branched off, and the tableau at each of its frames.
//
// A frame is a moment between pivots. Every run (a start with its pivots) has one frame before each
// of its pivots and one at its end, so that the end of a run is seen before the next one starts.
(() => {
  const checkpoint = 32; // pivots between two tableaus that are factored from the start
  const kept_states = 48;

  class Problem {
    /// trace: what the tool wrote; see docs. Throws where it contradicts itself.
    constructor(trace) {
      this.trace = trace;
      this.size = trace.size;
      this.artificial = 2 * trace.size;
      this.exact = trace.arithmetic === 'fractions';
      this.arithmetic = this.exact ? explorer.fractions : explorer.decimals;
      this.names = trace.variables.map(({ name }) => name);
      this.meanings = trace.variables.map(({ meaning }) =>
        (meaning || '').replace(/\^2/g, '\u00b2'));
      this.index = new Map(this.names.map((name, i) => [name, i]));
      if (this.names.length !== 2 * this.size + 1) throw new Error('variables do not fit the size');
      this.levels = trace.runs.some(({ start }) => start.values.some(Array.isArray)) ? 2 : 1;
    }

    variable(name) {
      const i = this.index.get(name);
      if (i === undefined) throw new Error(`unknown variable ${name}`);
      return i;
    }

    scalar(x) { return this.arithmetic.parse(x); }

    /// A VALUE of the trace as one part a level, the part times S first.
    parts(x) { return Array.isArray(x) ? x : this.levels === 2 ? [0, x] : [x]; }
    value(x) { return this.parts(x).map((part) => this.scalar(part)); }
    zero() { return this.value(0); }
    number(scalar) { return this.arithmetic.number(scalar); }

    start_dictionary(start) {
      const kind = this.exact ? explorer.FractionDictionary : explorer.DecimalDictionary;
      const values = start.values.map((x) => this.parts(x));
      return kind.from(start.rows.map((x) => this.variable(x)),
        start.columns.map((x) => this.variable(x)), start.entries, values);
    }
  }

  class Path {
    /// pivots: with variable numbers; runs: [{title, start, first_pivot}]; outcome: {status, ...}
    constructor(problem, pivots, runs, outcome, branch = null) {
      this.problem = problem;
      this.pivots = pivots;
      this.outcome = outcome;
      this.branch = branch; // {frame, pivot, row, rule, from}, or null for the recorded path
      this.runs = runs.map((run, i) => ({
        ...run, end_pivot: i + 1 < runs.length ? runs[i + 1].first_pivot : pivots.length,
      }));
      this.frames = [];
      this.starts = this.runs.map(({ start }) => problem.start_dictionary(start));
      this.runs.forEach((run, number) => this.add_frames(run, number));
      this.states = new Map();
    }

    static recorded(problem) {
      const { trace } = problem;
      const variables = (names) => names.map((name) => problem.variable(name));
      const pivots = trace.pivots.map((pivot) => ({
        ...pivot,
        entering: problem.variable(pivot.entering),
        leaving: problem.variable(pivot.leaving),
        ratios: pivot.ratios && pivot.ratios.map((x) => (x === null ? null : problem.value(x))),
        ties: variables(pivot.ties || []),
        z0: problem.value(pivot.z0),
        basis: variables(pivot.basis),
      }));
      const ray = trace.ray && {
        entering: problem.variable(trace.ray.entering), words: trace.ray.words,
        v: trace.ray.v.map((x) => problem.scalar(x)), v0: problem.scalar(trace.ray.v0),
      };
      return new Path(problem, pivots, trace.runs,
        { status: trace.status, reason: trace.reason, ray, cycle: trace.cycle });
    }

    add_frames(run, number) {
      let rows = [...this.starts[number].rows];
      let columns = [...this.starts[number].columns];
      for (let k = run.first_pivot; k <= run.end_pivot; ++k) {
        const pivot = k < run.end_pivot ? k : null;
        this.frames.push({ run: number, pivot, done: k, rows, columns });
        if (pivot === null) break;
        const { entering, leaving } = this.pivots[k];
        const [r, c] = [rows.indexOf(leaving), columns.indexOf(entering)];
        if (r < 0 || c < 0) throw new Error(`pivot ${k + 1} does not fit its tableau`);
        rows = rows.slice();
        columns = columns.slice();
        [rows[r], columns[c]] = [columns[c], rows[r]];
      }
    }

    get last() { return this.frames.length - 1; }

    /// The pivot that is about to be made at a frame, or null at the end of a run.
    step(frame_number) {
      const { pivot } = this.frames[frame_number];
      return pivot === null ? null : this.pivots[pivot];
    }

    /// Pivots count from 0, as in texts: the one about to be made, or at the end of a run the last one made.
    where(frame_number) {
      const { pivot, done } = this.frames[frame_number];
      if (pivot === null && done === 0) return 'No pivot';
      return `${pivot === null ? `After pivot ${done - 1}` : `Pivot ${pivot}`} of 0..${this.pivots.length - 1}`;
    }

    /// The dictionary at a frame. Not to be changed: it is kept.
    dictionary(frame_number) {
      const known = this.states.get(frame_number);
      if (known) return known;
      const frame = this.frames[frame_number];
      const done = frame.done - this.runs[frame.run].first_pivot;
      let dictionary;
      if (done % checkpoint === 0) {
        dictionary = explorer.toward(this.starts[frame.run].copy(), frame.rows, frame.columns);
      } else {
        const { entering, leaving } = this.pivots[frame.done - 1];
        dictionary = this.dictionary(frame_number - 1).copy();
        dictionary.exchange(dictionary.rows.indexOf(leaving), dictionary.columns.indexOf(entering));
      }
      if (this.states.size >= kept_states) this.states.delete(this.states.keys().next().value);
      this.states.set(frame_number, dictionary);
      return dictionary;
    }

    /// z0 at a frame, by level.
    z0(frame_number) {
      const { artificial } = this.problem;
      const frame = this.frames[frame_number];
      const row = frame.rows.indexOf(artificial);
      if (row < 0) return this.problem.zero();
      if (frame.done > this.runs[frame.run].first_pivot && this.pivots[frame.done - 1].z0)
        return this.pivots[frame.done - 1].z0;
      return this.dictionary(frame_number).value(row);
    }

    /// The pairs of which neither variable is basic, by number from 0.
    missing_pairs(frame_number) {
      const { size } = this.problem;
      const basic = new Set(this.frames[frame_number].rows);
      return [...Array(size).keys()].filter((i) => !basic.has(i) && !basic.has(size + i));
    }

    /// The variable that is about to enter: of the pivot, or of the ray at the end.
    entering(frame_number) {
      const step = this.step(frame_number);
      if (step) return step.entering;
      return frame_number === this.last && this.outcome.ray ? this.outcome.ray.entering : null;
    }

    /// A new path: this one up to the frame, then `row` leaves and the rule decides.
    branch_at(frame_number, row, rule, limit = 500) {
      const frame = this.frames[frame_number];
      const { lemke } = explorer;
      const seen = new Map();
      for (let k = 0; k <= frame_number; ++k) {
        const { run, pivot, done, rows } = this.frames[k];
        if (run === frame.run && pivot !== null && done > this.runs[run].first_pivot)
          seen.set(lemke.state_key({ rows }, this.pivots[pivot].entering), done - 1);
      }
      const result = lemke.run_lemke(this.dictionary(frame_number).copy(),
        this.pivots[frame.pivot].entering, row, { rule, limit, seen, first: frame.pivot });
      const pivots = this.pivots.slice(0, frame.pivot).concat(result.pivots.map((pivot) => ({
        ...pivot, z0: pivot.z0 || this.problem.zero(), run: frame.run, sentence: null,
      })));
      return new Path(this.problem, pivots, this.runs.slice(0, frame.run + 1),
        { status: result.status, reason: null, ray: result.ray, cycle: result.cycle },
        { frame: frame_number, pivot: frame.pivot, row, rule, from: this });
    }
  }

  explorer.Problem = Problem;
  explorer.Path = Path;
})();
