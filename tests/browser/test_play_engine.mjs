// The playground's scripts that touch no page: changes of a scene's text, and the examples.
// Run by `node --test`; needs no browser and no tool.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { root, script_of } from './engine.mjs';

const play = new Function(`${script_of('play/page', 'raw.js')}\nreturn play;`)();
const { Toml, edits } = play;

const scenes = join(root, 'fixtures', 'scenes');
const fixtures = readdirSync(scenes).map((name) => [name, readFileSync(join(scenes, name), 'utf8')]);

const sample = `# a title = "that is none"
title = "A # in a string"
[object]
mass = 0.2  # kg
box = [0.1, # long
  0.03, 0.01,
]
[[finger]]
name = "left" # with a name
center = [0, 0, 0.005]
friction = 5e-1`;

test('values are found behind comments, over lines and at the end', () => {
  const toml = new Toml(sample);
  const object = toml.first('object');
  assert.equal(toml.get(toml.sections[0], 'title'), 'A # in a string');
  assert.equal(toml.get(object, 'mass'), 0.2);
  assert.deepEqual(toml.get(object, 'box'), [0.1, 0.03, 0.01]);
  assert.equal(toml.get(toml.body('left'), 'friction'), 0.5);
  assert.equal(toml.get(object, 'center_of_mass'), undefined);
  assert.equal(toml.get(undefined, 'jaws'), undefined);
});

