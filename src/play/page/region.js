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

  /// "sticks up to 0.31, slips above": the bands for those who do not see them.
  function told(values, found) {
    const bands = [];
    found.forEach((kind, k) => {
      if (bands.at(-1)?.kind === kind) bands.at(-1).to = values[k];
      else bands.push({ kind, from: values[k], to: values[k] });
    });
    const text = (x) => drawing.numbers.decimal(x);
    return bands.map(({ kind, from, to }) =>
      `${text(from)} to ${text(to)}: ${kinds[kind] || 'no scene'}`).join('; ');
  }

  class Region {
    constructor(background) { Object.assign(this, { background, turn: 0 }); }

    /// Below the slider `range` of `control`, in the scene of `state`.
    async show(place, key, range, control, state) {
      this.now = { place, key, range, control };
      this.turn += 1;
      const { turn } = this;
      const [least, most] = [Number(range.min), Number(range.max)];
      const values = [...Array(samples).keys()].map((k) =>
        least + (most - least) * (k + 0.5) / samples);
      const found = [];
      for (const value of values) {
        let kind = 'none';
        try {
          const reply = await this.background.ask('region', 'drag', control.write(state, value));
          if (turn !== this.turn || reply === null) return;
          kind = kind_of(JSON.parse(reply).answer);
        } catch {
          if (turn !== this.turn) return;
        }
        found.push(kind);
      }
      place.replaceChildren(...found.map((one) => h('i', { class: one })));
      place.hidden = false;
      const seen = Object.keys(kinds).filter((one) => found.includes(one));
      key.replaceChildren(...seen.map((one) =>
        h('span', {}, h('i', { class: one }), kinds[one])));
      key.hidden = false;
      range.setAttribute('aria-description', told(values, found));
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

  Object.assign(play, { Region, kind_of, kinds });
})();
