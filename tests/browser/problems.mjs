// The problems whose pages are driven: arguments for `lcpush pivots`, and what to expect.
const textbook = (name) => [`fixtures/textbook/${name}.M.mtx`, `fixtures/textbook/${name}.q.mtx`];
const scene = (name) => [`fixtures/scenes/${name}.toml`];

export const problems = [
  { name: 'two_by_two', arguments: ['--M', '2 1; 1 2', '--q', '-5 -6', '--exact'],
    status: 'solved' },
  { name: 'kostreva', arguments: [...textbook('kostreva_1'), '--exact'], status: 'solved' },
  { name: 'kostreva_first_row', arguments: [...textbook('kostreva_1'), '--exact', '--first-row'],
    status: 'cycle' },
  { name: 'murty_ray', arguments: [...textbook('murty_2_9'), '--exact'], status: 'ray' },
  { name: 'murty_decimals', arguments: textbook('murty_2_11'), status: 'solved' },
  { name: 'floudas_cover', arguments: [...textbook('floudas_10_2_4'), '--exact'] },
  { name: 'coin', arguments: scene('coin'), status: 'solved' },
  { name: 'dropped', arguments: scene('dropped'), status: 'solved', most_steps: 20, rigid: false },
  { name: 'tipping', arguments: scene('tipping'), status: 'solved', most_steps: 20 },
  { name: 'tipping_exact', arguments: [...scene('tipping'), '--exact'], status: 'solved',
    most_steps: 20 },
  { name: 'tipping_as_solved', arguments: [...scene('tipping'), '--as-solved'], status: 'solved',
    most_steps: 20 },
  { name: 'slide_rigid', arguments: [...scene('straight_slide_point'), '--pressure', 'rigid'],
    status: 'solved', most_steps: 20, rigid: true },
  { name: 'slide', arguments: scene('straight_slide'), status: 'solved', most_steps: 20 },
  { name: 'slide_as_solved', arguments: [...scene('straight_slide_point'), '--as-solved'],
    status: 'solved', most_steps: 30 },
  { name: 'jam', arguments: [...scene('jam'), '--pressure', 'rigid'], status: 'ray',
    most_steps: 25 },
  { name: 'jam_as_solved', arguments: [...scene('jam'), '--as-solved'], status: 'ray',
    most_steps: 15 },
  { name: 'rolling', arguments: scene('rolling'), most_steps: 20 },
  { name: 'soft_fingers', arguments: scene('soft_fingers'), most_steps: 20 },
];
