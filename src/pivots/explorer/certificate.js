// What a ray claims, checked on the problem itself: v >= 0, y = M v + d v0 >= 0, v_i y_i = 0.
(() => {
  const tolerance = 1e-9; // of the largest numbers that enter a check; exact runs need none

  /// The dictionary of a run with all w basic: its table is [M d].
  function as_given(path, run) {
    const n = path.problem.size;
    const rows = [...Array(n).keys()];
    const columns = [...Array(n + 1).keys()].map((i) => n + i);
    return explorer.toward(path.starts[run].copy(), rows, columns);
  }

  /// -> {least_v, least_y, most_product, v_holds, y_holds, products_vanish}, as doubles.
  function check_ray(path) {
    const { problem } = path;
    const n = problem.size;
    const run = path.runs.length - 1;
    const { ray } = path.outcome;
    const given = as_given(path, run);
    // A scaled run has its own units; the ray of the trace is in the problem's.
    const units = path.branch || problem.exact ? null : path.runs[run].units;
    const rescaled = (x, i, j) => (units ? x * (units[i] || 1) / (units[n + j] || 1) : x);
    const direction = [...ray.v, ray.v0];
    const { zero, add, multiply } = problem.arithmetic;
    let largest = 1;
    const y = [...Array(n).keys()].map((i) => direction.reduce((sum, x, j) => {
      if (problem.number(x) === 0) return sum;
      const term = multiply(rescaled(given.entry(i, j), i, j), x);
      largest = Math.max(largest, Math.abs(problem.number(term)));
      return add(sum, term);
    }, zero));
    const v = direction.map((x) => problem.number(x));
    const y_number = y.map((x) => problem.number(x));
    const allowed = problem.exact ? 0 : tolerance * largest;
    const products = y_number.map((x, i) => Math.abs(x * v[i]));
    const [least_v, least_y] = [Math.min(...v), Math.min(...y_number)];
    const most_product = Math.max(...products);
    return {
      least_v, least_y, most_product, y: y_number,
      v_holds: least_v >= -allowed, y_holds: least_y >= -allowed,
      products_vanish: most_product <= allowed,
    };
  }

  /// z and w at the end of a path, by level, in problem order.
  function solution(path) {
    const { problem } = path;
    const dictionary = path.dictionary(path.last);
    const all = Array.from({ length: 2 * problem.size + 1 }, () => problem.zero());
    dictionary.rows.forEach((variable, r) => { all[variable] = dictionary.value(r); });
    return { z: all.slice(problem.size, 2 * problem.size), w: all.slice(0, problem.size) };
  }

  explorer.certificate = { as_given, check_ray, solution };
})();
