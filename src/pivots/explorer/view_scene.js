// The scene as the present basis has it: the object, contacts, cones, forces and motions.
(() => {
  const { svg, picture: drawing } = explorer.elements;
  const { add, scale, subtract, dot, length, cross } = explorer.vectors;
  const { hull, round_above, round_below, axis_names } = explorer.projection;
  const { decimal } = explorer.number_text;
  const longest = 72; // pixels of the longest force
  const fastest = 46; // pixels of the largest acceleration
  const modes = { stick: 'sticks', slide: 'slides', separate: 'opens', touch: 'touches',
    sink: 'sinks in' };

  const polygon = (points, attributes) => svg('polygon',
    { points: points.map((p) => p.map((x) => x.toFixed(1)).join()).join(' '), ...attributes });

  /// An arrow with its own head, so that colour is not needed to see its end.
  function arrow([x0, y0], [x1, y1], kind) {
    const size = Math.hypot(x1 - x0, y1 - y0);
    if (size < 2.5) return null;
    const [dx, dy] = [(x1 - x0) / size, (y1 - y0) / size];
    const head = Math.min(9, size * 0.6);
    const back = [x1 - dx * head, y1 - dy * head];
    const wing = (s) => [back[0] - dy * s * head * 0.42, back[1] + dx * s * head * 0.42];
    return svg('g', { class: kind },
      svg('line', { x1: x0, y1: y0, x2: back[0], y2: back[1] }),
      polygon([[x1, y1], wing(1), wing(-1)], { class: 'head' }));
  }

  /// The mark of a contact: square sticks, triangle slides, ring opens, small ring only touches,
  /// cross sinks in.
  function mark(mode, [x, y], behind) {
    const kind = `mark ${mode}${behind ? ' behind' : ''}`;
    if (mode === 'stick')
      return svg('rect', { class: kind, x: x - 3.6, y: y - 3.6, width: 7.2, height: 7.2 });
    if (mode === 'slide') return polygon([[x, y - 4.8], [x + 4.6, y + 3.6], [x - 4.6, y + 3.6]],
      { class: kind });
    if (mode === 'sink')
      return svg('path', { class: kind, d: `M${x - 3.6} ${y - 3.6}l7.2 7.2m0 -7.2l-7.2 7.2` });
    return svg('circle', { class: kind, cx: x, cy: y, r: mode === 'separate' ? 4.4 : 2.4 });
  }

  function extent(scene, view) {
    const points = [...corners(scene), ...scene.points.map(({ position }) => position)];
    const flat = points.map(view.flat);
    const range = (k) => [Math.min(...flat.map((p) => p[k])), Math.max(...flat.map((p) => p[k]))];
    return [range(0), range(1)];
  }

  function corners(scene) {
    const half = scale(scene.shape.size, 0.5);
    return [0, 1, 2, 3, 4, 5, 6, 7].map((k) => add(scene.center_of_mass,
      half.map((x, axis) => (k >> axis & 1 ? x : -x))));
  }

  function outline(scene, view, place) {
    const { kind, axis, size } = scene.shape;
    const center = place(scene.center_of_mass);
    if (kind === 'cylinder' && axis === view.depth) {
      const pixels = place.pixels;
      return svg('ellipse', { class: 'object', cx: center[0], cy: center[1],
        rx: size[view.right.axis] * pixels / 2, ry: size[view.down.axis] * pixels / 2 });
    }
    return polygon(hull(corners(scene).map(place)), { class: 'object' });
  }

  /// The pad of a body: a strip behind its points, or a patch where it faces the viewer.
  function pad(scene, view, place, index) {
    const body = scene.bodies[index];
    const points = scene.points.filter((point) => point.body === index)
      .map(({ position }) => place(position));
    if (points.length === 0) return null;
    const flat = view.flat(body.normal);
    const seen = Math.hypot(...flat);
    const behind = view.toward_viewer(body.normal) > 0.5;
    const around = [];
    for (const [x, y] of points) {
      if (seen > 0.7) {
        const [nx, ny] = flat.map((v) => v / seen);
        for (const side of [-6, 6])
          for (const back of [0, 9])
            around.push([x - ny * side - nx * back, y + nx * side - ny * back]);
      } else {
        for (let k = 0; k < 12; ++k) around.push([x + 9 * Math.cos(k * Math.PI / 6),
          y + 9 * Math.sin(k * Math.PI / 6)]);
      }
    }
    return polygon(hull(around), { class: `pad ${body.role}${behind ? ' behind' : ''}` });
  }

  /// Forces and cone of one point. Forces end at the contact, the cone opens where they come from.
  function contact(scene, view, place, i, force, pixels, places) {
    const point = scene.points[i];
    const body = scene.bodies[point.body];
    const tip = place(point.position);
    const behind = view.toward_viewer(body.normal) > 0.5;
    const from = (v) => { const f = view.flat(v); return [tip[0] - f[0] * pixels,
      tip[1] - f[1] * pixels]; };
    const normal = scale(body.normal, force.normal);
    const shapes = [];
    if (force.normal > 0 && point.generators.length > 0) {
      const rim = point.generators.map(({ force: direction }) =>
        from(add(normal, scale(direction, body.friction * force.normal))));
      shapes.push(polygon(hull([tip, ...rim]), { class: `cone${behind ? ' behind' : ''}` }));
      for (const corner of rim) places.block_line(tip, corner, 0.8);
    }
    const flat = Math.hypot(...view.flat(body.normal));
    if (flat > 0.3) {
      const tail = from(normal);
      shapes.push(arrow(tail, tip, `force normal${behind ? ' behind' : ''}`));
      places.block_line(tail, tip, 2);
    } else if (force.normal > 0) {
      const [x, y] = tip;
      shapes.push(svg('g', { class: `force normal${behind ? ' behind' : ''}` },
        svg('circle', { class: 'ring', cx: x, cy: y, r: behind ? 10 : 7.5 }),
        behind ? null : svg('path', { d: `M${x - 5} ${y - 5}l10 10m0 -10l-10 10` })));
    }
    const tail = from(force.friction);
    shapes.push(arrow(tail, tip, `force friction${behind ? ' behind' : ''}`));
    places.block_line(tail, tip, 2);
    places.block(tip[0] - 10, tip[1] - 10, tip[0] + 10, tip[1] + 10, 2);
    return shapes;
  }

  function turning(view, [x, y], about, radius) {
    const sense = view.toward_viewer([0, 1, 2].map((k) => (k === view.depth ? about : 0)));
    const along = sense < 0 ? 1 : -1; // clockwise: at the top it moves to the right
    // Three quarters of a circle that end at the top, where the head lies along it.
    const tip = [x, y - radius];
    const path = `M${x + along * radius} ${y}A${radius} ${radius} 0 1 ${along > 0 ? 1 : 0} ${tip}`;
    return svg('g', { class: 'motion object-motion' }, svg('path', { d: path, class: 'arc' }),
      polygon([[tip[0] + along * 8, tip[1]], [tip[0] - along * 2, tip[1] - 4.5],
        [tip[0] - along * 2, tip[1] + 4.5]], { class: 'head' }));
  }

  function text_lines(lines, box, kind) {
    return svg('text', { class: `label ${kind || ''}`, x: box.left + 2, y: box.top },
      lines.map((text, k) => svg('tspan', { x: box.left + 2, y: box.top + (k + 0.8) * box.line,
        class: k === 0 ? 'first' : null }, text)));
  }

  /// One view of one level (`large`: the part times S).
  function draw(scene, view, shown, large, common) {
    const [[x0, x1], [y0, y1]] = extent(scene, view);
    const margin = 88;
    const { meters, width } = common;
    const height = Math.round((y1 - y0) * meters + 2 * margin);
    const middle = [(x0 + x1) / 2, (y0 + y1) / 2];
    const place = (p) => { const f = view.flat(p); return [width / 2 + (f[0] - middle[0]) * meters,
      height / 2 + (f[1] - middle[1]) * meters]; };
    place.pixels = meters;
    const places = new explorer.Places(width, height);
    const level = large ? shown.large : shown.finite;
    const times = large ? ' S' : '';
    const center = place(scene.center_of_mass);
    const front_first = [...scene.bodies.keys()].sort((a, b) =>
      view.toward_viewer(scene.bodies[b].normal) - view.toward_viewer(scene.bodies[a].normal));
    const order = [...scene.points.keys()].sort((a, b) =>
      front_first.indexOf(scene.points[a].body) - front_first.indexOf(scene.points[b].body));
    const box = hull(corners(scene).map(place));
    places.block(Math.min(...box.map((p) => p[0])), Math.min(...box.map((p) => p[1])),
      Math.max(...box.map((p) => p[0])), Math.max(...box.map((p) => p[1])), 0.6);
    places.block(0, 0, 56, 50, 30);
    places.block(width - 130, height - 24, width, height, 30);
    const contacts = order.map((i) => contact(scene, view, place, i, level.forces[i],
      common.newtons, places));
    const marks = order.map((i) => mark(shown.modes[i], place(scene.points[i].position),
      view.toward_viewer(scene.bodies[scene.points[i].body].normal) > 0.5));
    const motions = [];
    const labels = [];
    const speed = (v) => { const f = view.flat(v); return [f[0] * common.accelerations,
      f[1] * common.accelerations]; };

    // The object's own motion.
    const linear = speed(level.acceleration);
    const tip = [center[0] + linear[0], center[1] + linear[1]];
    motions.push(arrow(center, tip, 'motion object-motion'));
    places.block_line(center, tip, 3);
    const spin = level.acceleration[3 + view.depth];
    const lines = [];
    const plane = Math.hypot(...view.flat(level.acceleration));
    if (plane > common.still) lines.push(`${decimal(plane, 3)}${times} m/s\u00b2`);
    if (Math.abs(spin) > common.still_turn) {
      motions.push(turning(view, center, spin, 19));
      lines.push(`turns ${decimal(Math.abs(spin), 3)}${times} rad/s\u00b2`);
      motions.push(turning_centre(scene, view, place, level, spin, [width, height], places));
    }
    motions.push(svg('circle', { class: 'center', cx: center[0], cy: center[1], r: 3 }));
    if (length(level.acceleration) <= common.still) lines.push('stays');
    const anchors = lines.length === 0 ? []
      : [[['object', ...lines], plane > common.still ? tip : center, 'object-label']];

    scene.bodies.forEach((body, b) => {
      const of_body = [...scene.points.keys()].filter((i) => scene.points[i].body === b);
      if (of_body.length === 0) return;
      const sum = of_body.map((i) => scene.points[i].position).reduce(add);
      const at = scale(sum, 1 / of_body.length);
      const flat = view.flat(body.normal);
      const start = place(at);
      for (const i of of_body) {
        const [x, y] = place(scene.points[i].position);
        places.block(x - 12, y - 12, x + 12, y + 12, 1.5);
      }
      const out = [start[0] - flat[0] * 22, start[1] - flat[1] * 22];
      const arm = subtract(at, scene.center_of_mass);
      const moved = explorer.mechanics.at_point(level.bodies[b], arm);
      const shift = speed(moved);
      motions.push(arrow(out, [out[0] + shift[0], out[1] + shift[1]], 'motion body-motion'));
      places.block_line(out, [out[0] + shift[0], out[1] + shift[1]], 3);
      const normal = of_body.reduce((sum, i) => sum + level.forces[i].normal, 0);
      const friction = length(of_body.map((i) => level.forces[i].friction).reduce(add));
      // On a narrow screen the words of motions are left to the list below.
      const narrow = width < 400;
      const words = [body.name];
      if (Math.abs(normal) > common.tiny)
        words.push(`${narrow ? '' : 'normal '}${decimal(normal, 3)}${times} N`);
      if (friction > common.tiny)
        words.push(`friction ${decimal(friction, 3)}${narrow ? '' : `${times} N`}`);
      if (words.length === 1) words.push('no force');
      if (!narrow && Math.hypot(...view.flat(moved)) > common.still)
        words.push(`moves ${decimal(length(moved), 3)}${times} m/s\u00b2`);
      anchors.push([words, [start[0] - flat[0] * 46, start[1] - flat[1] * 46], body.role, start,
        flat.map((v) => -v)]);
    });
    for (const [words, at, kind, start, away] of anchors) {
      const box_of = places.place(words, ...at, away);
      const near = [Math.max(box_of.left, Math.min(at[0], box_of.left + box_of.width)),
        Math.max(box_of.top, Math.min(at[1], box_of.top + box_of.height))];
      const target = start || at;
      if (Math.hypot(near[0] - target[0], near[1] - target[1]) > 26)
        labels.push(svg('line', { class: 'leader', x1: near[0], y1: near[1], x2: target[0],
          y2: target[1] }));
      labels.push(text_lines(words, box_of, kind));
    }
    return drawing({ viewBox: `0 0 ${width} ${height}`, class: 'view', width },
      `${view.title}${large ? ', times S' : ''}`,
      'The object, its contacts, forces and motions; the list below says the same in words.',
      axes(view), outline(scene, view, place),
      front_first.map((b) => pad(scene, view, place, b)),
      contacts, marks, motions, labels, force_scale(common, height, times));
  }

  function turning_centre(scene, view, place, level, spin, [width, height], places) {
    const axis = [0, 1, 2].map((k) => (k === view.depth ? spin : 0));
    const offset = scale(cross(axis, level.acceleration.slice(0, 3)), 1 / dot(axis, axis));
    const [x, y] = place(add(scene.center_of_mass, offset));
    if (x < 8 || y < 8 || x > width - 8 || y > height - 8) return null;
    places.block(x - 6, y - 6, x + 6, y + 6, 3);
    return svg('g', { class: 'turning-centre' },
      svg('circle', { cx: x, cy: y, r: 5 }),
      svg('path', { d: `M${x - 8} ${y}h16M${x} ${y - 8}v16` }));
  }

  function axes(view) {
    const o = [16, view.down.sign > 0 ? 12 : 40];
    const down = view.down.sign > 0 ? 24 : -24;
    const across = view.right.sign > 0 ? 24 : -24;
    const origin = [across < 0 ? 42 : o[0], o[1]];
    return svg('g', { class: 'axes' },
      arrow(origin, [origin[0] + across, origin[1]], 'axis'),
      arrow(origin, [origin[0], origin[1] + down], 'axis'),
      svg('text', { x: origin[0] + across * 1.35, y: origin[1] + 4, 'text-anchor': 'middle' },
        axis_names[view.right.axis]),
      svg('text', { x: origin[0] + 10, y: origin[1] + down + (down > 0 ? 4 : 6) },
        axis_names[view.down.axis]));
  }

  function force_scale(common, height, times) {
    const unit = round_below(longest / common.newtons);
    const size = unit * common.newtons;
    if (!Number.isFinite(size) || common.empty) return null;
    const x = common.width - 10;
    return svg('g', { class: 'scale' },
      svg('path', { d: `M${x - size} ${height - 12}v6h${size}v-6` }),
      svg('text', { x: x - size - 6, y: height - 5, 'text-anchor': 'end' },
        `${decimal(unit, 3)}${times} N`));
  }

  /// Scales that all views share. Force arrows have round scales, so that they jump seldom.
  function common_scales(scene, views, level, width) {
    const spans = views.map((view) => extent(scene, view).map(([a, b]) => b - a || 1e-6));
    const meters = Math.min(...spans.map(([across, down]) =>
      Math.min((width - 200) / across, 190 / down)));
    const most_force = Math.max(...level.forces.flatMap((f) => [Math.abs(f.normal),
      length(f.friction)]), 0);
    const arms = scene.points.map(({ position }) => subtract(position, scene.center_of_mass));
    const speeds = scene.points.map((point, i) =>
      length(explorer.mechanics.at_point(level.bodies[point.body], arms[i])));
    const most_speed = Math.max(length(level.acceleration.slice(0, 3)), ...speeds, 0);
    const reach = Math.max(...arms.map(length), 1e-9);
    const turn = length(level.acceleration.slice(3)) * reach;
    const largest = Math.max(most_speed, turn, 1e-12);
    return { meters, width, empty: most_force === 0, tiny: 1e-9 * Math.max(most_force, 1e-9),
      newtons: most_force > 0 ? longest / round_above(most_force) : 1,
      accelerations: most_speed > 0 ? fastest / most_speed : 0,
      still: 1e-9 * largest, still_turn: 1e-9 * largest / reach };
  }

  function create(scene) {
    const views = explorer.projection.views(scene);
    return (shown, large, width) => {
      const common = common_scales(scene, views, large ? shown.large : shown.finite, width);
      return views.map((view) => ({ title: view.title,
        svg: draw(scene, view, shown, large, common) }));
    };
  }

  explorer.view_scene = { create, modes };
})();
