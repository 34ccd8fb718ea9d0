// Vectors as lists of numbers.
(() => {
  const add = (a, b) => a.map((x, k) => x + b[k]);
  const subtract = (a, b) => a.map((x, k) => x - b[k]);
  const scale = (a, s) => a.map((x) => x * s);
  const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
  const length = (a) => Math.hypot(...a);
  const unit = (a) => scale(a, 1 / (length(a) || 1));
  const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];

  /// v turned about the vector `turn` by its length [rad].
  function turned(v, turn) {
    const angle = length(turn);
    if (angle < 1e-12) return v;
    const axis = scale(turn, 1 / angle);
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    return add(add(scale(v, c), scale(cross(axis, v), s)), scale(axis, dot(axis, v) * (1 - c)));
  }

  /// Corners of the convex hull of points of the plane, in order.
  function hull(points) {
    const sorted = [...points].sort(([a, b], [x, y]) => a - x || b - y);
    const half = (list) => {
      const chain = [];
      for (const p of list) {
        while (chain.length > 1) {
          const [a, b] = chain.slice(-2);
          if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 1e-9) break;
          chain.pop();
        }
        chain.push(p);
      }
      return chain.slice(0, -1);
    };
    return [...half(sorted), ...half(sorted.reverse())];
  }

  drawing.vectors = { add, subtract, scale, dot, length, unit, cross, turned, hull };
})();
