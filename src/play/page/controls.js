// Sliders with number boxes, made anew when the scene has other bodies. A control says how its
// value is read from the scene and how it is written into it.
(() => {
  const { h, by_id } = drawing.elements;
  const { edits, Toml } = play;
  const degrees = 180 / Math.PI;
  const tidy = (x) => Number(x.toPrecision(5));
  const number = (label, unit, least, most, step, read, write) =>
    ({ label, unit, least, most, step, read, write });

  /// Axes of the plane in which a vector is turned: x and y, unless it points out of that.
  function plane_of([x, y, z]) {
    if (Math.abs(z) <= Math.hypot(x, y)) return [0, 1];
    return Math.abs(y) > Math.abs(x) ? [1, 2] : [0, 2];
  }
  const angle_in = ([i, j], v) => tidy(Math.atan2(v[j], v[i]) * degrees);
  const length_in = ([i, j], v) => Math.hypot(v[i], v[j]);
  function in_plane([i, j], v, length, angle) {
    const result = [...v];
    const finer = (x) => Math.round(x * 1e9) / 1e9;
    result[i] = finer(length * Math.cos(angle / degrees));
    result[j] = finer(length * Math.sin(angle / degrees));
    return result;
  }

  function number_of(label, unit, section, key, least, most, step) {
    return number(label, unit, least, most, step,
      (toml) => toml.get(section(toml), key),
      (state, value) => edits.set(state.text, section, key, value));
  }

  /// Kept in metres and shown in millimetres, also of speeds.
  function in_mm({ label, unit, least, most, step, read, write }) {
    const shown = (x) => (Number.isFinite(x) ? tidy(1000 * x) : x);
    return number(label, `m${unit}`, 1000 * least, shown(most), 1000 * step,
      (toml) => shown(read(toml)), (state, value) => write(state, value / 1000));
  }

  /// The length and the direction of the vector `key` in a plane; the rest of it stays.
  function vector_of(name, section, key, unit, most, step, plane) {
    const read = (toml) => toml.get(section(toml), key) || [0, 0, 0];
    const now = (state) => read(new Toml(state.text));
    const write = (state, value) => edits.set(state.text, section, key, value);
    let last = -90; // a vector of no length keeps its direction here
    const direction = (v) => {
      if (length_in(plane, v) > 0) last = angle_in(plane, v);
      return last;
    };
    return [
      number(name, unit, 0, most, step, (toml) => tidy(length_in(plane, read(toml))),
        (state, value) => write(state, in_plane(plane, now(state), value, direction(now(state))))),
      number(`direction from +${'xyz'[plane[0]]}`, '\u00b0', -180, 180, 1, (toml) => direction(read(toml)),
        (state, value) =>
          write(state, in_plane(plane, now(state), length_in(plane, now(state)), value))),
    ];
  }

  const choice = (label, options, read, write) => ({ label, options, read, write });

  const usual = 'parallel if opposed';

  function of_scene(toml) {
    const gravity = toml.get(edits.top(toml), 'gravity') || [0, 0, 0];
    return [
      ...vector_of('gravity', edits.top, 'gravity', 'm/s\u00b2', 20, 0.01, plane_of(gravity)),
      choice('facets', ['round', 4, 8, 16, 32],
        (now) => now.get(edits.top(now), 'facets') || 'round',
        (state, value) => edits.set(state.text, edits.top, 'facets', Number(value) || value)),
      choice('pressure', ['pad', 'even', 'rigid'],
        (now) => now.get(edits.top(now), 'pressure') || 'pad',
        (state, value) => edits.set(state.text, edits.top, 'pressure', value)),
      choice('jaws', [usual, 'parallel', 'independent', 'locked'],
        (now) => now.get(now.first('gripper'), 'jaws') || usual,
        (state, value) => edits.with_hand(state.text, value === usual ? '' : value)),
    ];
  }

  function of_object(state, toml) {
    const mass = toml.get(edits.object(toml), 'mass');
    const box = toml.get(edits.object(toml), 'box');
    const controls = [number_of('mass', 'kg', edits.object, 'mass', 0.001, round_up(4 * mass),
      0.001)];
    if (Array.isArray(box))
      for (const axis of [0, 1, 2])
        controls.push(in_mm(number(`size ${'xyz'[axis]}`, 'm', 0.002, round_up(3 * box[axis]), 0.001,
          (now) => now.get(edits.object(now), 'box')?.[axis],
          (current, value) => edits.with_edge(current, axis, value))));
    for (const [key, label] of [['cylinder_radius', 'radius'], ['cylinder_length', 'length']]) {
      const size = toml.get(edits.object(toml), key);
      if (size > 0)
        controls.push(in_mm(number(label, 'm', 0.001, round_up(3 * size), 0.001,
          (now) => now.get(edits.object(now), key),
          (current, value) => edits.with_cylinder(current, key, value))));
    }
    return controls;
  }

  /// A jaw presses with one force: unequal grips would be another hand's.
  function of_jaw(names, force) {
    return [number('grip', 'N', 0.1, round_up(3 * force), 0.1,
      (toml) => toml.get(toml.body(names[0]), 'grip_force'),
      (state, value) => names.reduce((text, name) =>
        edits.set(text, edits.named(name), 'grip_force', value), state.text))];
  }

  function of_body(toml, section, is_jaw) {
    const named = edits.named(toml.get(section, 'name'));
    if (section.name === 'actuator')
      return [number_of('force', 'N', named, 'force', 0,
        round_up(3 * toml.get(section, 'force') || 1), 0.1)];
    const controls = [];
    const force = toml.get(section, 'grip_force');
    if (force !== undefined && !is_jaw)
      controls.push(number_of('grip', 'N', named, 'grip_force', 0.1, round_up(3 * force), 0.1));
    controls.push(number_of('friction', '', named, 'friction', 0, 1.5, 0.01));
    if (section.name !== 'pusher') return controls;
    const key = toml.get(section, 'velocity') ? 'velocity' : 'acceleration';
    const push = toml.get(section, key) || [0, 0, 0];
    const plane = plane_of(push);
    const axis = 3 - plane[0] - plane[1];
    const turning = `angular_${key}`;
    const [metres, radians] = key === 'velocity' ? ['m/s', 'rad/s'] : ['m/s\u00b2', 'rad/s\u00b2'];
    const [size, direction] = vector_of('push', named, key, metres,
      round_up(3 * Math.max(length_in(plane, push), 0.1)), 0.001, plane);
    controls.push(key === 'velocity' ? in_mm(size) : size, direction);
    const rates = (now) => now.get(named(now), turning) || [0, 0, 0];
    controls.push(number(`turning ${'xyz'[axis]}`, radians, -20, 20, 0.1,
      (now) => rates(now)[axis],
      (state, value) => edits.set(state.text, named, turning,
        rates(new Toml(state.text)).map((x, k) => (k === axis ? value : x)))));
    return controls;
  }

  function round_up(x) {
    if (!(x > 0)) return 1;
    const power = 10 ** Math.floor(Math.log10(x));
    return Number(([1, 2, 5, 10].find((k) => k * power >= x) * power).toPrecision(1));
  }

  class Controls {
    /// `change(text, is_done)` is told of every change.
    constructor(change, region) {
      Object.assign(this, { change, region });
      this.shown = [];
      this.key = '';
    }

    /// The next scene gets controls of its own.
    forget() { this.key = ''; }

    update(state) {
      this.state = state;
      const toml = new Toml(state.text);
      const bodies = toml.sections.filter(({ name }) =>
        ['finger', 'actuator', 'pusher'].includes(name));
      const is_jaw = state.answer.hand === 'parallel';
      const fingers = bodies.filter(({ name }) => name === 'finger');
      const key = is_jaw + bodies.map((section) => `${section.name} ${toml.get(section, 'name')} ${
        toml.get(section, 'grip_force') === undefined}`).join();
      if (edits.object(toml) && key !== this.key) {
        this.key = key;
        this.shown = [];
        by_id('controls').replaceChildren(
          ...(is_jaw ? [this.group('jaw', of_jaw(fingers.map((one) => toml.get(one, 'name')),
            toml.get(fingers[0], 'grip_force')))] : []),
          ...bodies.map((section) =>
            this.group(toml.get(section, 'name'), of_body(toml, section, is_jaw))),
          this.group('object', of_object(state, toml)), this.group('scene', of_scene(toml)));
      }
      for (const show of this.shown) show(toml);
    }

    group(title, controls) {
      return h('fieldset', {}, h('legend', {}, title),
        controls.map((control) => (control.options ? this.choice(title, control)
          : this.slider(title, control))));
    }

    write(control, value, is_done) { this.change(control.write(this.state, value), is_done); }

    choice(title, control) {
      const select = h('select', { 'aria-label': `${title}: ${control.label}` },
        control.options.map((option) => h('option', {}, String(option))));
      select.addEventListener('change', () => this.write(control, select.value, true));
      this.shown.push((toml) => { select.value = String(control.read(toml)); });
      return h('label', { class: 'control' }, h('span', {}, control.label),
        h('span', { class: 'wide' }, select));
    }

    slider(title, control) {
      const { label, unit, least, most, step } = control;
      const name = `${title}: ${label}${unit && `, ${unit}`}`;
      const range = h('input', { type: 'range', min: least, max: most, step, 'aria-label': name });
      const box = h('input', { type: 'number', step: 'any', 'aria-label': `${name}, as a number` });
      const shades = h('span', { class: 'region', hidden: true });
      const key = h('span', { class: 'region-key', hidden: true });
      const row = h('div', { class: 'control' },
        h('span', {}, label, h('span', { class: 'quiet' }, unit && ` ${unit}`)), range, box, shades, key);
      let shown;
      const write = (value, is_done) => {
        shown = undefined; // what the scene makes of it is to be seen
        this.write(control, value, is_done);
      };
      range.addEventListener('input', () => write(Number(range.value), false));
      range.addEventListener('change', () => write(Number(range.value), true));
      range.addEventListener('focus', () =>
        this.region.show(shades, key, range, control, this.state));
      range.addEventListener('blur', () => this.region.leave());
      box.addEventListener('change', () => {
        if (box.value === '') box.value = shown ?? ''; // emptied, or no number of this world
        else write(Number(box.value), true);
      });
      this.shown.push((toml) => {
        const value = control.read(toml);
        row.hidden = !Number.isFinite(value);
        if (row.hidden || value === shown) return;
        shown = value;
        if (document.activeElement !== box || Number(box.value) !== value) box.value = value;
        range.min = Math.min(least, value);
        range.max = Math.max(most, value);
        range.value = value;
      });
      return row;
    }
  }

  play.Controls = Controls;
})();
