// What would happen elsewhere on a slider: the push solved at many of its values, shaded below it.
(() => {
  const { h } = drawing.elements;
  const samples = 40;

  const kinds = {
    falls: 'it falls without the push',
    jams: 'no answer: it jams',
    stays: 'the object stays',
    sticks: 'it moves, the pusher sticks',
    slips: 'it moves, the pusher slips',
  };

  function kind_of(answer) {
    if (answer.status !== 'solved') return 'jams';
    if (answer.holds_without_push === false) return 'falls';
    const speeds = answer.contacts.map(({ acceleration }) => Math.hypot(...acceleration));
    const motion = Math.hypot(...answer.object.acceleration.slice(0, 3));
    if (motion < 1e-6 * Math.max(...speeds, 1e-9)
      && Math.hypot(...answer.object.acceleration.slice(3)) < 1e-6) return 'stays';
    const pushers = answer.bodies.filter(({ role }) => role === 'pusher').map(({ name }) => name);
    const slips = answer.contacts.some((contact) =>
      pushers.includes(contact.body) && contact.mode === 'slide');
    return slips ? 'slips' : 'sticks';
  }

  /// "0.1 to 0.3: it moves, the pusher sticks; ..": the bands for those who do not see them.
  function bands_of(found) {
    const bands = [];
    for (const [kind, value] of found) {
      if (bands.at(-1)?.kind !== kind) bands.push({ kind, from: value });
      bands.at(-1).to = value;
    }
    const text = drawing.numbers.decimal;
    return bands.map(({ kind, from, to }) =>
      `${text(from)} to ${text(to)}: ${kinds[kind] || 'no scene'}`).join('; ');
  }

  /// What happens in each of `count` scenes, asked one after the other; null as soon as nobody wants
  /// to know it any longer.
  async function kinds_of(background, question, count, scene, is_wanted) {
    const found = [];
    for (let k = 0; k < count; k += 1) {
      let kind = 'none';
      try {
        const reply = await background.ask(question, 'drag', scene(k));
        if (reply === null) return null;
        kind = kind_of(JSON.parse(reply).answer);
      } catch {
        // A text that is no scene.
      }
      if (!is_wanted()) return null;
      found.push(kind);
    }
    return found;
  }

  /// The key of the kinds that are there.
  const key_of = (found) => Object.keys(kinds).filter((kind) => found.includes(kind))
    .map((kind) => h('span', {}, h('i', { class: kind }), kinds[kind]));

  class Region {
    constructor(background) { Object.assign(this, { background, turn: 0 }); }

    /// Below the slider `range` of `control`, in the scene of `state`.
    async show(place, key, range, control, state) {
      this.now = { place, key, range, control };
      this.turn += 1;
      const { turn } = this;
      const [least, most] = [Number(range.min), Number(range.max)];
      const value = (k) => least + (most - least) * (k + 0.5) / samples;
      const found = await kinds_of(this.background, 'region', samples,
        (k) => control.write(state, value(k)), () => turn === this.turn);
      if (!found) return;
      place.replaceChildren(...found.map((one) => h('i', { class: one })));
      key.replaceChildren(...key_of(found));
      place.hidden = false;
      key.hidden = false;
      range.setAttribute('aria-description', bands_of(found.map((kind, k) => [kind, value(k)])));
    }

    /// The scene has changed elsewhere than at this slider.
    again(state) {
      const { now } = this;
      if (now && document.activeElement === now.range)
        this.show(now.place, now.key, now.range, now.control, state);
    }

    leave() {
      this.turn += 1;
      if (!this.now) return;
      this.now.place.hidden = true;
      this.now.key.hidden = true;
      this.now = null;
    }
  }

  Object.assign(play, { Region, kinds_of, key_of, kinds });
})();
