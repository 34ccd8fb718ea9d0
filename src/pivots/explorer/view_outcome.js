// How the path ends: a solution, a ray with its checks, a cycle, or a stop.
(() => {
  const { h, table, by_id, replace } = drawing.elements;
  const { name } = explorer.elements;
  const { number_text } = explorer;

  function solution_table(app) {
    const { path, problem } = app;
    const { final } = problem.trace;
    const n = problem.size;
    const known = !path.branch && final && final.z && final.w;
    const computed = known ? null : explorer.certificate.solution(path);
    const numbers = (of) => number_text.without_noise(problem,
      known ? final[of].map((x) => problem.value(x)) : computed[of]);
    const [z, w] = [numbers('z'), numbers('w')];
    return h('div', { class: 'scroll tall', tabindex: 0, role: 'region', 'aria-label': 'Solution' },
      table('solution', ['pair', 'z', 'w', 'meaning of z'], [...Array(n).keys()].map((i) =>
        [i + 1, app.text(z[i]), app.text(w[i]), problem.meanings[n + i]]), { words: 'words' }));
  }

  function ray_panel(app) {
    const { path, problem } = app;
    const { ray } = path.outcome;
    const check = explorer.certificate.check_ray(path);
    const parts = [...ray.v, ray.v0].map((x, i) => ({ x, variable: problem.size + i }))
      .filter(({ x }) => Math.abs(problem.number(x)) > 1e-12);
    const line = (holds, words) =>
      h('li', {}, h('strong', {}, holds ? 'holds: ' : 'fails: '), words);
    return [
      ray.words && h('p', { class: 'lines' }, ray.words),
      h('p', {}, 'Along the ray the unknowns grow in these proportions, for ever:'),
      h('div', { class: 'scroll tall', tabindex: 0, role: 'region', 'aria-label': 'Ray' },
        table('solution', ['variable', 'v', 'means'], parts.map(({ x, variable }) =>
          [name(problem.names[variable]), number_text.scalar(problem, x, app.as_fractions),
            problem.meanings[variable]]), { words: 'words' })),
      h('p', {}, 'Checked here, on the problem itself:'),
      h('ul', { class: 'facts checks' },
        line(check.v_holds, `v \u2265 0 (least entry ${number_text.decimal(check.least_v, 3)})`),
        line(check.y_holds, `M v + d v0 \u2265 0 (least entry ${
          number_text.decimal(check.least_y, 3)})`),
        line(check.products_vanish, `v and M v + d v0 are complementary (largest product ${
          number_text.decimal(check.most_product, 3)})`)),
    ];
  }

  function cycle_panel(app) {
    const { path } = app;
    const { from_pivot, length } = path.outcome.cycle;
    const frame = path.frames.findIndex(({ pivot, done }) => done === from_pivot + 1
      && (pivot !== null || done === path.pivots.length));
    return [h('p', {}, `After pivots ${from_pivot} and ${from_pivot + length} the basis is the same: ${
      explorer.words.many(length, 'pivot')} lead back to where they began, and the rule would `
      + 'repeat them for ever.'),
    h('button', { type: 'button', onclick: () => app.go(frame) }, `Go to pivot ${from_pivot + 1}`)];
  }

  function update(app) {
    const { path, frame } = app;
    const { status, reason } = path.outcome;
    const at_end = frame === path.last;
    by_id('outcome-panel').hidden = !at_end;
    if (!at_end) return;
    const titles = { solved: 'The solution', ray: 'A ray', cycle: 'A cycle',
      pivot_limit: 'Stopped', numerical_breakdown: 'Numerical breakdown' };
    by_id('outcome-title').textContent = titles[status] || status;
    const body = status === 'solved' ? [solution_table(app)] : status === 'ray' && path.outcome.ray
      ? ray_panel(app) : status === 'cycle' && path.outcome.cycle ? cycle_panel(app)
        : [h('p', {}, explorer.words.sentence(path, frame))];
    const words = reason && `${reason[0].toUpperCase()}${reason.slice(1).replace(/\.?$/, '.')}`;
    replace('outcome', words ? h('p', {}, words) : null, body);
  }

  explorer.view_outcome = { update };
})();
