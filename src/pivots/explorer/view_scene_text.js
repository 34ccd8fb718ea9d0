// The panel around the drawing: which part is drawn, what z0 hides, and the same in words.
(() => {
  const { h, parsed, table, replace, by_id } = drawing.elements;
  const { name } = explorer.elements;
  const { decimal } = explorer.number_text;
  const { figures } = explorer.view_scene;
  const { length, cross, scale, dot, add } = drawing.vectors;

  /// z and w of the present basis in SI units, by level [times S, finite], w without d z0.
  function unknowns(app) {
    const { problem, path, frame } = app;
    const n = problem.size;
    const dictionary = path.dictionary(frame);
    const { run } = path.frames[frame];
    const large = app.unit_of_S(run);
    const all = Array.from({ length: 2 * n + 1 }, () => [0, 0]);
    dictionary.rows.forEach((variable, r) => {
      const value = dictionary.value(r).map((x, k) =>
        (dictionary.is_value_noise(r, k) ? 0 : problem.number(x)));
      const levels = value.length === 2 ? [value[0] / large, value[1]] : [0, value[0]];
      all[variable] = levels.map((part) => part * app.unit(run, variable));
    });
    const z0 = all[2 * n];
    const lift = app.cover(run).map((d, i) => z0.map((part) => part * d * app.unit(run, i)));
    const w = all.slice(0, n).map((x, i) => x.map((part, k) => {
      const size = Math.abs(part) + Math.abs(lift[i][k]);
      const rest = part - lift[i][k];
      return Math.abs(rest) < 1e-11 * size ? 0 : rest; // rounding is not a broken law
    }));
    return { z: all.slice(n, 2 * n), w, z0 };
  }

  function now(app) {
    const { problem } = app;
    if (!problem.trace.scene) return null;
    const values = unknowns(app);
    const shown = explorer.mechanics.picture(problem.trace.scene, values.z, values.w);
    return { ...values, shown };
  }

  function contact_table(scene, modes, { forces, times }) {
    return h('div', { class: 'scroll' }, table('contacts',
      ['contact', 'in this basis', 'normal', 'friction'],
      scene.points.map(({ name: point }, i) => [point, scene.verbs[modes[i]],
        `${decimal(forces[i].normal, 4)}${times} N`,
        `${decimal(length(forces[i].friction), 4)}${times} N`]),
      { caption: `What the picture shows${times ? ', in units of S' : ''}` }));
  }

  const vector = (v) => `(${v.map((x) => decimal(Math.abs(x) < 1e-12 ? 0 : x, 3)).join(', ')})`;

  function motion_list(scene, level) {
    const { times } = level;
    const linear = level.acceleration.slice(0, 3);
    const spin = level.acceleration.slice(3);
    const reach = Math.max(...scene.points.map(({ position }) => length(position)));
    const small = 1e-3 * Math.max(length(linear), length(spin) * reach,
      ...level.bodies.map(length));
    const items = [h('li', {}, length(linear) > small
      ? `The object accelerates at ${decimal(length(linear), 4)}${times} m/s\u00b2 along ${
        vector(scale(linear, 1 / length(linear)))}.` : 'The object\u2019s centre of mass stays.')];
    if (length(spin) * reach > small) {
      const offset = scale(cross(spin, linear), 1 / dot(spin, spin));
      items.push(h('li', {}, `It turns at ${decimal(length(spin), 4)}${times} rad/s\u00b2 about `
        + `${vector(scale(spin, 1 / length(spin)))}, an axis through ${
          vector(add(scene.center_of_mass, offset))} m.`));
    }
    scene.bodies.forEach((body, b) => {
      const motion = level.bodies[b];
      if (length(motion) <= small) return;
      const turn = length(motion.slice(3)) * reach > small
        ? `, turning at ${vector(motion.slice(3))}${times} rad/s\u00b2` : '';
      items.push(h('li', {}, `${body.name} ${body.actuators.length ? 'moves' : 'is moved'} at ${
        vector(motion.slice(0, 3))}${times} m/s\u00b2${turn}.`));
    });
    return h('ul', { class: 'facts' }, items);
  }

  /// While z0 > 0: how far each law is still broken.
  function artificial_note(app, values) {
    const { problem } = app;
    if (explorer.mechanics.sign(values.z0) <= 0) return null;
    const worst = values.w.map((x, i) => ({ i, x }))
      .filter(({ x }) => explorer.mechanics.sign(x) < 0)
      .sort((a, b) => a.x[0] - b.x[0] || a.x[1] - b.x[1]);
    const text = (x) => (x[0] !== 0 ? `${decimal(x[0], 3)} S${x[1] ? ` ${
      x[1] < 0 ? '\u2212' : '+'} ${decimal(Math.abs(x[1]), 3)}` : ''}` : decimal(x[1], 3));
    return h('div', { class: 'note' },
      h('p', {}, h('strong', {}, 'Not yet an answer.'), ' z0 > 0: the artificial variable still lifts '
        + 'every row by d\u202fz0. Without it ', worst.length > 0
        ? `${explorer.words.many(worst.length, 'law')} would be broken:`
        : 'no law would be broken.'),
      worst.length > 0 && h('ul', {}, worst.slice(0, 4).map(({ i, x }) => h('li', {},
        name(problem.names[i]), ` = ${text(x)}`, problem.meanings[i]
          && h('span', { class: 'meaning' }, problem.meanings[i]))),
      worst.length > 4 && h('li', {}, `and ${worst.length - 4} more`)));
  }

  function update(app) {
    const { problem } = app;
    const { scene } = problem.trace;
    by_id('scene-panel').hidden = !scene;
    if (!scene) return;
    const values = now(app);
    const { shown } = values;
    const large = shown.has_large && app.show_large;
    const level = large ? shown.large : shown.finite;
    const switcher = shown.has_large && h('div', { class: 'switch', role: 'group',
      'aria-label': 'Part of the values' }, [[true, 'part times S'], [false, 'finite part']].map(
      ([value, text]) => h('button', { type: 'button', 'aria-pressed': String(value === large),
        onclick: () => { app.show_large = value; update(app); } }, text)));
    const parts = shown.has_large && h('p', { class: 'meaning' }, 'S stands for a number larger '
      + 'than all others: an actuator still stands at its bound \u2212S, so forces and motions '
      + 'have a part that is a multiple of S. Drawn here: the '
      + `${large ? 'part times S' : 'finite part'}.`);
    const width = Math.max(300, Math.min(480, by_id('scene').clientWidth || 440));
    replace('scene', switcher, parts,
      figures(scene, shown.modes, level, width).map(({ title, svg }) =>
        h('figure', {}, svg, h('figcaption', {}, title))),
      parsed(h('div'), scene.key), artificial_note(app, values), motion_list(scene, level),
      contact_table(scene, shown.modes, level));
  }

  explorer.view_scene_text = { update, now };
})();
