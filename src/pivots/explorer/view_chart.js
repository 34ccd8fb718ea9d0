// z0 against the step. Where values have a part times S, that part has a panel of its own above.
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

  function line(path, values, x, y) {
    let run = -1;
    return path.frames.map((frame, k) => {
      const begin = frame.run !== run;
      run = frame.run;
      return `${begin ? 'M' : 'L'}${x(k).toFixed(1)} ${y(values[k]).toFixed(1)}`;
    }).join('');
  }

  function panel(app, level, top, height, label) {
    const { path, frame, problem, recorded } = app;
    const of = (which) => which.frames.map((_, k) => problem.number(which.z0(k)[level]));
    const values = of(path);
    const shadow = path.branch ? of(recorded) : null;
    const all = shadow ? values.concat(shadow) : values;
    const [least, most] = [Math.min(0, ...all), Math.max(...all, 0)];
    const last = Math.max(path.last, shadow ? recorded.last : 0, 1);
    const y = (value) => top + height - height * (value - least) / (most - least || 1);
    const x = (k) => left + (width - left - right) * k / last;
    const here = values[frame];
    const side = x(frame) > width - 80 ? 'end' : 'start';
    return [
      marks(least, most).map((value) => [
        svg('line', { class: 'grid', x1: left, x2: width - right, y1: y(value), y2: y(value) }),
        svg('text', { x: left - 6, y: y(value) + 4, 'text-anchor': 'end' }, decimal(value, 3))]),
      svg('text', { class: 'axis', x: left, y: top - 9 }, label),
      shadow && svg('path', { class: 'shadow', d: line(recorded, shadow, x, y) }),
      svg('path', { class: 'line', d: line(path, values, x, y) }),
      path.last <= 60 && values.map((value, k) => svg('circle', { class: 'dot', cx: x(k),
        cy: y(value), r: 2.5 })),
      svg('line', { class: 'now', x1: x(frame), x2: x(frame), y1: top - 4, y2: top + height }),
      svg('circle', { class: 'now', cx: x(frame), cy: y(here), r: 5 }),
      svg('text', { class: 'here', x: x(frame) + (side === 'end' ? -9 : 9),
        y: y(here) - 9 < top + 10 ? y(here) + 19 : y(here) - 9, 'text-anchor': side },
      decimal(here, 4)),
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
    const last = Math.max(path.last, path.branch ? app.recorded.last : 0, 1);
    const step_marks = marks(0, last).filter(Number.isInteger);
    const jump = (event) => {
      const bounds = event.currentTarget.getBoundingClientRect();
      const across = (event.clientX - bounds.left) / bounds.width * width;
      app.go(Math.round((across - left) / (width - left - right) * last));
    };
    replace('chart', picture({ viewBox: `0 0 ${width} ${height}`, class: 'chart', width,
      onclick: jump },
      'z0 against the step', `At step ${frame} z0 is ${
        explorer.number_text.value(problem, path.z0(frame))}. Click to jump to a step.`,
      panels, step_marks.map((k) => svg('text', { x: left + (width - left - right) * k / last,
        y: height - 18, 'text-anchor': 'middle' }, k)),
      svg('text', { class: 'axis', x: width - right, y: height - 3, 'text-anchor': 'end' },
        'step')));
  }

  explorer.view_chart = { update };
})();
