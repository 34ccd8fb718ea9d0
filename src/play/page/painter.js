// The picture of a state: object, bodies, forces with their cones, modes, and the motion's ghost.
(() => {
  const { svg } = drawing.elements;
  const { decimal } = drawing.numbers;
  const { polygon, arrow, mark } = drawing.shapes;
  const { add, subtract, scale, dot, cross, length, unit, turned, hull } = drawing.vectors;
  const { figures } = play;

  const [width, height, margin] = [720, 480, 92];
  const longest = 78; // pixels, of the largest force
  const swing = 0.11; // of the grasp's reach, how far the ghost's fastest point goes

  class Painter {
    /// `meters`: pixels a metre. `pose` {position, rotation(v)} of the object, `body_shift` of b.
    constructor(state, view, frame) {
      Object.assign(this, { state, view, scene: state.scene });
      const reach = figures.reach(this.scene);
      this.reach = reach;
      this.meters = state.meters || this.fitted();
      this.pose = frame?.pose || { position: [0, 0, 0], turned: (v) => v };
      this.bodies_at = frame?.bodies || null;
      this.answer = frame ? null : state.answer;
      this.center = this.scene.center_of_mass;
      const forces = (state.answer.contacts || []).flatMap((c) =>
        [Math.abs(c.normal_force), length(c.friction_force)]);
      this.newtons = longest / (frame?.most_force || Math.max(...forces, 1e-9));
    }

    /// Pixels a metre at which all fits, however it is turned.
    fitted() {
      const { scene, view } = this;
      const flat = scene.points.map(({ drawn_at }) => view.flat(subtract(drawn_at,
        scene.center_of_mass)));
      for (const { corners } of figures.object_faces(scene))
        flat.push(...corners.map((corner) => view.flat(corner)));
      const most = (k) => Math.max(...flat.map((p) => Math.abs(p[k])), 0.2 * this.reach);
      return Math.min((width / 2 - margin) / most(0), (height / 2 - margin) / most(1));
    }

    place(position) {
      const [x, y] = this.view.flat(subtract(position, this.center));
      return [width / 2 + x * this.meters, height / 2 + y * this.meters];
    }
    /// A place on the object, from its centre of mass, where the object is now.
    of_object(arm) { return this.place(add(add(this.center, this.pose.position),
      this.pose.turned(arm))); }

    object() {
      const { view, scene } = this;
      if (!figures.has_shape(scene)) return null;
      const faces = figures.object_faces(scene);
      const outline = hull(faces.flatMap(({ corners }) => corners.map((c) => this.of_object(c))));
      const seen = faces.filter(({ normal }) =>
        figures.faces_viewer(view, this.pose.turned(normal)));
      return [polygon('object', outline), seen.map(({ corners }) =>
        polygon('face', corners.map((c) => this.of_object(c))))];
    }

    ghost() {
      const acceleration = this.answer?.object?.acceleration;
      if (!acceleration || !figures.has_shape(this.scene)) return null;
      const [linear, angular] = [acceleration.slice(0, 3), acceleration.slice(3)];
      const corners = figures.object_faces(this.scene).map((face) => face.corners);
      const speed = Math.max(...corners.flat().map((c) => length(add(linear, cross(angular, c)))));
      if (!(speed > 1e-6)) return null;
      const s = swing * this.reach / speed;
      const moved = (c) => this.place(add(add(this.center, scale(linear, s)),
        turned(c, scale(angular, s))));
      return polygon('ghost', hull(corners.flat().map(moved)));
    }

    plate_of(name) {
      const { scene } = this;
      const thick = 0.07 * this.reach;
      const corners = scene.bodies.flatMap((body, b) =>
        (body.name === name ? figures.plate(scene, b, thick) : []));
      const at = this.bodies_at?.get(name);
      return at ? corners.map((c) => add(add(this.center, at.position),
        at.turned(subtract(c, this.center)))) : corners;
    }

    body(name) {
      const { scene, view } = this;
      const first = scene.bodies.find((body) => body.name === name);
      const corners = this.plate_of(name);
      const behind = dot(view.toward, first.normal) > 0.3;
      const tip = this.place(figures.middle(corners));
      const away = view.flat(scale(first.normal, -1));
      const force = this.bodies_at?.get(name)
        || (this.state.answer.bodies || []).find((body) => body.name === name);
      const words = force?.normal_force !== undefined ? `${name}  ${decimal(force.normal_force)} N` : name;
      const sideways = length(away) > 0.3 ? unit(away) : [behind ? -0.5 : 0.5, behind ? 1 : -1];
      const [x, y] = this.kept_inside(words, sideways,
        add(tip, scale(sideways, length(away) > 0.3 ? 58 : 76)));
      const [top, bottom] = this.object_span();
      const clear = Math.abs(y - top) < 16 ? top - 10 : Math.abs(y - bottom) < 16 ? bottom + 16 : y;
      const squeezes = this.answer?.jam?.bodies.some((one) => one.name === name);
      return { name, behind, thing: svg('g', { class: 'body', tabindex: 0, role: 'button',
        'data-body': name, 'aria-label': `${name}, ${first.role}: arrow keys move it` },
      polygon(`thing ${first.role}${behind ? ' behind' : ''}${squeezes ? ' squeezes' : ''}`,
        hull(corners.map((c) => this.place(c)))), this.answer && this.push_of(first, tip)),
      label: svg('text', { class: `label ${first.role}`, x, y: clear + 4,
        'text-anchor': sideways[0] < -0.3 ? 'end' : sideways[0] > 0.3 ? 'start' : 'middle' },
      words) };
    }

    /// Beside a pusher, which way it moves; not where that is out of the picture.
    push_of({ role, acceleration }, [x, y]) {
      const flat = this.view.flat(unit(acceleration.slice(0, 3)));
      if (role !== 'pusher' || length(flat) < 0.3) return null;
      const [dx, dy] = unit(flat);
      const beside = [x - 16 * dy - 18 * dx, y + 16 * dx - 18 * dy];
      return arrow('motion thin', beside, add(beside, scale(flat, 36)));
    }

    /// Where the object begins and ends, up and down the picture.
    object_span() {
      if (!figures.has_shape(this.scene)) return [-99, -99];
      const heights = figures.object_faces(this.scene).flatMap(({ corners }) =>
        corners.map((c) => this.of_object(c)[1]));
      return [Math.min(...heights), Math.max(...heights)];
    }

    /// Words that would run over the picture's edge stand further in, above their body.
    kept_inside(words, sideways, [x, y]) {
      const size = words.length * (window.innerWidth < 900 ? 12.5 : 7.5);
      const left = sideways[0] < -0.3 ? x - size : sideways[0] > 0.3 ? x : x - size / 2;
      const by = Math.max(6 - left, 0) - Math.max(left + size - (width - 6), 0);
      return [x + by, by === 0 ? y : y - 34];
    }

    /// Forces end at their contact; the cone opens to where they come from.
    contact(contact, i) {
      const { scene, view, newtons } = this;
      const point = scene.points[i];
      const body = scene.bodies[point.body];
      const tip = this.place(point.drawn_at);
      const from = (force) => subtract(tip, scale(view.flat(force), newtons));
      const normal = scale(body.normal, contact.normal_force);
      const toward = dot(view.toward, body.normal);
      const kind = toward > 0.3 ? ' behind' : toward < -0.3 ? ' facing' : '';
      const cone = contact.normal_force > 0 && body.friction > 0
        ? hull([tip, ...point.generators.map(({ force }) =>
          from(add(normal, scale(force, body.friction * contact.normal_force))))]) : [];
      return [cone.length > 2 && polygon(`cone${kind}`, cone),
        arrow(`force normal${kind}`, from(normal), tip),
        arrow(`force friction${kind}`, from(contact.friction_force), tip),
        mark(scene.marks[contact.mode] || '', tip)];
    }

    /// While the push is played: what each body does to the object.
    body_forces() {
      return [...this.bodies_at?.values() || []].flatMap(({ middle, forces }) => {
        const tip = this.place(middle);
        return forces.map((force, k) => {
          const shaft = scale(this.view.flat(force), this.newtons);
          const shown = scale(shaft, Math.min(1, 2 * longest / length(shaft)));
          return length(shaft) > 0 && arrow(`force ${['normal', 'friction'][k]}`,
            subtract(tip, shown), tip);
        });
      });
    }

    axes() {
      const origin = [44, height - 40];
      return ['x', 'y', 'z'].map((name, k) => {
        const flat = this.view.flat([0, 1, 2].map((i) => (i === k ? 1 : 0)));
        if (length(flat) < 0.15) return null;
        return svg('g', { class: 'axis' }, arrow('axis', origin, add(origin, scale(flat, 26))),
          svg('text', { class: 'quiet', x: origin[0] + 36 * flat[0], y: origin[1] + 36 * flat[1] + 4,
            'text-anchor': 'middle' }, name));
      });
    }

    trace(path) {
      if (!path || path.length < 2) return null;
      return svg('polyline', { class: 'trace', points: path.map((at) =>
        this.place(add(this.center, at)).map((x) => x.toFixed(1)).join()).join(' ') });
    }

    /// What would happen with the body in other places of its face.
    dots() {
      return (this.answer ? this.state.dots || [] : []).map(({ at, kind }) => {
        const [cx, cy] = this.place(at);
        return svg('g', { class: `dot ${kind}` }, svg('circle', { cx, cy, r: 4.5 }),
          kind === 'jams' && svg('path', { d: `M${cx - 3} ${cy - 3}l6 6m0 -6l-6 6` }),
          svg('title', {}, play.kinds[kind] || 'no scene'));
      });
    }

    draw(path) {
      const { scene, state } = this;
      const bodies = figures.names(scene).map((name) => this.body(name));
      const contacts = this.answer ? (this.answer.contacts || []) : [];
      return svg('svg', { class: 'drawing', viewBox: `0 0 ${width} ${height}`, role: 'group',
        'aria-label': `The grasp: ${state.sentence}`, tabindex: 0 },
      this.axes(), bodies.filter((b) => b.behind).map((b) => b.thing), this.object(), this.ghost(),
      bodies.filter((b) => !b.behind).map((b) => b.thing), this.trace(path), this.dots(),
      contacts.map((contact, i) => this.contact(contact, i)), this.body_forces(),
      bodies.map((b) => b.label));
    }
  }

  play.Painter = Painter;
  play.picture_size = { width, height };
})();
