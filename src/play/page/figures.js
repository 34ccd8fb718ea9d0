// The things of a scene as points in space, from the description that reports and the explorer
// draw from.
(() => {
  const { add, subtract, scale, dot, cross, unit, length } = drawing.vectors;
  const range = (n) => [...Array(n).keys()];

  /// Of the prism that pictures of the object are drawn from: faces {normal, corners} about the
  /// centre of mass. Of one with many sides, a cylinder, the ends alone.
  function faces_of({ prism: { base, along }, center_of_mass }) {
    const low = base.map((corner) => subtract(corner, center_of_mass));
    const high = low.map((corner) => add(corner, along));
    const ends = [[low, -1], [high, 1]].map(([corners, side]) =>
      ({ normal: scale(unit(along), side), corners }));
    if (base.length > 8) return ends;
    const inside = middle(low);
    return [...ends, ...range(low.length).map((k) => {
      const next = (k + 1) % low.length;
      const across = unit(cross(subtract(low[next], low[k]), along));
      return { normal: scale(across, Math.sign(dot(across, subtract(low[k], inside)))),
        corners: [low[k], low[next], high[next], high[k]] };
    })];
  }

  const middle = (points) => scale(points.reduce(add), 1 / points.length);

  function object_faces(scene) {
    scene.faces ||= faces_of(scene);
    return scene.faces;
  }

  /// What encloses a body's points: a plate of their outline, a little larger and as thick as
  /// `thick`, on the far side of the object.
  function plate(scene, b, thick) {
    const { normal } = scene.bodies[b];
    const across = unit(cross(normal, Math.abs(normal[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0]));
    const along = cross(normal, across);
    const corners = [];
    for (const point of scene.points.filter(({ body }) => body === b))
      for (const k of range(12)) {
        const angle = 2 * Math.PI * k / 12;
        const edge = add(scale(across, Math.cos(angle)), scale(along, Math.sin(angle)));
        const rim = add(point.drawn_at, scale(edge, 0.45 * thick));
        corners.push(rim, subtract(rim, scale(normal, thick)));
      }
    return corners;
  }

  /// The half diagonal of all that is there, about the centre of mass.
  function reach(scene) {
    const far = scene.points.map(({ drawn_at }) =>
      length(subtract(drawn_at, scene.center_of_mass)));
    return Math.max(length(scene.shape.size) / 2, ...far);
  }

  /// Does the object have a shape, or is it known by its inertia alone?
  const has_shape = ({ shape }) => Math.max(...shape.size) > 0;

  /// Body numbers of the file: under even pressure each point is a body of its own.
  const names = (scene) => [...new Set(scene.bodies.map(({ name }) => name))];
  const faces_viewer = (view, normal) => dot(view.toward, normal) > 1e-9;

  play.figures = { object_faces, plate, middle, reach, has_shape, names, faces_viewer };
})();
