// From the unknowns of a basis to forces and motion: what the picture of a scene shows.
//
// Numbers come in two levels, [times S, finite]: while the method runs, an actuator may stand at
// its symbolic bound -S, and then forces and motions have a part that is a multiple of S.
(() => {
  const { add, scale, subtract, dot, length, cross } = drawing.vectors;

  /// The acceleration that a twist at the centre of mass gives the point at `arm` from it.
  const at_point = (twist, arm) => add(twist.slice(0, 3), cross(twist.slice(3), arm));

  /// Forces and motions of one level. z: SI numbers of that level; level 0 is the part times S.
  function level_of(scene, z, level) {
    const finite = level === 1;
    let wrench = finite ? [...scene.load] : Array(6).fill(0);
    const forces = scene.points.map((point) => {
      const { normal: direction } = scene.bodies[point.body];
      const arm = subtract(point.position, scene.center_of_mass);
      const pull = point.pull === null ? 0 : z[point.pull];
      const normal = z[point.normal] - pull;
      let friction = [0, 0, 0];
      let torsion = 0;
      point.friction.forEach((variable, j) => {
        friction = add(friction, scale(point.generators[j].force, z[variable]));
        torsion += z[variable] * (point.generators[j].torque || 0);
      });
      const force = add(scale(direction, normal), friction);
      const moment = add(cross(arm, force), scale(direction, torsion));
      wrench = add(wrench, [...force, ...moment]);
      return { normal, friction, torsion, force };
    });
    const acceleration = scene.mobility.map((row) => dot(row, wrench));
    const bodies = scene.bodies.map((body) => {
      let twist = finite ? [...body.acceleration] : Array(6).fill(0);
      for (const actuator of body.actuators) {
        const { variable } = actuator;
        const closing = z[variable] - (finite ? 0 : 1); // s = s' - S
        twist = add(twist, scale(actuator.twist, closing));
      }
      return twist;
    });
    return { forces, acceleration, bodies };
  }

  /// The sign of [times S, finite]: S decides unless its part is zero.
  const sign = ([large, finite]) => Math.sign(large) || Math.sign(finite);

  /// Does the object move across the body there? Without friction nothing else tells sliding from
  /// sticking.
  function moves_across(scene, point, { acceleration, bodies }) {
    const arm = subtract(point.position, scene.center_of_mass);
    const { normal } = scene.bodies[point.body];
    const [object, body] = [acceleration, bodies[point.body]].map((twist) => at_point(twist, arm));
    const relative = subtract(object, body);
    const across = subtract(relative, scale(normal, dot(relative, normal)));
    return length(across) > 1e-9 * (length(object) + length(body));
  }

  function mode_of(scene, point, z, w, levels) {
    const none = [0, 0];
    const pull = point.pull === null ? none : z[point.pull];
    // w < 0 is possible while z0 makes up for it.
    if (sign(z[point.normal]) === 0 && sign(pull) === 0)
      return ['sink', 'touch', 'separate'][sign(w[point.normal]) + 1];
    if (point.slip === null)
      return levels.some((level) => moves_across(scene, point, level)) ? 'slide' : 'stick';
    return sign(z[point.slip]) > 0 ? 'slide' : 'stick';
  }

  /// z, w: [times S, finite] by index in SI units, w without d z0.
  function picture(scene, z, w) {
    const levels = [0, 1].map((k) => level_of(scene, z.map((x) => x[k]), k));
    const modes = scene.points.map((point) => mode_of(scene, point, z, w, levels));
    const size = (level) => Math.max(length(level.acceleration),
      ...level.forces.map(({ force }) => length(force)), ...level.bodies.map(length));
    [levels[0].times, levels[1].times] = [' S', '']; // what a number's unit begins with
    return { large: levels[0], finite: levels[1], modes, has_large: size(levels[0]) > 1e-12 };
  }

  explorer.mechanics = { picture, at_point, sign };
})();
