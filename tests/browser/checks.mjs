// What a page must show at a step, compared with the trace. Each check throws.
import assert from 'node:assert/strict';

const number = (text) => {
  if (typeof text === 'number') return text;
  const [over, under = '1'] = String(text).split('/');
  return Number(over) / Number(under);
};

/// Equal as texts in fractions, within rounding of `size` in decimals.
function same_number(exact, actual, expected, size, where) {
  if (exact) { assert.equal(String(actual), String(expected), where); return; }
  const difference = Math.abs(number(actual) - number(expected));
  assert.ok(difference <= 1e-7 * Math.max(size, Math.abs(number(expected))),
    `${where}: ${actual} is not ${expected}`);
}

function same_value(exact, actual, expected, size, where) {
  const parts = (x) => (Array.isArray(x) ? x : [0, x]);
  parts(actual).forEach((x, k) => same_number(exact, x, parts(expected)[k], size[k],
    `${where}, part ${k}`));
}

const sizes_of = (values) => {
  const list = values.filter((x) => x !== null).map((x) => (Array.isArray(x) ? x : [0, x]));
  return [0, 1].map((k) => Math.max(1e-9, ...list.map((x) => Math.abs(number(x[k])))));
};

/// The step's state against pivot k of the trace.
export function check_pivot(trace, k, state) {
  const exact = trace.arithmetic === 'fractions';
  const pivot = trace.pivots[k];
  const where = `pivot ${k}`;
  assert.equal(state.pivot, k);
  assert.equal(state.entering, pivot.entering, where);
  assert.equal(state.leaving, pivot.leaving, where);
  assert.equal(state.basis[state.row], pivot.leaving, where);
  assert.equal(state.nonbasic[state.column], pivot.entering, where);
  assert.deepEqual([...state.ties].sort(), [...pivot.ties].sort(), where);
  const sizes = sizes_of(pivot.ratios);
  pivot.ratios.forEach((ratio, r) => {
    const shown = state.ratios[r];
    assert.equal(shown === null, ratio === null, `${where}, ratio of row ${r}`);
    if (ratio !== null) same_value(exact, shown, ratio, sizes, `${where}, ratio of row ${r}`);
  });
  if (exact) assert.deepEqual(state.own_ratios, pivot.ratios, `${where}, ratios found by the page`);
  if (!pivot.tableau) return;
  const { tableau } = pivot;
  assert.deepEqual(state.basis, tableau.rows, where);
  assert.deepEqual(state.nonbasic, tableau.columns, where);
  assert.deepEqual([state.row, state.column], [tableau.row, tableau.column], where);
  const largest = Math.max(...tableau.entries.flat().map((x) => Math.abs(number(x))));
  tableau.entries.forEach((row, r) => row.forEach((entry, c) =>
    same_number(exact, state.entries[r][c], entry, largest, `${where}, entry ${r} ${c}`)));
  const value_sizes = sizes_of(tableau.values);
  tableau.values.forEach((value, r) =>
    same_value(exact, state.values[r], value, value_sizes, `${where}, value ${r}`));
}

/// The state after pivot k: the next frame's basis and z0.
export function check_after(trace, k, state) {
  const exact = trace.arithmetic === 'fractions';
  assert.deepEqual(state.basis, trace.pivots[k].basis, `basis after pivot ${k}`);
  const all = sizes_of(trace.pivots.map(({ z0 }) => z0));
  same_value(exact, state.z0, trace.pivots[k].z0, all, `z0 after pivot ${k}`);
}

/// What the page draws against the state: highlights, the pivot's cell, names of the tied rows.
export function check_marks(state, seen) {
  if (state.entering === null) { assert.equal(seen.pivot_cells, 0); return; }
  assert.deepEqual(seen.entering, [state.entering]);
  assert.deepEqual(seen.leaving, [state.leaving]);
  assert.deepEqual(seen.pivot, [[state.row, state.column]]);
  const drawn = new Set(seen.rows);
  assert.deepEqual([...seen.tied].sort(),
    state.ties.filter((name) => drawn.has(name)).sort());
}

const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0]];
const add = (a, b) => a.map((x, i) => x + b[i]);
const scale = (a, s) => a.map((x) => x * s);
const length = (a) => Math.hypot(...a);

/// Newton from the forces that the picture shows, and every friction row of the tableau from the
/// motions that it shows: w - d z0 = d_j . r + slip. (Normal rows hold too where no pad yields.)
export function check_picture(scene, picture, rigid) {
  const parts = [[picture.large, 0], [picture, 1]];
  let largest = 1e-6;
  for (const [level, k] of parts) {
    let wrench = k === 1 ? [...scene.load] : Array(6).fill(0);
    level.forces.forEach((force, i) => {
      const point = scene.points[i];
      const { normal } = scene.bodies[point.body];
      const total = add(scale(normal, force.normal), force.friction);
      const arm = add(point.position, scale(scene.center_of_mass, -1));
      const moment = add(cross(arm, total), scale(normal, force.torsion || 0));
      wrench = add(wrench, [...total, ...moment]);
    });
    const newton = scene.mobility.map((row) => dot(row, wrench));
    // Rounding is measured by the terms of the sum: large forces may cancel to a small motion.
    const terms = level.forces.reduce((sum, force) => sum + Math.abs(force.normal)
      + length(force.friction), 0);
    const mobile = Math.max(...scene.mobility.flat().map(Math.abs));
    largest = Math.max(largest, length(newton), 1e-6 * terms * mobile);
    newton.forEach((x, i) => assert.ok(Math.abs(x - level.acceleration[i]) <= 1e-9 * largest,
      `Newton, component ${i}: ${level.acceleration[i]} is not ${x}`));
    scene.points.forEach((point, p) => {
      const arm = add(point.position, scale(scene.center_of_mass, -1));
      const body = scene.bodies[point.body];
      const twist = add(level.acceleration, scale(level.bodies[point.body], -1));
      const at = add(twist.slice(0, 3), cross(twist.slice(3), arm));
      const near = (row, x, what) => assert.ok(Math.abs(picture.w[row][k] - x) <= 1e-6 * largest,
        `${what} of ${point.name}, part ${k}: ${x} is not ${picture.w[row][k]}`);
      point.friction.forEach((row, j) => {
        const { force, torque } = point.generators[j];
        near(row, dot(force, at) + (torque || 0) * dot(body.normal, twist.slice(3))
          + picture.z[point.slip][k], `friction row ${j}`);
      });
      if (rigid) near(point.normal, dot(body.normal, at), 'normal row');
      if (point.slip !== null && point.slip !== undefined) {
        const bound = body.friction * (picture.z[point.normal][k]
          + (point.pull === null || point.pull === undefined ? 0 : picture.z[point.pull][k]));
        near(point.slip, bound - point.friction.reduce((sum, f) => sum + picture.z[f][k], 0),
          'cone row');
      }
    });
  }
}
