// Of a problem with two pairs: the plane of q, its complementary cones, and q + z0 d on its way.
//
// w - M z = q + z0 d: the point lies in the cone of the columns I_i (of basic w_i) and -M_i (of
// basic z_i).
(() => {
  const { svg, replace, by_id } = drawing.elements;
  const { picture } = explorer.elements;
  const { add, scale, subtract, length } = drawing.vectors;
  const size = 320;
  const room = 34; // around what is drawn, for names

  /// Where a column points; of numbers too large for decimals roughly.
  const direction = (v) => (v.every(Number.isFinite) ? v
    : v.map((x) => (Number.isFinite(x) ? 0 : Math.sign(x))));

  /// The columns of w1, w2, z1, z2, and q and d, as the run has them.
  function plane(app, run) {
    const { problem, recorded } = app;
    const given = explorer.certificate.as_given(recorded, run);
    const entry = (r, c) => problem.number(given.entry(r, c));
    const column = (c) => direction([entry(0, c), entry(1, c)]);
    return { generators: [[1, 0], [0, 1], scale(column(0), -1), scale(column(1), -1)],
      d: column(2), q: [0, 1].map((r) => problem.number(given.value(r)[0])) };
  }

  /// Where q + z0 d stands at a frame.
  const lifted = ({ problem, path }, { q, d }, frame) =>
    add(q, scale(d, problem.number(path.z0(frame)[0])));

  function update(app) {
    const { problem, path, frame } = app;
    const { run } = path.frames[frame];
    const space = problem.size === 2 && problem.levels === 1 && plane(app, run);
    const shown = space && space.q.every(Number.isFinite);
    by_id('cones-panel').hidden = !shown;
    if (!shown) return;
    const frames = [...path.frames.keys()].filter((k) => path.frames[k].run === run);
    const points = frames.map((k) => lifted(app, space, k));
    const here = lifted(app, space, frame);
    const most = Math.max(...[space.q, ...points].flat().map(Math.abs)) || 1;
    const unit = (size / 2 - room) / most;
    const pixel = ([x, y]) => [size / 2 + unit * x, size / 2 - unit * y];
    const text = (p) => p.map((x) => x.toFixed(1)).join();
    const far = (v) => scale(v, 3 * most / (length(v) || 1));
    const basic = new Set(path.frames[frame].rows);

    const sector = (a, b) => {
      const [one, other] = [far(space.generators[a]), far(space.generators[b])];
      const holds = basic.has(a) && basic.has(b);
      return svg('polygon', { class: holds ? 'sector basic' : 'sector',
        points: [[0, 0], one, add(one, other), other].map((p) => text(pixel(p))).join(' ') },
      svg('title', {}, `${problem.names[a]} and ${problem.names[b]} basic`));
    };
    /// The arrow's name stands at the picture's edge.
    const edge = (variable) => {
      const v = space.generators[variable];
      const reach = Math.max(...v.map(Math.abs));
      if (reach === 0) return null;
      const [x1, y1] = pixel([0, 0]);
      const [x2, y2] = pixel(scale(v, most / reach));
      const [x, y] = pixel(scale(v, (1 + 20 / (size / 2 - room)) * most / reach));
      const inside = (place) => Math.max(14, Math.min(size - 14, place));
      // A column along an axis is not named over its w.
      const aside = variable > 1 && Math.min(...v.map(Math.abs)) === 0 ? 16 : 0;
      return [svg('line', { class: basic.has(variable) ? 'edge basic' : 'edge', x1, y1, x2, y2 }),
        svg('text', { x: inside(x + aside), y: inside(y + 5 - aside), 'text-anchor': 'middle',
          class: basic.has(variable) && 'strong' }, problem.names[variable])];
    };
    const dot = (kind, p, r) => svg('circle', { class: kind, cx: pixel(p)[0], cy: pixel(p)[1], r });
    const [x1, y1] = pixel(space.q);
    const [x2, y2] = pixel(points.reduce((a, b) =>
      (length(subtract(b, space.q)) > length(subtract(a, space.q)) ? b : a)));
    const z0 = path.z0(frame);
    const is_home = problem.number(z0[0]) === 0;
    const side = pixel(here)[0] > size - 90 ? 'end' : 'start';
    const names = [...basic].filter((x) => x < 4).map((x) => problem.names[x]);
    replace('cones', picture({ viewBox: `0 0 ${size} ${size}`, class: 'cones', width: size },
      'The complementary cones and q + z0 d',
      `At this step z0 is ${explorer.number_text.value(problem, z0)}; basic: ${
        names.join(' and ')}${is_home ? ', whose cone holds q' : ''}.`,
      [[0, 1], [2, 1], [0, 3], [2, 3]].map(([a, b]) => sector(a, b)),
      [0, 1, 2, 3].map(edge), svg('line', { class: 'way', x1, y1, x2, y2 }),
      points.map((p) => dot('dot', p, 2.5)), dot('q', space.q, 4.5),
      svg('text', { class: 'label', x: x1 - 9, y: y1 + 16, 'text-anchor': 'end' }, 'q'),
      dot('now', here, 6),
      !is_home && svg('text', { class: 'label', x: pixel(here)[0] + (side === 'end' ? -11 : 11),
        y: pixel(here)[1] - 9, 'text-anchor': side }, 'q + z0 d')));
  }

  explorer.view_cones = { update };
})();
