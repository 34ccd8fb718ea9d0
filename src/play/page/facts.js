// The answer in words and numbers.
(() => {
  const { h, table, replace } = drawing.elements;
  const { decimal } = drawing.numbers;

  const verbs = { stick: 'sticks', slide: 'slips', separate: 'opens', touch: 'touches' };

  const fact = (name, value, bad) =>
    h('div', {}, h('dt', {}, name), h('dd', { class: bad && 'bad' }, value));

  /// Statics' margin, until the law's own least grip is there.
  function held_words({ answer, grip_margin, is_bound }, breaking) {
    if (answer.holds_without_push === null) return ['not known', false];
    if (!answer.holds_without_push) return ['no, it falls', true];
    const least = breaking && breaking.smallest_grip_factor;
    const most = is_bound && !least ? 'up to ' : '';
    const margin = `, with ${most}${decimal(least ? 1 / least : grip_margin)} times the grip it needs`;
    return [`held${grip_margin ? margin : ''}`, false];
  }

  function open_fact({ unique }) {
    const open = ['motion', 'wrench'].find((what) => unique && unique[what] === false);
    return open && fact('Not the only answer',
      `the laws leave the ${open === 'motion' ? open : 'push'} open`);
  }

  function break_words(breaking) {
    if (!breaking) return '\u2026';
    if (breaking.refusal) return '\u2013';
    if (breaking.status === 'does_not_hold') return 'it does not hold';
    if (breaking.status !== 'solved') return 'not found';
    return breaking.breaks ? `${decimal(breaking.break_force)} N` : 'the push does not break it';
  }

  function grip_words(breaking) {
    if (!breaking) return '\u2026';
    if (breaking.refusal) return '\u2013';
    if (breaking.smallest_grip_from === 'no_grip') return 'none is enough';
    return Number.isFinite(breaking.smallest_grip) && breaking.smallest_grip !== null
      ? `${decimal(breaking.smallest_grip)} N` : 'not known';
  }

  function update(state, breaking) {
    const { answer } = state;
    const [held, bad] = held_words(state, breaking);
    replace('facts',
      fact('Held without the push', held, bad),
      fact('Grip that just holds it', grip_words(breaking)),
      fact('Push that breaks the grasp', break_words(breaking)),
      open_fact(answer),
      answer.residual && fact('Residual of the laws', decimal(answer.residual.max)),
      fact('Pivots', String(answer.pivots)),
      answer.jam && h('div', { class: 'jam' }, h('dt', {}, 'Why it jams'),
        answer.jam.words.map((words) => h('dd', {}, words))));
  }

  function contacts({ contacts: list }) {
    replace('contacts', list ? table('contacts', ['contact', 'does', 'normal N', 'friction N',
      'slip m/s\u00b2'], list.map((c) => [c.name, verbs[c.mode] || c.mode, decimal(c.normal_force),
      decimal(Math.hypot(...c.friction_force)), decimal(Math.hypot(...c.acceleration))]))
      : h('p', {}, 'No answer, no forces.'));
  }

  play.facts = { update, contacts };
})();
