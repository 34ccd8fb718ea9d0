// The tableau: a table of the rows and columns in sight, with empty space for the others, so that
// 200 rows and columns cost no more than 20.
(() => {
  const { h, name, by_id } = explorer.elements;
  const all_of_it = 26; // rows and columns up to which everything is drawn
  const beyond = 4;     // rows and columns drawn beyond the edge

  let app;
  let box;
  let drawn = '';

  const coarse = () => window.matchMedia('(pointer: coarse)').matches;
  const narrow = () => window.matchMedia('(max-width: 640px)').matches;

  /// Names, values and ratios stay in sight where there is room for a column beside them.
  const fixed_values = () => !narrow() || app.problem.levels === 1;

  function sizes() {
    const small = narrow();
    const value = app.problem.levels === 2 ? 172 : small ? 74 : 100;
    return { row: small || coarse() ? 46 : 34, head: small ? 62 : 112, value, ratio: value,
      column: app.problem.exact ? 108 : 94 };
  }

  /// The first and last index to draw of `count`, each `size` long.
  function range(count, scrolled, seen, size) {
    if (count <= all_of_it) return [0, count];
    const first = Math.max(0, Math.floor(scrolled / size) - beyond);
    return [first, Math.min(count, Math.ceil((scrolled + seen) / size) + beyond)];
  }

  function context() {
    const { path, frame } = app;
    const dictionary = path.dictionary(frame);
    const { pivot } = path.frames[frame];
    const step = pivot === null ? null : path.pivots[pivot];
    const entering = path.entering(frame);
    const tied = new Set(step ? step.ties : []);
    return { dictionary, step, tied,
      row: step ? dictionary.rows.indexOf(step.leaving) : -1,
      column: entering === null ? -1 : dictionary.columns.indexOf(entering) };
  }

  function head_cell(now, c) {
    const variable = now.dictionary.columns[c];
    const enters = c === now.column;
    return h('th', { scope: 'col', class: enters ? 'entering' : null, 'data-column': c,
      'aria-colindex': c + 4, title: app.problem.meanings[variable] || null },
      name(app.problem.names[variable]), enters && h('span', { class: 'role' }, 'enters'));
  }

  function ratio_cell(now, r) {
    const ratio = now.step && now.step.ratios ? now.step.ratios[r] : null;
    const text = ratio === null ? '\u2013'
      : explorer.number_text.value(app.problem, ratio, app.as_fractions);
    const variable = now.dictionary.rows[r];
    if (!now.tied.has(variable) || r === now.row) return h('td', { class: 'ratio' }, text);
    const label = `What if ${app.problem.names[variable]} leaves instead? Ratio ${text}`;
    return h('td', { class: 'ratio' }, h('button', { type: 'button', class: 'what-if-cell',
      'aria-label': label, title: label, onclick: () => app.branch(r) }, text));
  }

  function body_row(now, r, [first, last]) {
    const { dictionary } = now;
    const { problem } = app;
    const variable = dictionary.rows[r];
    const leaves = r === now.row;
    const tied = now.tied.has(variable);
    const role = leaves ? 'leaves' : tied ? 'tied' : null;
    const kind = [leaves && 'leaving', tied && 'tied'].filter(Boolean).join(' ');
    const value = dictionary.value(r);
    const quiet = value.every((_, k) => dictionary.is_value_noise(r, k));
    const row = h('tr', { class: kind || null, 'data-row': r, 'aria-rowindex': r + 2 },
      h('th', { scope: 'row', title: problem.meanings[variable] || null },
        name(problem.names[variable]), role && h('span', { class: 'role' }, role)),
      h('td', { class: quiet ? 'value zero' : 'value', 'data-row': r },
        quiet ? '0'
          : explorer.number_text.value_of_row(problem, dictionary, r, app.as_fractions)),
      ratio_cell(now, r));
    if (first > 0) row.append(h('td', { class: 'space', 'aria-hidden': 'true' }));
    for (let c = first; c < last; ++c) {
      const zero = dictionary.is_noise(r, c);
      const text = zero ? '0'
        : explorer.number_text.scalar(problem, dictionary.entry(r, c), app.as_fractions);
      const classes = [c === now.column && 'entering', c === now.column && leaves && 'pivot',
        text === '0' && 'zero'].filter(Boolean).join(' ');
      row.append(h('td', { class: classes || null, 'data-row': r, 'data-column': c }, text));
    }
    if (last < dictionary.width) row.append(h('td', { class: 'space', 'aria-hidden': 'true' }));
    return row;
  }

  function draw(force) {
    const now = context();
    const { dictionary } = now;
    const size = sizes();
    const fixed = size.head + size.value + size.ratio;
    const columns = range(dictionary.width, box.scrollLeft - fixed, box.clientWidth, size.column);
    const rows = range(dictionary.size, box.scrollTop - 50, box.clientHeight, size.row);
    const key = `${columns} ${rows}`;
    if (!force && key === drawn) return;
    drawn = key;
    const [first, last] = columns;
    const before = first * size.column;
    const after = (dictionary.width - last) * size.column;
    const widths = [size.head, size.value, size.ratio, ...(first > 0 ? [before] : []),
      ...Array(last - first).fill(size.column), ...(after > 0 ? [after] : [])];
    const head = h('tr', { 'aria-rowindex': 1 },
      h('th', { scope: 'col', class: 'corner' }, 'basic'),
      h('th', { scope: 'col', class: 'value' }, 'value'),
      h('th', { scope: 'col', class: 'ratio' }, 'ratio'));
    if (first > 0) head.append(h('td', { class: 'space' }));
    for (let c = first; c < last; ++c) head.append(head_cell(now, c));
    if (after > 0) head.append(h('td', { class: 'space' }));
    const body = h('tbody', {});
    const space = (count) => h('tr', { class: 'space', 'aria-hidden': 'true' },
      h('td', { colspan: widths.length, style: `height:${count * size.row}px` }));
    if (rows[0] > 0) body.append(space(rows[0]));
    for (let r = rows[0]; r < rows[1]; ++r) body.append(body_row(now, r, columns));
    if (rows[1] < dictionary.size) body.append(space(dictionary.size - rows[1]));
    const total = widths.reduce((sum, x) => sum + x, 0);
    box.replaceChildren(h('table', { class: 'tableau', style: `width:${total}px`,
      'aria-rowcount': dictionary.size + 1, 'aria-colcount': dictionary.width + 3 },
    h('caption', { class: 'for-readers' }, 'Each row: basic variable = value + entries times the '
      + 'nonbasic variables of the columns.'),
    h('colgroup', {}, widths.map((width) => h('col', { style: `width:${width}px` }))),
    h('thead', {}, head), body));
    box.classList.toggle('fixed-values', fixed_values());
    box.style.setProperty('--head', `${size.head}px`);
    box.style.setProperty('--value', `${size.value}px`);
    box.style.setProperty('--row', `${size.row}px`);
  }

  /// Scrolls the box, never the page, so that the pivot is in sight.
  function follow() {
    const now = context();
    const size = sizes();
    if (now.column < 0) [box.scrollLeft, box.scrollTop] = [0, 0];
    const sticky = fixed_values() ? size.head + size.value + size.ratio : size.head;
    if (now.column >= 0) {
      const left = size.head + size.value + size.ratio + now.column * size.column;
      const spare = Math.max(0, Math.min(size.column / 2,
        box.clientWidth - sticky - size.column));
      if (left < box.scrollLeft + sticky) box.scrollLeft = left - sticky - spare;
      else if (left + size.column > box.scrollLeft + box.clientWidth)
        box.scrollLeft = left + size.column + spare - box.clientWidth;
    }
    if (now.row >= 0) {
      const top = 50 + now.row * size.row;
      if (top < box.scrollTop + 50) box.scrollTop = top - 50 - size.row;
      else if (top + size.row > box.scrollTop + box.clientHeight)
        box.scrollTop = top + 2 * size.row - box.clientHeight;
    }
  }

  function show_cell(r, c) {
    const { problem } = app;
    const dictionary = app.path.dictionary(app.frame);
    const row = problem.names[dictionary.rows[r]];
    const { number_text } = explorer;
    let text;
    let rounded = null;
    if (c === null) {
      const value = number_text.full_value(problem, dictionary.value(r));
      text = Array.isArray(value) ? `${value[0]} S + ${value[1]}` : value;
      if (problem.exact && dictionary.levels === 1)
        rounded = problem.number(dictionary.value(r)[0]);
    } else {
      const entry = dictionary.entry(r, c);
      text = number_text.full_scalar(problem, entry);
      if (problem.exact) rounded = problem.number(entry);
    }
    const where = c === null ? [name(row), ', value: ']
      : [name(row), ' per ', name(problem.names[dictionary.columns[c]]), ': '];
    const extra = rounded !== null && text.includes('/')
      ? ` \u2248 ${number_text.decimal(rounded, 8)}` : '';
    by_id('cell').replaceChildren(...where, text.replace('-', number_text.minus), extra);
  }

  function update(changed) {
    if (changed) follow();
    draw(true);
    if (changed) { follow(); draw(false); }
    const now = context();
    if (now.row >= 0 && now.column >= 0) show_cell(now.row, now.column);
    else by_id('cell').replaceChildren('Choose a cell to see its number in full.');
  }

  function create(application) {
    app = application;
    box = by_id('tableau');
    box.addEventListener('scroll', () => draw(false), { passive: true });
    window.addEventListener('resize', () => draw(true));
    box.addEventListener('click', (event) => {
      const cell = event.target.closest('td[data-row]');
      if (cell) show_cell(Number(cell.dataset.row),
        cell.dataset.column === undefined ? null : Number(cell.dataset.column));
    });
    return { update };
  }

  explorer.view_tableau = { create };
})();
