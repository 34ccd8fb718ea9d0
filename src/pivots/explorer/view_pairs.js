// Complementary pairs: a column of two boxes each, w above z, the basic one filled.
(() => {
  const { svg, replace, h, by_id } = drawing.elements;
  const { picture, name, names } = explorer.elements;

  function update(app) {
    const { path, frame, problem } = app;
    const n = problem.size;
    const basic = new Set(path.frames[frame].rows);
    const missing = new Set(path.missing_pairs(frame));
    const named = n <= 28;
    const cell = named ? 28 : 14;
    const side = named ? 16 : 9;
    const tall = 2 * side + 3 + (named ? 18 : 8);
    const room = Math.max(200, Math.min(420, by_id('pairs').clientWidth || 400));
    const across = Math.max(1, Math.floor((room - (named ? 24 : 6)) / cell));
    const left = named ? 18 : 2;
    const lines = Math.ceil(n / across);
    const marks = [];
    for (let i = 0; i < n; ++i) {
      const x = left + (i % across) * cell + (cell - side) / 2;
      const y = 3 + Math.floor(i / across) * (tall + 6);
      const w = basic.has(i);
      const z = basic.has(n + i);
      const gone = missing.has(i);
      const which = w && z ? 'both are' : w ? `${problem.names[i]} is`
        : z ? `${problem.names[n + i]} is` : 'neither is';
      marks.push(svg('g', { class: gone ? 'pair missing' : 'pair' },
        svg('title', {}, `Pair ${i + 1}: ${which} basic`),
        svg('rect', { class: w ? 'basic w' : 'nonbasic', x, y, width: side, height: side,
          rx: 1.5 }),
        svg('rect', { class: z ? 'basic z' : 'nonbasic', x, y: y + side + 3, width: side,
          height: side, rx: 1.5 }),
        gone && svg('rect', { class: 'frame', x: x - 3, y: y - 2.5, width: side + 6,
          height: 2 * side + 8, rx: 3 }),
        named && svg('text', { x: x + side / 2, y: y + 2 * side + 18, 'text-anchor': 'middle' },
          i + 1)));
    }
    const letters = named ? [...Array(lines).keys()].flatMap((line) => [['w', 0], ['z', 1]].map(
      ([letter, k]) => svg('text', { class: 'letter', x: 4,
        y: 3 + line * (tall + 6) + k * (side + 3) + side - 4 }, letter))) : [];
    const height = lines * (tall + 6) + 2;
    const unknowns = [...basic].filter((x) => x >= n && x < 2 * n).sort((a, b) => a - b)
      .map((x) => problem.names[x]);
    const missing_text = [...missing].map((i) => i + 1).join(', ');
    const z0_basic = basic.has(problem.artificial);
    const used = left + Math.min(n, across) * cell + 4;
    replace('pairs', picture({ viewBox: `0 0 ${used} ${height}`, class: 'pairs', width: used },
      'Complementary pairs', `Missing pair: ${missing_text || 'none'}. Basic z: ${
        unknowns.join(', ') || 'none'}.`, letters, marks),
    h('ul', { class: 'facts' },
      h('li', {}, 'Basic z: ', unknowns.length ? names(unknowns, 12) : 'none'),
      h('li', {}, missing.size ? h('strong', {}, `Missing pair: ${missing_text}`)
        : 'No pair is missing', missing.size ? ' \u2013 both its variables are 0, z0 has its place.'
        : z0_basic ? '.' : ': one variable of each pair is basic.'),
      h('li', {}, name('z0'), z0_basic ? ' is basic: ' : ' is not basic: ',
        app.text(path.z0(frame)))));
  }

  explorer.view_pairs = { update };
})();
