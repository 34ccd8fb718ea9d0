// z0 after each pivot, from pivot 0, which lets it in. Where values have a part times S, that part has a panel of its own above.
(() => {
  const { svg, replace, by_id } = drawing.elements;
  const { picture } = explorer.elements;
  const { decimal } = explorer.number_text;
  const [left, right] = [58, 12];
  let width = 420; // of the place on the page, so that text keeps its size

  /// Round numbers around the data, at most four.
  function marks(least, most) {
    const span = most - least || 1;
    const power = 10 ** Math.floor(Math.log10(span / 2));
    const unit = [1, 2, 5, 10].map((x) => x * power).find((x) => span / x <= 4);
    const result = [];
    for (let k = Math.ceil(least / unit - 1e-9); k * unit <= most + 1e-9 * span; ++k)
      result.push(k * unit);
    return result;
  }

  /// The frames after a pivot: all but the first of each run.
  const after_pivots = (path) => path.frames.map((frame, k) => ({ ...frame, k }))
    .filter(({ done, run }) => done > path.runs[run].first_pivot);

  function line(places, x, y) {
    return places.map(({ run, done, value }, i) =>
      `${i > 0 && places[i - 1].run === run ? 'L' : 'M'}${x(done - 1).toFixed(1)} ${y(value).toFixed(1)}`).join('');
  }

  const last_pivot = (app) =>
    Math.max(app.path.pivots.length, app.path.branch ? app.recorded.pivots.length : 0, 2) - 1;

  function panel(app, level, top, height, label) {
    const { path, frame, problem, recorded } = app;
    const of = (which) => after_pivots(which).map((place) => ({ ...place,
      value: problem.number(which.z0(place.k)[level]) }));
    const places = of(path);
    const shadow = path.branch ? of(recorded) : [];
    const all = places.concat(shadow).map(({ value }) => value);
    const [least, most] = [Math.min(0, ...all), Math.max(...all, 0)];
    const y = (value) => top + height - height * (value - least) / (most - least || 1);
    const x = (pivot) => left + (width - left - right) * pivot / last_pivot(app);
    const here = places.find(({ k }) => k === frame);
    const at = here && x(here.done - 1);
    const side = at > width - 80 ? 'end' : 'start';
    return [
      marks(least, most).map((value) => [
        svg('line', { class: 'grid', x1: left, x2: width - right, y1: y(value), y2: y(value) }),
        svg('text', { x: left - 6, y: y(value) + 4, 'text-anchor': 'end' }, decimal(value, 3))]),
      svg('text', { class: 'axis', x: left, y: top - 9 }, label),
      svg('path', { class: 'shadow', d: line(shadow, x, y) }),
      svg('path', { class: 'line', d: line(places, x, y) }),
      path.last <= 60 && places.map(({ done, value }) => svg('circle', { class: 'dot', cx: x(done - 1),
        cy: y(value), r: 2.5 })),
      here && [svg('line', { class: 'now', x1: at, x2: at, y1: top - 4, y2: top + height }),
        svg('circle', { class: 'now', cx: at, cy: y(here.value), r: 5 }),
        svg('text', { class: 'here', x: at + (side === 'end' ? -9 : 9),
          y: y(here.value) - 9 < top + 10 ? y(here.value) + 19 : y(here.value) - 9, 'text-anchor': side },
        decimal(here.value, 4))],
    ];
  }

  function update(app) {
    width = Math.max(240, Math.min(520, by_id('chart').clientWidth || 420));
    const { path, problem, frame } = app;
    const large = problem.levels === 2
      && path.frames.some((_, k) => problem.number(path.z0(k)[0]) !== 0);
    const panels = large ? [panel(app, 0, 26, 70, 'z0, times S'),
      panel(app, 1, 142, 84, 'z0, finite part')] : [panel(app, problem.levels - 1, 26, 110, 'z0')];
    const height = large ? 262 : 172;
    const last = last_pivot(app);
    const pivot_marks = marks(0, last).filter(Number.isInteger);
    const jump = (event) => {
      const bounds = event.currentTarget.getBoundingClientRect();
      const across = (event.clientX - bounds.left) / bounds.width * width;
      const nearest = Math.round((across - left) / (width - left - right) * last);
      const place = nearest < last ? after_pivots(path).find(({ done }) => done > nearest) : null;
      app.go(place ? place.k : path.last);
    };
    replace('chart', picture({ viewBox: `0 0 ${width} ${height}`, class: 'chart', width,
      onclick: jump },
      'z0 after each pivot', `${path.where(frame)}: z0 is ${
        explorer.number_text.value(problem, path.z0(frame))}. Click to jump to a pivot.`,
      panels, pivot_marks.map((k) => svg('text', { x: left + (width - left - right) * k / last,
        y: height - 18, 'text-anchor': 'middle' }, k)),
      svg('text', { class: 'axis', x: width - right, y: height - 3, 'text-anchor': 'end' },
        'after pivot')));
  }

  explorer.view_chart = { update };
})();
