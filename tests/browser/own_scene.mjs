// A grasp assembled by hand (docs/theory/theory.md, 5.1), without compliance: two fingers of four points
// with a force each, and a pusher; or the planar one: a box on a stop. In SI units.
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0]];
const column = (point, u) => [...u, ...cross(point, u)];

function tangent_of(normal) {
  let axis = 0;
  for (let k = 1; k < 3; ++k) if (Math.abs(normal[k]) < Math.abs(normal[axis])) axis = k;
  return [0, 1, 2].map((k) => (k === axis ? 1 : 0));
}

/// bodies: {name, role, normal, friction, acceleration, force (or null), points}. -> {scene, M, q,
/// meanings} for own_trace.
export function own_scene({ title, mass, size, gravity, facets, bodies, planar = false }) {
  const [a, b, c] = size;
  const inertia = [b * b + c * c, a * a + c * c, a * a + b * b].map((x) => mass * x / 12);
  const free = planar ? [1, 1, 0, 0, 0, 1] : [1, 1, 1, 1, 1, 1];
  const mobility = free.map((allowed, i) => free.map((_, j) =>
    (i === j && allowed ? 1 / (i < 3 ? mass : inertia[i - 3]) : 0)));
  const apply = (v) => mobility.map((row) => dot(row, v));
  const weight = [...gravity.map((x) => mass * x), 0, 0, 0];
  const rows = []; // {kind, wrench, point, body}
  const points = [];
  const meanings_w = [];
  const meanings_z = [];
  const add_row = (row, w, z) => { rows.push(row); meanings_w.push(w); meanings_z.push(z); };
  bodies.forEach((body, k) => {
    const tangent = tangent_of(body.normal);
    const other = cross(body.normal, tangent);
    body.points.forEach((position, p) => {
      const name = `${body.name}.${p + 1}`;
      const first = rows.length;
      const point = { name, body: k, position, normal: first, pull: null, friction: [], slip: null,
        generators: [] };
      add_row({ kind: 'normal', wrench: column(position, body.normal), point, body: k },
        `normal acceleration of ${name} (m/s^2)`, `normal force of ${name} (N)`);
      if (body.friction > 0) {
        for (let j = 0; j < facets; ++j) {
          const angle = 2 * Math.PI * j / facets;
          const exact = (x) => (Math.abs(x) < 1e-15 ? 0 : x);
          const force = tangent.map((x, i) =>
            exact(Math.cos(angle)) * x + exact(Math.sin(angle)) * other[i]);
          point.friction.push(rows.length);
          point.generators.push({ force, torque: 0 });
          add_row({ kind: 'friction', wrench: column(position, force), point, body: k },
            `slip room of ${name} along friction ${j + 1} (m/s^2)`,
            `friction of ${name} along ${j + 1} (N)`);
        }
        point.slip = rows.length;
        add_row({ kind: 'cone', wrench: Array(6).fill(0), point, body: k },
          `friction left at ${name} (N)`, `slip of ${name} (m/s^2)`);
      }
      points.push(point);
    });
  });
  const drives = [];
  bodies.forEach((body, k) => {
    body.actuators = [];
    if (body.force === null || body.force === undefined) return;
    const actuator = { variable: rows.length, twist: [...body.normal, 0, 0, 0] };
    body.actuators.push(actuator);
    drives.push({ actuator, body: k });
    add_row({ kind: 'actuator', body: k, wrench: actuator.twist },
      `force above the grip force of ${body.name} (N)`,
      `closing of ${body.name}, from its bound (m/s^2)`);
  });
  const is_force = (row) => row.kind === 'normal' || row.kind === 'friction';
  const coupling = (row, drive) =>
    (row.body === drive.body ? dot(row.wrench, drive.actuator.twist) : 0);
  const M = rows.map((row) => rows.map((other) => {
    if (is_force(row) && is_force(other)) return dot(row.wrench, apply(other.wrench));
    if (row.kind === 'friction' && other.kind === 'cone' && row.point === other.point) return 1;
    if (row.kind === 'cone' && row.point === other.point)
      return { normal: bodies[row.body].friction, friction: -1 }[other.kind] || 0;
    const drive_of = (x) => drives.find(({ actuator }) => actuator.variable === rows.indexOf(x));
    if (is_force(row) && other.kind === 'actuator') return -coupling(row, drive_of(other));
    if (row.kind === 'actuator' && is_force(other)) return coupling(other, drive_of(row));
    return 0;
  }));
  const q = rows.map((row) => {
    if (row.kind === 'cone') return 0;
    if (row.kind === 'actuator') return -bodies[row.body].force;
    const finite = dot(row.wrench, apply(weight)) - dot(row.wrench, bodies[row.body].acceleration);
    const large = drives.reduce((sum, drive) => sum + coupling(row, drive), 0);
    return large === 0 ? finite : [large, finite];
  });
  const scene = { title, planar, gravity, mass, center_of_mass: [0, 0, 0],
    shape: { kind: 'box', size, axis: 2 }, mobility, load: weight, facets,
    bodies: bodies.map((body) => ({ ...body, tangent: tangent_of(body.normal) })), points };
  return { title, M, q, scene, free: drives.length, rows,
    meanings: [...meanings_w, ...meanings_z, 'artificial variable'] };
}

export const straight_slide = (facets = 4) => own_scene({ title: 'Straight slide, line pusher',
  mass: 0.2, size: [0.1, 0.03, 0.01], gravity: [0, -9.81, 0], facets, bodies: [
    { name: 'left', role: 'finger', normal: [0, 0, -1], friction: 0.5,
      acceleration: Array(6).fill(0), force: 20,
      points: [[0.005, 0, 0.005], [0, 0.005, 0.005], [-0.005, 0, 0.005],
        [0, -0.005, 0.005]] },
    { name: 'right', role: 'finger', normal: [0, 0, 1], friction: 0.5,
      acceleration: Array(6).fill(0), force: 20,
      points: [[0.005, 0, -0.005], [0, 0.005, -0.005], [-0.005, 0, -0.005],
        [0, -0.005, -0.005]] },
    { name: 'wall', role: 'pusher', normal: [1, 0, 0], friction: 0.3,
      acceleration: [0.1, 0, 0, 0, 0, 0], force: null,
      points: [[-0.05, -0.015, 0], [-0.05, 0.015, 0]] }] });

export const planar_tip = () => own_scene({ title: 'A box pushed high tips on a stop', mass: 1,
  size: [0.2, 0.3, 0.1], gravity: [0, -9.81, 0], facets: 4, planar: true, bodies: [
    { name: 'floor', role: 'finger', normal: [0, 1, 0], friction: 0.6,
      acceleration: Array(6).fill(0), force: null, points: [[-0.1, -0.15, 0], [0.1, -0.15, 0]] },
    { name: 'hand', role: 'pusher', normal: [1, 0, 0], friction: 0.3,
      acceleration: [1, 0, 0, 0, 0, 0], force: null, points: [[-0.1, 0.1, 0]] }] });
