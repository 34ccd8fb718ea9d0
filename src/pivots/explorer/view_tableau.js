// The tableau: a table of the rows and columns in sight, with empty space for the others, so that
// 200 rows and columns cost no more than 20.
(() => {
  const { h, by_id } = drawing.elements;
  const { name } = explorer.elements;
  const all_of_it = 26; // rows and columns up to which everything is drawn
  const beyond = 4;     // rows and columns drawn beyond the edge

  let app;
  let box;
  let drawn = '';

  const from_to = (first, end) => Array.from({ length: end - first }, (_, k) => first + k);
  const coarse = () => window.matchMedia('(pointer: coarse)').matches;
  const narrow = () => window.matchMedia('(max-width: 640px)').matches;

  /// Names, values and ratios stay in sight where there is room for a column beside them.
  const fixed_values = () => !narrow() || app.problem.levels === 1;

  const entry_text = (dictionary, r, c) => (dictionary.is_noise(r, c) ? '0'
    : explorer.number_text.scalar(app.problem, dictionary.entry(r, c), app.as_fractions));

  const head_row = 50; // as explorer.css has it

  /// In a room, the height between the page's words and its buttons, where that is enough for some rows.
  function height_in_room() {
    const above = box.getBoundingClientRect().top + window.scrollY;
    return Math.max(240, window.innerHeight - above - document.querySelector('.controls').offsetHeight - 8);
  }

  /// Columns and rows draw together, as far as their numbers let them, so that a tableau that nearly fits does.
  function sizes() {
    const small = narrow();
    const is_room = document.body.classList.contains('room');
    const room = is_room ? 1.4 : 1;
    const dictionary = app.path.dictionary(app.frame);
    const across = box.parentElement.clientWidth - 2;
    const head = room * (small ? 62 : 112);
    const widest = room * (app.problem.exact ? 108 : 94);
    const for_letters = (texts) => room * Math.max(70, 20 + 9 * Math.max(...texts.map((text) => text.length)));
    const is_long = dictionary.width > all_of_it;
    const least = is_long ? widest : for_letters(dictionary.rows.flatMap((_, r) =>
      dictionary.columns.map((__, c) => entry_text(dictionary, r, c))));
    let value = room * (app.problem.levels === 2 ? 172 : small ? 74 : 100);
    if (!is_long) {
      const texts = dictionary.rows.map((_, r) => value_text(dictionary, r))
        .concat((app.path.step(app.frame)?.ratios ?? []).map((ratio) => (ratio === null ? '' : app.text(ratio))));
      const spare = (across - head - least * dictionary.width) / 2;
      value = Math.min(value, Math.max(for_letters(texts), spare));
    }
    const free = (across - head - 2 * value) / dictionary.width;
    const row = room * (small || coarse() ? 46 : 34);
    const rows = is_room ? (height_in_room() - head_row - 2) / dictionary.size : row;
    return { row: Math.floor(Math.min(row, Math.max(30, rows))), head, value: Math.floor(value),
      ratio: Math.floor(value), column: Math.floor(Math.min(widest, Math.max(least, free))) };
  }

  /// Which way the tableau goes on out of sight.
  function tell_what_is_hidden() {
    const hidden = [box.scrollWidth > box.clientWidth + 1 && 'columns \u2192',
      box.scrollHeight > box.clientHeight + 1 && 'rows \u2193'].filter(Boolean);
    by_id('more').textContent = hidden.length ? `scrolls: more ${hidden.join(', more ')}` : '';
  }

  const value_text = (dictionary, r) => (dictionary.value(r).every((_, k) => dictionary.is_value_noise(r, k)) ? '0'
    : explorer.number_text.value_of_row(app.problem, dictionary, r, app.as_fractions));

  /// The first and last index to draw of `count`, each `size` long.
  function range(count, scrolled, seen, size) {
    if (count <= all_of_it) return [0, count];
    const first = Math.max(0, Math.floor(scrolled / size) - beyond);
    return [first, Math.max(first, Math.min(count, Math.ceil((scrolled + seen) / size) + beyond))];
  }

  function context() {
    const { path, frame } = app;
    const dictionary = path.dictionary(frame);
    const step = path.step(frame);
    const entering = path.entering(frame);
    const asks = app.asks();
    const tied = new Set(step && !asks ? step.ties : []);
    return { dictionary, step, tied, asks,
      row: step && !asks ? dictionary.rows.indexOf(step.leaving) : -1,
      column: entering === null ? -1 : dictionary.columns.indexOf(entering) };
  }

  function head_cell(now, c) {
    const variable = now.dictionary.columns[c];
    const enters = c === now.column;
    return h('th', { scope: 'col', class: enters ? 'entering' : null, 'data-column': c,
      'aria-colindex': c + 4, title: app.problem.meanings[variable] || null },
      name(app.problem.names[variable]), enters && h('span', { class: 'role' }, 'enters'));
  }

  /// The row that leaves goes on, a tied one branches off; for any other it is said why not.
  function try_row(now, r) {
    const { leaving, ties } = now.step;
    const variable = now.dictionary.rows[r];
    const [leaves, is_tied] = [variable === leaving, ties.includes(variable)];
    if (now.asks) app.guess(r, leaves || is_tied);
    else if (is_tied && !leaves) { app.branch(r); return; }
    else if (leaves) { app.go(app.frame + 1); return; }
    const right = leaves ? 'Right.' : `Right: it ties with ${app.problem.names[leaving]}, which leaves.`;
    by_id('tried').textContent = leaves || is_tied ? right
      : explorer.words.why_not(app.path, app.frame, r, app.as_fractions,
        !now.asks);
  }

  function ratio_cell(now, r) {
    const ratio = now.step && now.step.ratios ? now.step.ratios[r] : null;
    const text = now.asks ? '?' : ratio === null ? '\u2013' : app.text(ratio);
    if (!now.step) return h('td', { class: 'ratio' }, text);
    const variable = now.dictionary.rows[r];
    const name_of_row = app.problem.names[variable];
    const is_tied = now.tied.has(variable) && r !== now.row;
    const label = now.asks ? `Does ${name_of_row} leave?`
      : is_tied ? `What if ${name_of_row} leaves instead? Ratio ${text}`
      : `Let ${name_of_row} leave? Ratio ${ratio === null ? 'none' : text}`;
    return h('td', { class: 'ratio' }, h('button', { type: 'button',
      class: is_tied ? 'what-if-cell' : 'try-cell', 'aria-label': label, title: label,
      onclick: () => try_row(now, r) }, text));
  }

  function entry_cell(now, r, c) {
    const text = entry_text(now.dictionary, r, c);
    const classes = [c === now.column && 'entering', c === now.column && r === now.row && 'pivot',
      text === '0' && 'zero'].filter(Boolean).join(' ');
    return h('td', { class: classes || null, 'data-row': r, 'data-column': c }, text);
  }

  function body_row(now, r, [first, last]) {
    const { dictionary } = now;
    const { problem } = app;
    const variable = dictionary.rows[r];
    const leaves = r === now.row;
    const tied = now.tied.has(variable);
    const role = leaves ? 'leaves' : tied ? 'tied' : null;
    const kind = [leaves && 'leaving', tied && 'tied'].filter(Boolean).join(' ');
    const value = value_text(dictionary, r);
    const space = h('td', { class: 'space', 'aria-hidden': 'true' });
    return h('tr', { class: kind || null, 'data-row': r, 'aria-rowindex': r + 2 },
      h('th', { scope: 'row', title: problem.meanings[variable] || null },
        name(problem.names[variable]), role && h('span', { class: 'role' }, role)),
      h('td', { class: value === '0' ? 'value zero' : 'value', 'data-row': r }, value),
      ratio_cell(now, r), first > 0 && space,
      from_to(first, last).map((c) => entry_cell(now, r, c)),
      last < dictionary.width && space.cloneNode());
  }

  function draw(force) {
    const now = context();
    const { dictionary } = now;
    const size = sizes();
    const fixed = size.head + size.value + size.ratio;
    const columns = range(dictionary.width, box.scrollLeft - fixed, box.clientWidth, size.column);
    const rows = range(dictionary.size, box.scrollTop - head_row, box.clientHeight, size.row);
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
      h('th', { scope: 'col', class: 'ratio' }, 'ratio'), first > 0 && h('td', { class: 'space' }),
      from_to(first, last).map((c) => head_cell(now, c)), after > 0 && h('td', { class: 'space' }));
    const space = (count) => count > 0 && h('tr', { class: 'space', 'aria-hidden': 'true' },
      h('td', { colspan: widths.length, style: `height:${count * size.row}px` }));
    const body = h('tbody', {}, space(rows[0]),
      from_to(...rows).map((r) => body_row(now, r, columns)), space(dictionary.size - rows[1]));
    const total = widths.reduce((sum, x) => sum + x, 0);
    const held = document.activeElement.closest?.('.ratio button') && document.activeElement.closest('tr').dataset.row;
    box.replaceChildren(h('table', { class: 'tableau', style: `width:${total}px`,
      'aria-rowcount': dictionary.size + 1, 'aria-colcount': dictionary.width + 3 },
    h('caption', { class: 'for-readers' }, 'Each row: basic variable = value + entries times the '
      + 'nonbasic variables of the columns.'),
    h('colgroup', {}, widths.map((width) => h('col', { style: `width:${width}px` }))),
    h('thead', {}, head), body));
    if (held) box.querySelector(`tr[data-row="${held}"] .ratio button`)?.focus({ preventScroll: true });
    box.classList.toggle('fixed-values', fixed_values());
    box.style.setProperty('--head', `${size.head}px`);
    box.style.setProperty('--value', `${size.value}px`);
    box.style.setProperty('--row', `${size.row}px`);
    box.style.setProperty('--height-in-room', `${height_in_room()}px`);
    tell_what_is_hidden();
  }

  /// How far to scroll for the cell at `begin`, of which `sticky` must not cover anything.
  function in_sight(begin, size, scrolled, seen, sticky, spare) {
    if (begin < scrolled + sticky) return begin - sticky - spare;
    return begin + size > scrolled + seen ? begin + size + spare - seen : scrolled;
  }

  /// Scrolls the box, never the page, so that the pivot is in sight.
  function follow() {
    const now = context();
    const size = sizes();
    if (now.column < 0) [box.scrollLeft, box.scrollTop] = [0, 0];
    const fixed = size.head + size.value + size.ratio;
    const sticky = fixed_values() ? fixed : size.head;
    const spare = Math.max(0, Math.min(size.column / 2, box.clientWidth - sticky - size.column));
    if (now.column >= 0)
      box.scrollLeft = in_sight(fixed + now.column * size.column, size.column,
        box.scrollLeft, box.clientWidth, sticky, spare);
    if (now.row >= 0)
      box.scrollTop = in_sight(head_row + now.row * size.row, size.row,
        box.scrollTop, box.clientHeight, head_row, size.row);
  }

  function show_cell(r, c) {
    const { problem } = app;
    const { number_text } = explorer;
    const dictionary = app.path.dictionary(app.frame);
    const levels = c === null ? dictionary.value(r) : [dictionary.entry(r, c)];
    const value = number_text.full_value(problem, levels);
    const text = Array.isArray(value) ? `${value[0]} S + ${value[1]}` : value;
    let rounded = '';
    if (problem.exact && levels.length === 1 && text.includes('/')) {
      const decimal = number_text.decimal(problem.number(levels[0]), 8);
      rounded = ` ${number_text.is_whole(decimal, levels[0]) ? '=' : '\u2248'} ${decimal}`;
    }
    const where = c === null ? [', value: ']
      : [' per ', name(problem.names[dictionary.columns[c]]), ': '];
    by_id('cell').replaceChildren(name(problem.names[dictionary.rows[r]]), ...where,
      text.replace('-', number_text.minus), rounded);
  }

  function update(changed) {
    if (changed) {
      follow();
      by_id('tried').textContent = '';
    }
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
    return { update, try_row: (r) => {
      const now = context();
      if (now.step && r < now.dictionary.size) try_row(now, r);
    } };
  }

  explorer.view_tableau = { create };
})();
