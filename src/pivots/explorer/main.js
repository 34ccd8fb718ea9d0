// Puts the page together, and is window.lcpush.app to tests.
(() => {
  const { by_id } = drawing.elements;
  const { number_text, words } = explorer;

  class Application {
    constructor(trace) {
      this.problem = new explorer.Problem(trace);
      this.recorded = explorer.Path.recorded(this.problem);
      this.path = this.recorded;
      this.frame = 0;
      this.as_fractions = this.problem.exact && !(trace.prefers_decimals && trace.scene);
      this.guesses = { on: false, known: new Set(), tried: new Set(), right: 0 };
      this.branch_rule = 'lexicographic';
      this.show_large = true;
      this.covers = new Map();
      this.units_of_S = new Map();
    }

    start() {
      const { problem } = this;
      this.tableau = explorer.view_tableau.create(this);
      this.controls = explorer.controls.create(this);
      explorer.view_legend.create(this);
      const { trace } = problem;
      document.body.classList.toggle('with-scene', Boolean(trace.scene));
      const title = trace.title || 'Lemke\u2019s method, pivot by pivot';
      document.title = `${title} \u2013 lcpush`;
      by_id('title').textContent = title;
      const notes = trace.notes || [];
      by_id('notes').hidden = notes.length === 0;
      by_id('notes').append(...notes.map((note) => drawing.elements.h('li', {}, note)));
      by_id('arithmetic').hidden = !problem.exact;
      by_id('as-fractions').checked = this.as_fractions;
      by_id('as-fractions').addEventListener('change', (event) => {
        this.as_fractions = event.target.checked;
        this.update(false);
      });
      by_id('guess').addEventListener('change', (event) => this.guess_first(event.target.checked));
      by_id('room').addEventListener('click', () => this.toggle_room());
      if (!this.read_address()) this.update(true);
      let width = window.innerWidth;
      window.addEventListener('resize', () => {
        if (width === window.innerWidth) return; // a phone's bars come and go
        width = window.innerWidth;
        this.update(false);
      });
    }

    /// The cover d of a run, as doubles: the column of z0 with all w basic.
    cover(run) {
      if (!this.covers.has(run)) {
        const given = explorer.certificate.as_given(this.recorded, run);
        const n = this.problem.size;
        this.covers.set(run, [...Array(n).keys()].map((i) =>
          this.problem.number(given.entry(i, n))));
      }
      return this.covers.get(run);
    }

    /// A run may be scaled: its number of the variable times this is in SI units.
    unit(run, variable) {
      const { units } = this.problem.trace.runs[run];
      return units && units[variable] ? units[variable] : 1;
    }

    /// What the run's S is in m/s^2. In a normal's row, S stands with the speed at which the
    /// actuators close on that contact.
    unit_of_S(run) {
      if (this.problem.levels === 1) return 1;
      if (!this.units_of_S.has(run)) {
        const { scene } = this.problem.trace;
        const { dot, subtract } = drawing.vectors;
        const given = explorer.certificate.as_given(this.recorded, run);
        let [best, unit] = [0, 1];
        for (const point of scene.points) {
          const { normal, actuators } = scene.bodies[point.body];
          const arm = subtract(point.position, scene.center_of_mass);
          const speed = actuators.reduce((sum, { twist }) =>
            sum + dot(normal, explorer.mechanics.at_point(twist, arm)), 0);
          if (Math.abs(speed) <= best) continue;
          best = Math.abs(speed);
          unit = this.problem.number(given.value(point.normal)[0])
            * this.unit(run, point.normal) / speed;
        }
        this.units_of_S.set(run, unit);
      }
      return this.units_of_S.get(run);
    }

    go(frame) {
      const wanted = Number.isFinite(frame) ? Math.round(frame) : this.frame;
      this.frame = Math.max(0, Math.min(this.path.last, wanted));
      this.write_address();
      this.update(true);
    }

    branch(row, rule = this.branch_rule) {
      this.controls.stop();
      this.path = this.path.branch_at(this.frame, row, rule);
      this.go(this.frame + 1);
      by_id('return').focus(); // the button that was pressed is gone
    }

    /// To where the recorded path was left, also from a branch of a branch.
    return_to_recorded() {
      const leaving = (path, frame) => path.step(frame)?.leaving;
      const most = Math.min(this.path.last, this.recorded.last);
      let common = 0;
      while (common < most && leaving(this.path, common) === leaving(this.recorded, common))
        common += 1;
      this.path = this.recorded;
      this.go(common);
      by_id('forward').focus();
    }

    /// Is the row that leaves still to be guessed?
    asks() {
      return this.guesses.on && !this.path.branch && this.path.step(this.frame) !== null
        && !this.guesses.known.has(this.frame);
    }

    guess_first(on, frame = this.frame) {
      Object.assign(this.guesses, { on, known: new Set(), tried: new Set(), right: 0 });
      by_id('guess').checked = on;
      this.go(frame);
    }

    /// A row is right if it leaves, or ties with the one that does. Only a first guess counts.
    guess(row, is_right) {
      const { known, tried } = this.guesses;
      if (is_right && !tried.has(this.frame)) this.guesses.right += 1;
      tried.add(this.frame);
      if (!is_right) return;
      known.add(this.frame);
      this.update(true);
    }

    /// Large letters, and the full screen where a page may have it.
    toggle_room() {
      const on = document.body.classList.toggle('room');
      by_id('room').setAttribute('aria-pressed', String(on));
      if (on) document.documentElement.requestFullscreen?.().catch(() => {});
      else if (document.fullscreenElement) document.exitFullscreen();
      this.update(true);
    }

    summary() {
      const { trace } = this.problem;
      const shown = this.problem.exact && !this.as_fractions ? ', shown as decimals' : '';
      return [words.many(this.problem.size, 'unknown'), words.many(trace.pivots.length, 'pivot'),
        words.status_words[trace.status] || trace.status, `in ${trace.arithmetic}${shown}`,
        words.rule_words[trace.rule] || trace.rule].join(' \u00b7 ');
    }

    /// A value by level for people, as they want to see it.
    text(levels) { return number_text.value(this.problem, levels, this.as_fractions); }

    /// #step=7 links to a step of the recorded path.
    write_address() {
      if (this.path.branch) return;
      this.address = `#step=${this.frame}${this.guesses.on ? '&guess' : ''}`;
      try {
        history.replaceState(null, '', this.address);
      } catch {
        // A page in a sandbox may not touch its address; then steps cannot be linked.
      }
    }

    read_address() { return location.hash !== this.address && this.open_at(location.hash); }

    /// As an address says; false if it says nothing.
    open_at(address) {
      const step = /[#&]step=(\d+)/.exec(address);
      if (!step) return false;
      this.path = this.recorded;
      this.controls.stop();
      this.guess_first(address.includes('&guess'), Number(step[1]));
      return true;
    }

    update(changed) {
      by_id('summary').textContent = this.summary();
      const { on, tried, right } = this.guesses;
      by_id('tally').textContent = on ? `${right} of ${tried.size} right at the first guess` : '';
      document.body.classList.toggle('on-branch', this.path.branch !== null);
      by_id('step').textContent = this.path.where(this.frame);
      explorer.view_sentence.update(this);
      this.tableau.update(changed);
      explorer.view_pairs.update(this);
      explorer.view_cones.update(this);
      explorer.view_chart.update(this);
      explorer.view_outcome.update(this);
      explorer.view_scene_text.update(this);
      this.controls.update();
    }
  }

  try {
    const app = new Application(JSON.parse(by_id('trace').textContent));
    window.lcpush = { app };
    app.start();
  } catch (problem) {
    const box = by_id('failure');
    box.hidden = false;
    box.textContent = `This page cannot show its data: ${problem.message}`;
    throw problem;
  }
})();
