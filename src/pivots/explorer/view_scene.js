// The scene as the present basis has it. What no pivot changes the trace brings along: projections,
// outlines, pads, cones of a unit force, marks, the axes. Here they are placed, and forces, motions
// and labels drawn over them.
(() => {
  const { svg, parsed } = drawing.elements;
  const { picture, polygon, arrow, mark } = explorer.elements;
  const { add, scale, subtract, dot, length, cross } = drawing.vectors;
  const { decimal } = explorer.number_text;

  /// The largest of 1, 2, 5 times a power of ten that is not above x.
  function round_below(x) {
    const power = 10 ** Math.floor(Math.log10(x));
    return [5, 2, 1].find((k) => k * power <= x * (1 + 1e-12)) * power;
  }

  /// The smallest of a few round numbers that is not below x.
  function round_above(x) {
    const power = 10 ** Math.floor(Math.log10(x));
    return [1, 1.5, 2, 3, 5, 7, 10].find((k) => k * power >= x * (1 - 1e-9)) * power;
  }

  /// One view of one level: the finite one, or the part times S.
  class Painter {
    constructor(scene, view, level, common) {
      Object.assign(this, { scene, view, level, common });
      const [left, top, right, bottom] = view.frame;
      this.width = common.width;
      this.height = Math.round((bottom - top) * common.meters + 2 * 100);
      this.origin = [this.width / 2 - (left + right) / 2 * common.meters,
        this.height / 2 - (top + bottom) / 2 * common.meters];
      this.places = new explorer.Places(this.width, this.height);
      this.labels = []; // {words, at, away, target, kind}
    }

    flat(v) { return [dot(this.view.right, v), dot(this.view.down, v)]; }
    /// Of a flat place in metres.
    pixel(at) { return add(this.origin, scale(at, this.common.meters)); }
    place(position) { return this.pixel(this.flat(position)); }
    mark(name, at) { return mark(this.scene.marks[name], at); }

    outline() {
      const { outline, radius } = this.view;
      const corners = outline.map((corner) => this.pixel(corner));
      const [xs, ys] = [0, 1].map((k) => corners.map((p) => p[k]));
      this.places.block(Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys), 0.6);
      this.places.bar_edges(corners);
      if (radius === 0) return polygon('object', corners);
      const [cx, cy] = this.place(this.scene.center_of_mass);
      return svg('circle', { class: 'object', cx, cy, r: radius * this.common.meters });
    }

    pad({ body, behind, pad }) {
      if (pad.length === 0) return null;
      const corners = pad.map(([x, y, dx, dy]) => add(this.pixel([x, y]), [dx, dy]));
      this.places.bar_edges(corners);
      return polygon(`pad ${this.scene.bodies[body].role}${behind ? ' behind' : ''}`, corners);
    }

    /// Forces end at the contact, the cone opens where they come from.
    contact(i, { behind, cone }) {
      const { places, common: { newtons } } = this;
      const { normal, friction } = this.level.forces[i];
      const direction = this.scene.bodies[this.scene.points[i].body].normal;
      const tip = this.place(this.scene.points[i].drawn_at);
      const from = (force) => subtract(tip, scale(this.flat(force), newtons));
      const kind = (name) => `${name}${behind ? ' behind' : ''}`;
      const shapes = [];
      if (normal > 0 && cone.length > 0) {
        const corners = cone.map((corner) => add(tip, scale(corner, normal * newtons)));
        shapes.push(polygon(kind('cone'), corners));
        for (const corner of corners) places.block_line(tip, corner, 30);
      }
      if (length(this.flat(direction)) > 0.3) {
        const tail = from(scale(direction, normal));
        shapes.push(arrow(kind('force normal'), tail, tip));
        places.block_line(tail, tip, 60);
      } else if (normal > 0) {
        shapes.push(this.mark(behind ? 'out_of' : 'into', tip));
      }
      const tail = from(friction);
      shapes.push(arrow(kind('force friction'), tail, tip));
      places.block_line(tail, tip, 60);
      places.block(tip[0] - 10, tip[1] - 10, tip[0] + 10, tip[1] + 10, 2);
      return shapes;
    }

    /// An arrow of an acceleration, and where it ends.
    motion(kind, start, acceleration) {
      const tip = add(start, scale(this.flat(acceleration), this.common.accelerations));
      this.places.block_line(start, tip, 60);
      return [arrow(kind, start, tip), tip];
    }

    object_motion() {
      const { level, scene, common: { still, still_turn }, level: { times } } = this;
      const center = this.place(scene.center_of_mass);
      const linear = level.acceleration.slice(0, 3);
      const [shaft, tip] = this.motion('motion', center, linear);
      const shapes = [shaft];
      const spin = dot(this.view.toward, level.acceleration.slice(3));
      const words = ['object'];
      const plane = length(this.flat(linear));
      if (plane > still) words.push(`${decimal(plane, 3)}${times} m/s\u00b2`);
      if (Math.abs(spin) > still_turn) {
        words.push(`turns ${decimal(Math.abs(spin), 3)}${times} rad/s\u00b2`);
        shapes.push(this.mark(spin < 0 ? 'clockwise' : 'counterclockwise', center),
          this.turning_center(linear, spin));
      }
      if (length(level.acceleration) <= still) words.push('stays');
      const at = plane > still ? tip : center;
      if (words.length > 1) this.labels.push({ words, at, target: at, kind: 'object-label' });
      return [...shapes, svg('circle', { class: 'center', cx: center[0], cy: center[1], r: 3 })];
    }

    turning_center(linear, spin) {
      const offset = scale(cross(this.view.toward, linear), 1 / spin);
      const [x, y] = this.place(add(this.scene.center_of_mass, offset));
      if (x < 8 || y < 8 || x > this.width - 8 || y > this.height - 8) return null;
      this.places.block(x - 6, y - 6, x + 6, y + 6, 3);
      return this.mark('turning_center', [x, y]);
    }

    body_motion(body, b) {
      const { scene, level, common: { tiny, still }, level: { times } } = this;
      const of_body = [...scene.points.keys()].filter((i) => scene.points[i].body === b);
      if (of_body.length === 0) return null;
      const middle_of = (where) => scale(of_body.map((i) => scene.points[i][where]).reduce(add),
        1 / of_body.length);
      const flat = this.flat(body.normal);
      const start = this.place(middle_of('drawn_at'));
      for (const i of of_body) {
        const [x, y] = this.place(scene.points[i].drawn_at);
        this.places.block(x - 12, y - 12, x + 12, y + 12, 1.5);
      }
      const moved = explorer.mechanics.at_point(level.bodies[b],
        subtract(middle_of('position'), scene.center_of_mass));
      const [shaft] = this.motion('motion thin', subtract(start, scale(flat, 22)), moved);
      const normal = of_body.reduce((total, i) => total + level.forces[i].normal, 0);
      const friction = length(of_body.map((i) => level.forces[i].friction).reduce(add));
      // On a narrow screen the words of motions are left to the list below.
      const narrow = this.width < 400;
      const words = [body.name];
      if (Math.abs(normal) > tiny)
        words.push(`${narrow ? '' : 'normal '}${decimal(normal, 3)}${times} N`);
      if (friction > tiny)
        words.push(`friction ${decimal(friction, 3)}${narrow ? '' : `${times} N`}`);
      if (words.length === 1) words.push('no force');
      if (!narrow && length(this.flat(moved)) > still)
        words.push(`moves ${decimal(length(moved), 3)}${times} m/s\u00b2`);
      this.labels.push({ words, at: subtract(start, scale(flat, 46)), away: scale(flat, -1),
        target: start, kind: body.role });
      return shaft;
    }

    label({ words, target, kind }, box) {
      // Words that are narrower than their place stand where the leader comes from.
      const is_left_of = target[0] > box.left + box.width;
      const x = is_left_of ? box.left + box.width - 2 : box.left + 2;
      return [
        length(subtract(box.leader, target)) > 14 && [
          svg('circle', { class: 'leader-end', cx: target[0], cy: target[1], r: 1.8 }),
          svg('line', { class: 'leader', x1: target[0], y1: target[1], x2: box.leader[0],
            y2: box.leader[1] })],
        svg('text', { class: `label ${kind}`, 'text-anchor': is_left_of && 'end' },
          words.map((text, k) => svg('tspan', { x, y: box.top + (k + 0.8) * box.line,
            class: k === 0 && 'strong' }, text))),
      ];
    }

    force_scale() {
      const { newtons, empty } = this.common;
      const unit = round_below(this.scene.longest_force / newtons);
      const size = unit * newtons;
      if (!Number.isFinite(size) || empty) return null;
      const x = this.width - 10;
      return [
        svg('path', { class: 'scale', d: `M${x - size} ${this.height - 12}v6h${size}v-6` }),
        svg('text', { class: 'quiet', x: x - size - 6, y: this.height - 5, 'text-anchor': 'end' },
          `${decimal(unit, 3)}${this.level.times} N`)];
    }

    draw(modes) {
      const { scene, view, width, height, places } = this;
      const outline = this.outline();
      const pads = view.bodies.map((seen) => this.pad(seen));
      places.bar(0, 0, 56, 50);
      places.bar(width - 130, height - 24, width, height);
      const points = view.bodies.flatMap((seen) => [...scene.points.keys()]
        .filter((i) => scene.points[i].body === seen.body).map((i) => [i, seen]));
      const contacts = points.map(([i, seen]) => this.contact(i, seen));
      const marks = points.map(([i]) =>
        this.mark(modes[i], this.place(scene.points[i].drawn_at)));
      const motions = [this.object_motion(),
        scene.bodies.map((body, b) => this.body_motion(body, b))];
      // The longest while there is room.
      this.labels.sort((a, b) => b.words.length - a.words.length);
      const boxes = this.labels.map(({ words, at, away = [0, 0], target }) =>
        places.place(words, at, away, target));
      return picture({ viewBox: `0 0 ${width} ${height}`, class: 'drawing view', width },
        `${view.title}${this.level.times ? ', times S' : ''}`,
        'The object, its contacts, forces and motions; the list below says the same in words.',
        parsed(svg('g'), view.axes), outline, pads, contacts, marks, motions, this.labels.map((label, k) => this.label(label, boxes[k])),
        this.force_scale());
    }
  }

  /// Scales that all views share. Force arrows have round scales, so that they jump seldom.
  function common_scales(scene, level, width) {
    const meters = Math.min(...scene.views.map(({ frame: [left, top, right, bottom] }) =>
      Math.min((width - 200) / (right - left || 1e-6), 190 / (bottom - top || 1e-6))));
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
      newtons: most_force > 0 ? scene.longest_force / round_above(most_force) : 1,
      accelerations: most_speed > 0 ? scene.fastest / most_speed : 0,
      still: 1e-3 * largest, still_turn: 1e-3 * largest / reach };
  }

  /// A figure for each view.
  function figures(scene, modes, level, width) {
    const common = common_scales(scene, level, width);
    return scene.views.map((view) => ({ title: view.title,
      svg: new Painter(scene, view, level, common).draw(modes) }));
  }

  explorer.view_scene = { figures };
})();
