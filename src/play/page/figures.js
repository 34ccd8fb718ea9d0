// The things of a scene as points in space, from the description that reports and the explorer
// draw from.
(() => {
  const { add, subtract, scale, dot, cross, unit, length } = drawing.vectors;
  const range = (n) => [...Array(n).keys()];

  /// Faces, each {normal, corners}, about the centre of mass at 0.
  function box_faces([x, y, z]) {
    const half = [x / 2, y / 2, z / 2];
    const faces = [];
    for (const axis of range(3)) {
      for (const side of [1, -1]) {
        const [a, b] = [(axis + 1) % 3, (axis + 2) % 3];
        const corners = [[1, 1], [-1, 1], [-1, -1], [1, -1]].map(([p, q]) => {
          const corner = [0, 0, 0];
          corner[axis] = side * half[axis];
          corner[a] = p * half[a];
          corner[b] = q * half[b];
          return corner;
        });
        faces.push({ normal: range(3).map((k) => (k === axis ? side : 0)), corners });
      }
    }
    return faces;
  }

  function cylinder_faces(size, axis) {
    const sides = 48;
    const [a, b] = [(axis + 1) % 3, (axis + 2) % 3];
    const rim = (end, k) => {
      const corner = [0, 0, 0];
      corner[axis] = end * size[axis] / 2;
      corner[a] = size[a] / 2 * Math.cos(2 * Math.PI * k / sides);
      corner[b] = size[b] / 2 * Math.sin(2 * Math.PI * k / sides);
      return corner;
    };
    return [1, -1].map((end) => ({
      normal: range(3).map((k) => (k === axis ? end : 0)),
      corners: range(sides).map((k) => rim(end, k)),
    }));
  }

  const object_faces = ({ shape }) => (shape.kind === 'cylinder'
    ? cylinder_faces(shape.size, shape.axis) : box_faces(shape.size));

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

  const middle = (points) => scale(points.reduce(add), 1 / points.length);

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
