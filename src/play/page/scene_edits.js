// What a hand or a slider changes, as changes of the scene's text.
(() => {
  const { Toml } = play;
  const { add, subtract, scale, dot } = drawing.vectors;

  /// Where a body's points stand in the file, as far as it has them.
  const place_keys = ['center', 'ends', 'points'];
  const is_place = (value) => Array.isArray(value) && value.length > 0
    && (value.length === 3 && value.every(Number.isFinite)
      || value.every((row) => Array.isArray(row) && row.length === 3));
  const each_place = (value, change) => (Array.isArray(value[0])
    ? value.map(change) : change(value));
  const finer = (x) => Math.round(x * 1e7) / 1e7; // a tenth of a micrometre

  function changed_places(text, name, change) {
    let result = text;
    for (const key of place_keys) {
      const toml = new Toml(result);
      const section = toml.body(name);
      const value = section && toml.get(section, key);
      if (!is_place(value)) continue;
      result = toml.with_value(section, key,
        each_place(value, (at) => change(at).map((x, k) => (x === at[k] ? x : finer(x)))));
    }
    return result;
  }

  /// The body's points by `by` further; on a face of the object, along that.
  function moved_body(text, name, by) {
    const toml = new Toml(text);
    const section = toml.body(name);
    const across = 'xyz'.indexOf((section && toml.get(section, 'on') || '+?')[1]);
    if (across < 0) return changed_places(text, name, (at) => add(at, by));
    const along = by.filter((_, k) => k !== across);
    return toml.with_value(section, 'center',
      (toml.get(section, 'center') || [0, 0]).map((x, i) => finer(x + along[i])));
  }

  /// The fingers that a hand drags together: jaws go with each other.
  function dragged_together(state, name, alone) {
    const body = state.scene.bodies.find((one) => one.name === name);
    const is_jaw = ['parallel', 'locked'].includes(state.answer.hand);
    if (alone || body.role !== 'finger' || !is_jaw) return [name];
    return state.scene.bodies.filter(({ role }) => role === 'finger').map((one) => one.name);
  }

  /// `names` moved by `by`, each along its own face alone.
  function dragged(state, names, by) {
    return names.reduce((text, name) => {
      const { normal } = state.scene.bodies.find((body) => body.name === name);
      return moved_body(text, name, subtract(by, scale(normal, dot(by, normal))));
    }, state.text);
  }

  const set = (text, section, key, value) =>
    new Toml(text).with_value(section(new Toml(text)), key, value);
  const top = (toml) => toml.sections[0];
  const object = (toml) => toml.first('object');
  const named = (name) => (toml) => toml.body(name);

  /// The object's size, `factor` times as large along `axes`; what touches its ends there stays on
  /// them.
  function resized({ text, scene }, key, value, axes, factor) {
    const center = scene.center_of_mass;
    return scene.bodies.reduce((changed, { name }) =>
      changed_places(changed, name, (at) => at.map((x, k) =>
        (axes.includes(k) ? center[k] + (x - center[k]) * factor : x))),
    set(text, object, key, value));
  }

  const of_object = ({ text }, key) => {
    const toml = new Toml(text);
    return toml.get(object(toml), key);
  };

  /// An edge of the box.
  function with_edge(state, axis, size) {
    const box = of_object(state, 'box');
    return resized(state, 'box', box.map((x, k) => (k === axis ? size : x)), [axis],
      size / box[axis]);
  }

  /// The cylinder's length along its axis, or its radius across.
  function with_cylinder(state, key, size) {
    const axes = [0, 1, 2].filter((k) =>
      (k === state.scene.shape.axis) === (key === 'cylinder_length'));
    return resized(state, key, size, axes, size / of_object(state, key));
  }

  function with_hand(text, hand) {
    const toml = new Toml(text);
    const gripper = toml.first('gripper');
    if (gripper) return hand ? toml.with_value(gripper, 'jaws', hand) : toml.without(gripper, 'jaws');
    if (!hand) return text;
    const before = toml.sections.find(({ name }) => name === 'finger' || name === 'pusher');
    const at = before ? before.header : text.length;
    return `${text.slice(0, at)}[gripper]\njaws = "${hand}"\n\n${text.slice(at)}`;
  }

  play.edits = { set, top, object, named, dragged, dragged_together, with_edge, with_cylinder,
    with_hand };
})();