test('a change leaves everything else as it is', () => {
  const text = edits.set(sample, edits.object, 'mass', 0.35);
  assert.equal(text, sample.replace('mass = 0.2 ', 'mass = 0.35 '));
  const longer = edits.set(text, edits.object, 'box', [0.2, 0.03, 0.01]);
  assert.match(longer, /box = \[0\.2, 0\.03, 0\.01\]\n\[\[finger\]\]/);
  assert.match(edits.set(sample, edits.top, 'facets', 16), /^facets = 16\n# a title/);
  assert.match(edits.set(sample, edits.named('left'), 'grip_force', 20),
    /friction = 5e-1\ngrip_force = 20$/);
  assert.equal(edits.with_hand(edits.with_hand(sample, 'locked'), 'parallel'),
    edits.with_hand(sample, 'parallel'));
});

test('units are read, and a contact on a face moves in that', () => {
  const text = sample.replace('0.2 ', '"120 g"').replace('0.03,', '"3 cm", ')
    .replace('center = [0, 0, 0.005]', 'on = "-y"\ncenter = ["1 mm", 0]\nangular_velocity = "180 deg/s"');
  const toml = new Toml(text);
  assert.equal(toml.get(toml.first('object'), 'mass'), 0.12);
  assert.deepEqual(toml.get(toml.first('object'), 'box'), [0.1, 0.03, 0.01]);
  assert.deepEqual(toml.get(toml.body('left'), 'angular_velocity'), [0, 0, Math.PI]);
  const state = { text, scene: { bodies: [{ name: 'left', normal: [0, 1, 0] }] } };
  assert.match(edits.dragged(state, ['left'], [0.001, 0.5, 0.003]), /center = \[0\.002, 0\.003\]/);
  assert.match(edits.dragged({ ...state, text: text.replace(/center.*\n/, '') }, ['left'],
    [0.001, 0.5, 0.003]), /center = \[0\.001, 0\.003\]/);
});

test('every number of a shipped scene can be written back without a change of the others', () => {
  let count = 0;
  for (const [name, text] of fixtures) {
    const toml = new Toml(text);
    for (const section of toml.sections) {
      for (const key of Object.keys(section.keys)) {
        const value = toml.get(section, key);
        assert.notEqual(value, undefined, `${name}: ${key}`);
        const again = new Toml(toml.with_value(section, key, value));
        for (const [k, other] of toml.sections.entries())
          for (const [one, was] of Object.entries(other.keys).map(([x]) => [x, toml.get(other, x)]))
            assert.deepEqual(again.get(again.sections[k], one), was, `${name}: ${key}, ${one}`);
        count += 1;
      }
    }
  }
  assert.ok(count > 300, `${count} values`);
});

test('a dragged body stays on its face, and a jaw takes its other finger along', () => {
  const [, text] = fixtures.find(([name]) => name === 'pivot.toml');
  const state = { text, answer: { hand: 'parallel' }, scene: { bodies: [
    { name: 'left', role: 'finger', normal: [0, 0, -1] },
    { name: 'right', role: 'finger', normal: [0, 0, 1] },
    { name: 'edge', role: 'pusher', normal: [0, 1, 0] }] } };
  const both = edits.dragged_together(state, 'left', false);
  assert.deepEqual(both, ['left', 'right']);
  assert.deepEqual(edits.dragged_together(state, 'left', true), ['left']);
  assert.deepEqual(edits.dragged_together(state, 'edge', false), ['edge']);
  const moved = new Toml(edits.dragged(state, both, [0.001, 0.002, 0.5]));
  const was = new Toml(text);
  for (const name of both) {
    const from = was.get(was.body(name), 'points');
    const to = moved.get(moved.body(name), 'points');
    from.forEach(([x, y, z], k) => to[k].forEach((value, i) =>
      assert.ok(Math.abs(value - [x + 0.001, y + 0.002, z][i]) < 1e-12)));
  }
  const pushed = new Toml(edits.dragged(state, ['edge'], [0.001, 0.5, 0]));
  assert.deepEqual(pushed.get(pushed.body('edge'), 'center'), [-0.039, 0], 'along its face');
});

test('what touches the ends of an object stays on them as it grows', () => {
  const text_of = (name) => fixtures.find(([file]) => file === `${name}.toml`)[1];
  const state = (text, axis, ...names) => ({ text, scene: { center_of_mass: [0, 0, 0],
    shape: { axis }, bodies: names.map((name) => ({ name })) } });
  const table = `[object]\nmass = 1\ncylinder_radius = 0.01\ncylinder_length = 0.04\naxis = "z"
[[finger]]\nname = "rim"\ncenter = [0.006, 0.008, 0.001]
[[finger]]\nname = "lid"\npoints = [[0, 0.004, 0.02], [0.004, 0, 0.02]]\n`;
  const coin = state(table, 2, 'rim', 'lid');
  const wide = new Toml(edits.with_cylinder(coin, 'cylinder_radius', 0.02));
  assert.equal(wide.get(wide.first('object'), 'cylinder_radius'), 0.02);
  assert.deepEqual(wide.get(wide.body('rim'), 'center'), [0.012, 0.016, 0.001]);
  assert.deepEqual(wide.get(wide.body('lid'), 'points'), [[0, 0.008, 0.02], [0.008, 0, 0.02]]);
  const long = new Toml(edits.with_cylinder(coin, 'cylinder_length', 0.06));
  assert.equal(long.get(long.first('object'), 'cylinder_radius'), 0.01);
  assert.deepEqual(long.get(long.body('rim'), 'center'), [0.006, 0.008, 0.0015]);
  assert.deepEqual(long.get(long.body('lid'), 'points')[0], [0, 0.004, 0.03]);
  const bar = state(text_of('pivot').replace('on = "-y"\nalong = "z"\ncenter = ["-40 mm", 0]',
    'normal = [0, 1, 0]\nends = [[-0.04, -0.015, -0.005], [-0.04, -0.015, 0.005]]'),
  undefined, 'left', 'right', 'edge');
  const [x, y, z] = new Toml(bar.text).get(new Toml(bar.text).first('object'), 'box');
  const high = new Toml(edits.with_edge(bar, 1, 2 * y));
  assert.deepEqual(high.get(high.first('object'), 'box'), [x, 2 * y, z]);
  const [ends, were] = [high, new Toml(bar.text)].map((toml) => toml.get(toml.body('edge'), 'ends'));
  ends.forEach((at, k) => assert.deepEqual(at, [were[k][0], 2 * were[k][1], were[k][2]]));
});

test('the examples are those of fixtures/textbook', () => {
  const numbers = (name) => readFileSync(join(root, 'fixtures', 'textbook', name), 'utf8')
    .split('\n').filter((line) => line && !line.startsWith('%')).slice(1).join(' ').trim()
    .split(/\s+/).map(Number);
  const examples = Object.entries(play.raw.examples);
  assert.ok(examples.length > 8);
  for (const [name, [M, q]] of examples) {
    const rows = M.split(';').map((row) => row.trim().split(/\s+/).map(Number));
    const columns = rows[0].flatMap((_, j) => rows.map((row) => row[j]));
    assert.deepEqual(columns, numbers(`${name}.M.mtx`), name);
    assert.deepEqual(q.split(' ').map(Number), numbers(`${name}.q.mtx`), name);
  }
});

test('the page unpacks its solver to the module that was packed', () => {
  const text = readFileSync(join(root, 'src', 'play', 'wasm', 'solver.txt'), 'ascii');
  const bytes = play.unpack(text);
  assert.equal(bytes.length, Number(text.split(' ')[0]));
  const module = new WebAssembly.Module(bytes);
  assert.deepEqual(WebAssembly.Module.imports(module), []);
  const solver = new play.Solver(module);
  const { sentence } = JSON.parse(solver.ask('drag', fixtures.find(([name]) => name === 'pivot.toml')[1]));
  assert.match(sentence, /pivots/);
});

test('every shipped scene has pivots that a page can read, whole numbers beyond 2^53 among them', () => {
  const solver = new play.Solver(new WebAssembly.Module(play.unpack(
    readFileSync(join(root, 'src', 'play', 'wasm', 'solver.txt'), 'ascii'))));
  let largest = 0;
  for (const [name, text] of fixtures) {
    const page = solver.ask('pivots', text);
    const [, json] = /<script type="application\/json"[^>]*>([\s\S]*?)<\/script>/.exec(page);
    assert.doesNotThrow(() => JSON.parse(json, (_, value) => {
      if (Number.isInteger(value)) largest = Math.max(largest, value);
      return value;
    }), name);
  }
  assert.ok(largest > 2 ** 53, `${largest}`);
});
