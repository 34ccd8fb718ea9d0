// The explorer's engine against known answers: fractions, dictionary, ratio test, Lemke, branches.
// Run by `node --test`; needs no browser and no tool.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { load_engine, root } from './engine.mjs';
import { own_trace } from './own_trace.mjs';

const engine = load_engine();

/// A Matrix Market array: numbers column by column.
function read_array(name) {
  const lines = readFileSync(join(root, 'fixtures', 'textbook', name), 'utf8').split('\n')
    .filter((line) => line && !line.startsWith('%'));
  const [rows, columns] = lines[0].split(/\s+/).map(Number);
  const numbers = lines.slice(1).map((x) => x.trim());
  return [...Array(rows).keys()].map((i) =>
    [...Array(columns).keys()].map((j) => numbers[j * rows + i]));
}

const textbook = (name, options) => own_trace({ title: name, M: read_array(`${name}.M.mtx`),
  q: read_array(`${name}.q.mtx`).map(([x]) => x), exact: true, engine, ...options });

const path_of = (trace, of = engine) => of.Path.recorded(new of.Problem(trace));

/// Small reproducible random numbers.
function random_source(seed) {
  let state = seed;
  return () => {
    state = (state * 1103515245 + 12345) % 2147483648;
    return state / 2147483648;
  };
}

/// |w - (q + M z)| and the complementarity of an answer, exactly.
function exact_defect({ fractions }, M, q, z, w) {
  const parsed = z.map(fractions.parse);
  return M.map((row, i) => {
    let sum = fractions.parse(q[i]);
    row.forEach((x, j) => {
      sum = fractions.add(sum, fractions.multiply(fractions.parse(x), parsed[j]));
    });
    const same = fractions.text(sum) === w[i];
    const complementary = w[i] === '0' || z[i] === '0';
    return same && complementary && parsed[i].n >= 0n && sum.n >= 0n;
  }).filter((good) => !good).length;
}

test('the smallest example has z = (4/3, 7/3)', () => {
  const trace = own_trace({ title: '', M: [['2', '1'], ['1', '2']], q: ['-5', '-6'], exact: true });
  assert.equal(trace.status, 'solved');
  assert.deepEqual(trace.final.z, ['4/3', '7/3']);
  assert.equal(trace.pivots.length, 3);
});

test('Kostreva\'s example cycles by first rows and is solved lexicographically', () => {
  const cycling = textbook('kostreva_1', { rule: 'first_row' });
  assert.equal(cycling.status, 'cycle');
  const { from_pivot, length } = cycling.cycle;
  const sorted = (pivot) => [...pivot.basis].sort().join();
  assert.equal(sorted(cycling.pivots[from_pivot]), sorted(cycling.pivots[from_pivot + length]));
  const solved = textbook('kostreva_1', {});
  assert.equal(solved.status, 'solved');
  assert.deepEqual(solved.final.z, ['1/3', '1/3', '1/3']);
});

test('Murty\'s example 2.9 ends in a ray whose certificate holds, and a false one does not', () => {
  const trace = textbook('murty_2_9', {});
  assert.equal(trace.status, 'ray');
  const check = engine.certificate.check_ray(path_of(trace));
  assert.ok(check.v_holds && check.y_holds && check.products_vanish);
  const wrong = structuredClone(trace);
  wrong.ray.v[0] = '7';
  const refused = engine.certificate.check_ray(path_of(wrong));
  assert.ok(!(refused.y_holds && refused.products_vanish));
});

test('every tableau of a path is the one that pivot by pivot gives, in any order of asking', () => {
  const random = random_source(7);
  const n = 80;
  const root_matrix = [...Array(n)].map(() => [...Array(n)].map(() => random() - 0.5));
  const M = root_matrix.map((a, i) => root_matrix.map((b, j) =>
    a.reduce((sum, x, k) => sum + x * b[k], i === j ? 0.1 : 0)));
  const q = [...Array(n)].map(() => random() - 0.8);
  const trace = own_trace({ title: '', M, q });
  assert.equal(trace.status, 'solved');
  assert.ok(trace.pivots.length > 33, 'long enough to pass a checkpoint');
  const path = path_of(trace);
  for (const k of [trace.pivots.length - 1, 0, 33, 31, 32, 5]) {
    const dictionary = path.dictionary(k);
    const { tableau } = trace.pivots[k];
    tableau.entries.forEach((row, r) => row.forEach((x, c) => {
      const difference = Math.abs(dictionary.entry(r, c) - x);
      assert.ok(difference < 1e-8 * Math.max(1, Math.abs(x)), `pivot ${k}, ${r}, ${c}`);
    }));
  }
});

