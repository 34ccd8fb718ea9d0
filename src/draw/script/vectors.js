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

  drawing.vectors = { add, subtract, scale, dot, length, unit, cross, turned };
})();
