// What happens at this step, in words: the sentence, who enters and leaves, ties, other choices.
(() => {
  const { h, by_id, replace } = drawing.elements;
  const { name, names } = explorer.elements;

  function move(problem, role, variable, value) {
    return [h('dt', {}, role), h('dd', {}, name(problem.names[variable]),
      problem.meanings[variable] && h('span', { class: 'meaning' }, problem.meanings[variable]),
      value && h('span', { class: 'meaning' }, value))];
  }

  function tie_choices(app, step) {
    if (step.ties.length < 2) return [];
    const { problem } = app;
    const dictionary = app.path.dictionary(app.frame);
    const others = step.ties.filter((variable) => variable !== step.leaving);
    const choice = h('select', { id: 'branch-rule', onchange: (event) => {
      app.branch_rule = event.target.value;
    } }, [['lexicographic', 'lexicographic rule'], ['first_row', 'first row (may cycle)']].map(
      ([value, text]) => h('option', { value, selected: app.branch_rule === value }, text)));
    return [
      h('h3', {}, 'What if another tied row leaves?'),
      h('div', { class: 'choices' }, others.map((variable) => h('button', { type: 'button',
        class: 'what-if', 'data-variable': problem.names[variable],
        onclick: () => app.branch(dictionary.rows.indexOf(variable)) },
      name(problem.names[variable]), ' leaves')),
      h('label', { for: 'branch-rule' }, 'later ties: '), choice),
    ];
  }

  function update(app) {
    const { path, frame, problem } = app;
    const { run } = path.frames[frame];
    const step = path.step(frame);
    const asks = app.asks();
    by_id('sentence').textContent = asks ? `${problem.names[step.entering]} enters. Which row leaves? Press its ratio.`
      : explorer.words.sentence(path, frame);
    const moves = [];
    if (asks) {
      moves.push(...move(problem, 'Enters', step.entering, null));
    } else if (step) {
      const row = path.dictionary(frame).rows.indexOf(step.leaving);
      const ratio = step.ratios && step.ratios[row];
      const to = ratio && app.text(ratio);
      const growth = ratio && (to === '0' ? 'stays at 0, a degenerate pivot' : `grows to ${to}`);
      moves.push(...move(problem, 'Enters', step.entering, growth),
        ...move(problem, 'Leaves', step.leaving, null));
      if (step.ties.length > 1) {
        moves.push(h('dt', {}, 'Tied'), h('dd', {},
          names(step.ties.map((x) => problem.names[x]), 24),
          h('span', { class: 'meaning' }, explorer.words.tie_words[step.tie_break] || '')));
      }
    } else if (path.entering(frame) !== null) {
      moves.push(...move(problem, 'Enters', path.entering(frame), 'nothing blocks it'));
    }
    replace('moves', moves);
    replace('choices', step && !asks ? tie_choices(app, step) : []);
    const of_run = path.runs.length > 1 ? `Run ${run + 1} of ${path.runs.length}: ` : '';
    by_id('run').textContent = of_run + (path.runs[run].title || '');
    const banner = by_id('branch');
    banner.hidden = !path.branch;
    if (path.branch) {
      const chosen = path.pivots[path.branch.pivot].leaving;
      replace('branch-words', h('strong', {}, 'Your branch'), ` since pivot ${path.branch.pivot}: `,
        name(problem.names[chosen]), ` leaves, later ties by the ${
          explorer.words.rule_words[path.branch.rule]}; it ${
          explorer.words.status_words[path.outcome.status].replace('solved', 'is solved')
            .replace('stopped', 'is stopped')} after ${
          explorer.words.many(path.pivots.length, 'pivot')}.`);
    }
  }

  explorer.view_sentence = { update };
})();
