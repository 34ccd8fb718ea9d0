// Sentences that the trace does not bring along: ties, branches, ends.
(() => {
  const tie_words = {
    none: 'No tie: one row alone blocks.',
    artificial: 'z0 is among the tied variables and leaves first, because that is a solution.',
    lexicographic: 'The lexicographic rule decides, by an infinitely small change of q; it cannot '
      + 'cycle.',
    first_row: 'The first tied row leaves. This rule may cycle.',
    tie_column: 'Fixed generic numbers decide, an infinitely small change of q.',
    largest_pivot: 'The largest pivot element decides, which loses the fewest digits.',
    chosen: 'Chosen by hand.',
  };

  const rule_words = {
    lexicographic: 'lexicographic rule', first_row: 'first row', generic: 'generic numbers',
    chosen: 'ties chosen by hand',
  };

  const status_words = {
    solved: 'solved', ray: 'ends in a ray', cycle: 'cycles', pivot_limit: 'stopped at the limit',
    numerical_breakdown: 'numerical breakdown',
  };

  const many = (count, word) => `${count} ${word}${count === 1 ? '' : 's'}`;

  /// "+x", or three numbers.
  function direction_text(v) {
    for (let axis = 0; axis < 3; ++axis)
      for (const sign of [1, -1])
        if (Math.hypot(...v.map((x, k) => x - (k === axis ? sign : 0))) < 5e-4)
          return `${sign > 0 ? '+' : '-'}${'xyz'[axis]}`;
    return `(${v.map((x) => Math.round(x * 1000) / 1000 + 0).join(', ')})`;
  }

  /// " towards +x": where a point starts to slide, against the friction of the basis; as C++ says
  /// it of recorded pivots.
  function sliding(path, frame_number, { entering, leaving }) {
    const { scene } = path.problem.trace;
    const point = scene && scene.points.find(({ slip }) => slip === leaving);
    if (!point) return '';
    const { add, scale, length } = drawing.vectors;
    const basic = new Set([...path.frames[frame_number].rows, entering]);
    const acting = point.generators.filter((_, j) =>
      basic.has(path.problem.size + point.friction[j]));
    const force = acting.reduce((sum, generator) => add(sum, generator.force), [0, 0, 0]);
    const size = length(force);
    const text = size > 1e-9 ? ` towards ${direction_text(scale(force, -1 / size))}` : '';
    if (acting.reduce((sum, { torque }) => sum + (torque || 0), 0) === 0) return text;
    return `${text}${text ? ', turning' : ' by turning'}`;
  }

  /// As the recorded pivots are told, where the trace brings what its variables mean.
  function meant_sentence(path, frame_number, pivot) {
    const { entering, leaving } = pivot;
    const { variables } = path.problem.trace;
    const { grows } = variables[entering];
    if (!variables[leaving].ends) return null;
    const ends = variables[leaving].ends + sliding(path, frame_number, pivot);
    return entering === path.problem.artificial
      ? `The artificial variable z0 enters, just large enough for every law to hold with its help; ${ends}.`
      : `As ${grows}, ${ends}.`;
  }

  /// Why the row does not leave, which neither leaves nor ties; whether it `tells` which one does.
  function why_not(path, frame_number, row, as_fraction = true, tells = true) {
    const { problem } = path;
    const { entering, leaving, ratios } = path.step(frame_number);
    const { rows } = path.dictionary(frame_number);
    const name = (variable) => problem.names[variable];
    const [tried, other] = [name(rows[row]), tells ? name(leaving) : 'another row'];
    const at = (r) => explorer.number_text.value(problem, ratios[r], as_fraction);
    const ratio = ratios && ratios[row];
    if (entering === problem.artificial)
      return !ratio ? `Not ${tried}: it is not below 0 and needs no z0.`
        : `Not ${tried}: it is lifted to 0 at z0 = ${at(row)} already, while ${other} would still be `
          + 'negative.';
    if (!ratio)
      return `Not ${tried}: it does not fall as ${name(entering)} grows, so it never reaches 0.`;
    const first = tells ? `, which is 0 at ${at(rows.indexOf(leaving))},` : '';
    return `Not ${tried}: it reaches 0 only at ${name(entering)} = ${at(row)}. There ${other}${
      first} would be negative.`;
  }

  /// "z3 enters and grows to 5/2. w2 falls to 0 first and leaves."
  function pivot_sentence(path, pivot) {
    const { problem } = path;
    const name = (variable) => problem.names[variable];
    const { entering, leaving, ties } = pivot;
    const row = pivot.ratios ? pivot.ratios.find((_, r) => pivot.basis[r] === entering) : null;
    const still = row && row.every((x) => problem.number(x) === 0);
    const to = still ? ' but stays at 0, nothing moves' : row
      ? ` and grows to ${explorer.number_text.value(problem, row)}` : '';
    const tied = ties.length > 1 ? `, tied with ${many(ties.length - 1, 'other')},` : '';
    if (entering === problem.artificial)
      return `z0 enters${to}: just enough to lift every value to 0 or above. `
        + `${name(leaving)} needs z0 most${tied} and leaves.`;
    if (leaving === problem.artificial)
      return `${name(entering)} enters${to}. z0 falls to 0${tied} and leaves: a solution.`;
    return still ? `${name(entering)} enters${to}: ${name(leaving)} is 0 already${tied} and leaves.`
      : `${name(entering)} enters${to}. ${name(leaving)} falls to 0 first${tied} and leaves.`;
  }

  function end_sentence(path) {
    const { problem } = path;
    const { status, reason, ray, cycle } = path.outcome;
    if (status === 'solved')
      return path.pivots.length ? 'z0 has left: every pair has one variable at 0. Solved.'
        : 'No value is negative: z = 0 is a solution, without a pivot.';
    if (status === 'ray')
      return `${problem.names[ray.entering]} enters, and nothing blocks it: a ray. `
        + 'This path ends without an answer.';
    if (status === 'cycle')
      return `The basis after pivot ${cycle.from_pivot} has come back `
        + `${many(cycle.length, 'pivot')} later: from here the method would turn in a circle.`;
    if (status === 'pivot_limit') return 'The limit of pivots is reached, without an end in sight.';
    return `Numerical breakdown${reason ? `: ${reason}` : ''}.`;
  }

  function sentence(path, frame_number) {
    const frame = path.frames[frame_number];
    if (frame.pivot !== null) {
      const pivot = path.pivots[frame.pivot];
      return pivot.sentence || meant_sentence(path, frame_number, pivot) || pivot_sentence(path, pivot);
    }
    if (frame_number === path.last) return end_sentence(path);
    return `This run ends here. Next: ${path.runs[frame.run + 1].title}.`;
  }

  explorer.words = { tie_words, rule_words, status_words, many, sentence, meant_sentence, why_not };
})();