test('fractions and decimals take the same pivots to the same answer', () => {
  for (let seed = 1; seed <= 60; ++seed) {
    const random = random_source(seed);
    const n = 2 + seed % 7;
    const whole = () => Math.floor(random() * 19) - 9;
    const L = [...Array(n)].map(() => [...Array(n)].map(whole));
    const skew = [...Array(n)].map(() => [...Array(n)].map(whole));
    const M = L.map((a, i) => L.map((b, j) => a.reduce((s, x, k) => s + x * b[k], i === j ? 1 : 0)
      + skew[i][j] - skew[j][i]));
    const q = [...Array(n)].map(whole);
    const decimals = own_trace({ title: '', M, q });
    const text = M.map((row) => row.map(String));
    const exact = own_trace({ title: '', M: text, q: q.map(String), exact: true });
    assert.equal(exact.status, 'solved', `seed ${seed}`);
    assert.equal(decimals.status, 'solved');
    if (exact.final.z === null) continue;
    assert.equal(exact_defect(engine, text, q.map(String), exact.final.z, exact.final.w), 0);
    exact.final.z.forEach((x, i) => {
      const { n: over, d: under } = engine.fractions.parse(x);
      const number = engine.fractions.to_number(over, under);
      assert.ok(Math.abs(number - decimals.final.z[i]) < 1e-9 * Math.max(1, number));
    });
    assert.deepEqual(exact.pivots.map((pivot) => [pivot.entering, pivot.leaving]),
      decimals.pivots.map((pivot) => [pivot.entering, pivot.leaving]), `seed ${seed}`);
  }
});

test('another tied row may leave; the branch ends by itself, by first rows it may cycle', () => {
  const path = path_of(textbook('kostreva_1', {}));
  const [first] = path.pivots;
  assert.equal(first.ties.length, 3);
  const endings = new Set();
  for (const row of [0, 1, 2]) {
    for (const rule of ['lexicographic', 'first_row']) {
      const branch = path.branch_at(0, row, rule);
      assert.equal(branch.pivots[0].leaving, row);
      endings.add(branch.outcome.status);
      if (branch.outcome.status !== 'solved') continue;
      const { z } = engine.certificate.solution(branch);
      assert.deepEqual(z.map(([x]) => engine.fractions.text(x)), ['1/3', '1/3', '1/3']);
    }
  }
  assert.deepEqual([...endings].sort(), ['cycle', 'solved']);
});

test('values with a part times S are compared by that part first', () => {
  const M = [[1, 0], [0, 1]];
  const trace = own_trace({ title: '', M, q: [[-1, 5], [0, -100]], free: 1 });
  assert.equal(trace.status, 'solved');
  assert.equal(trace.pivots[0].leaving, 'w1');
  assert.deepEqual(trace.pivots[0].ratios, [[1, -5], 100]);
});

test('a decimal that is all of a fraction carries no sign of rounding', () => {
  const problem = new engine.Problem(own_trace({ title: '', M: [['1']], q: ['-1'], exact: true }));
  const shown = (text) => engine.number_text.scalar(problem, engine.fractions.parse(text), false);
  assert.deepEqual(['1/2', '-3/8', '7', '-1/16', '0'].map(shown),
    ['0.5', '\u22120.375', '7', '\u22120.0625', '0']);
  assert.deepEqual(['1/3', '123456789/1000'].map(shown), ['\u22480.3333', '\u2248123500']);
});

test('a row that may not leave says why', () => {
  const path = path_of(own_trace({ title: '', M: [['2', '1'], ['1', '2']], q: ['-5', '-6'],
    exact: true }));
  const said = (frame, variable) => engine.words.why_not(path, frame,
    path.dictionary(frame).rows.indexOf(variable));
  assert.equal(said(0, 0), 'Not w1: it is lifted to 0 at z0 = 5 already, while w2 would still be '
    + 'negative.');
  path.frames.slice(1, -1).forEach((_, k) => {
    const step = path.step(k + 1);
    path.dictionary(k + 1).rows.forEach((variable, r) => {
      if (variable === step.leaving) return;
      const words = engine.words.why_not(path, k + 1, r);
      assert.match(words, step.ratios[r] ? /reaches 0 only at/ : /never reaches 0/);
    });
  });
});

test('long numbers: the greatest common divisor is Euclid\'s', () => {
  const euclid = (a, b) => (b ? euclid(b, a % b) : a);
  let [a, b] = [1n, 1n];
  for (let i = 0; i < 250; ++i) {
    a = a * 7n + BigInt(i * i + 3);
    b = b * 9n + BigInt(i * 3 + 1);
    assert.equal(engine.fractions.gcd(a, b), euclid(a, b));
    assert.equal(engine.fractions.gcd(a * b, 12n * b), euclid(a * b, 12n * b));
  }
});

test('a spoiled exchange is noticed', () => {
  const spoiled = load_engine((text) =>
    text.replace('x * pivot - flip * factor * y', 'x * pivot + flip * factor * y'));
  let noticed = false;
  try {
    const M = [['2', '1'], ['1', '2']];
    const trace = own_trace({ title: '', M, q: ['-5', '-6'], exact: true, engine: spoiled });
    noticed = trace.status !== 'solved'
      || exact_defect(engine, M, ['-5', '-6'], trace.final.z, trace.final.w) > 0;
  } catch { noticed = true; }
  assert.ok(noticed);
});
