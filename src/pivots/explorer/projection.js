// Orthographic views along the scene's axes, and plane geometry for drawing.
(() => {
  const axis_names = ['x', 'y', 'z'];

  /// right, down: {axis, sign}: which scene axis points that way on the screen.
  function make_view(title, right, down) {
    const depth = 3 - right.axis - down.axis;
    // toward > 0 where a direction points at the viewer: right x up comes out of the screen.
    const even = (right.axis + 1) % 3 === down.axis;
    const toward = (even ? -1 : 1) * right.sign * down.sign;
    return { title, right, down, depth, toward,
      flat: (v) => [right.sign * v[right.axis], down.sign * v[down.axis]],
      toward_viewer: (v) => toward * v[depth] };
  }

  const front = () => make_view('Front view, x and y', { axis: 0, sign: 1 }, { axis: 1, sign: -1 });
  const top = () => make_view('Top view, x and z', { axis: 0, sign: 1 }, { axis: 2, sign: 1 });
  const side = () => make_view('Side view, z and y', { axis: 2, sign: -1 }, { axis: 1, sign: -1 });

  /// The front view, and of the other two the one in which more of the contacts' normals lie.
  function views(scene) {
    if (scene.planar) return [front()];
    const seen = [0, 0, 0];
    for (const { normal } of scene.bodies)
      normal.forEach((x, k) => { seen[k] = Math.max(seen[k], Math.abs(x)); });
    if (seen[0] > 0.5 || scene.shape.size[0] >= scene.shape.size[1]) return [front(), top()];
    return [front(), side()];
  }

  /// The convex hull of points in the plane (monotone chain).
  function hull(points) {
    const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    const turn = (o, a, b) => (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
    const half = (list) => {
      const chain = [];
      for (const p of list) {
        while (chain.length > 1 && turn(chain.at(-2), chain.at(-1), p) <= 0) chain.pop();
        chain.push(p);
      }
      return chain.slice(0, -1);
    };
    return sorted.length < 3 ? sorted : [...half(sorted), ...half(sorted.reverse())];
  }

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

  explorer.projection = { views, hull, round_below, round_above, axis_names };
})();
