// A trace in the tool's format from the explorer's own engine, for tests that need no tool.
import { load_engine } from './engine.mjs';

const plain = (levels, write) => {
  const parts = levels.map(write);
  return parts.length === 1 || Number(parts[0]) === 0 ? parts[parts.length - 1] : parts;
};

/// M: rows, q: numbers or [times S, finite]; numbers, or texts "p/q" with `exact`.
export function own_trace({ title, M, q, cover, exact = false, rule = 'lexicographic',
  meanings = [], scene = null, free = 0, limit = 500, engine = load_engine() }) {
  const n = M.length;
  const d = cover || Array(n).fill(exact ? '1' : 1);
  const names = [...Array(n).keys()].map((i) => `w${i + 1}`)
    .concat([...Array(n).keys()].map((i) => `z${i + 1}`), 'z0');
  const start = { rows: names.slice(0, n), columns: names.slice(n),
    entries: M.map((row, i) => [...row, d[i]]), values: q };
  const trace = { status: 'solved', reason: null, rule, title,
    arithmetic: exact ? 'fractions' : 'decimals', size: n, free,
    variables: names.map((name, i) => ({ name, meaning: meanings[i] || '' })),
    pivots: [], runs: [{ title: 'cold start, cover d', start, first_pivot: 0 }],
    final: { basis: start.rows, tableau: null, z: null, w: null }, ray: null, cycle: null, scene };
  const problem = new engine.Problem(trace);
  const write = (x) => (exact ? engine.fractions.text(x) : x);
  const dictionary = problem.start_dictionary(start);
  const tableau = (of, row, column) => ({ rows: of.rows.map((x) => names[x]),
    columns: of.columns.map((x) => names[x]),
    entries: of.rows.map((_, r) => of.columns.map((__, c) => write(of.entry(r, c)))),
    values: of.rows.map((_, r) => plain(of.value(r), write)), row, column });
  if (!dictionary.rows.some((_, r) => dictionary.is_negative(r))) return trace;
  const result = engine.lemke.run_lemke(dictionary.copy(), 2 * n, null, { rule, limit });
  for (const pivot of result.pivots) {
    const row = dictionary.rows.indexOf(pivot.leaving);
    const column = dictionary.columns.indexOf(pivot.entering);
    const before = tableau(dictionary, row, column);
    dictionary.exchange(row, column);
    trace.pivots.push({ entering: names[pivot.entering], leaving: names[pivot.leaving],
      ratios: pivot.ratios.map((x) => (x === null ? null : plain(x, write))),
      ties: pivot.ties.map((x) => names[x]), tie_break: pivot.tie_break,
      z0: pivot.z0 === null ? write(problem.scalar(0)) : plain(pivot.z0, write),
      basis: pivot.basis.map((x) => names[x]),
      sentence: null, run: 0, tableau: before });
  }
  trace.status = result.status;
  trace.cycle = result.cycle;
  trace.final.basis = dictionary.rows.map((x) => names[x]);
  if (result.status === 'solved') {
    const of = (x) => {
      const r = dictionary.rows.indexOf(x);
      return r < 0 ? write(problem.scalar(0)) : write(dictionary.value(r).at(-1));
    };
    trace.final.z = names.slice(0, n).map((_, i) => of(n + i));
    trace.final.w = names.slice(0, n).map((_, i) => of(i));
  }
  if (result.ray) {
    const { entering, v, v0 } = result.ray;
    trace.ray = { entering: names[entering], v: v.map(write), v0: write(v0),
      words: `Nothing blocks ${names[entering]}: it may grow for ever.` };
  }
  return trace;
}
