// Puts the page together and offers window.lcpush to tests.
(() => {
  const { h, by_id, parsed } = drawing.elements;

  const margin = 20; // pixels about a motion

  function warn(message) {
    by_id('failure').hidden = false;
    by_id('failure').textContent = message;
  }

  class Application {
    /// `linked`: a scene from the address, or nothing.
    constructor(module, own, linked) {
      const text = linked || own;
      this.solver = new play.Solver(module);
      this.background = new play.Background(module);
      this.region = new play.Region(this.background);
      this.reach = new play.Reach(this);
      this.view = new play.View();
      this.history = new play.History(text);
      this.controls = new play.Controls((changed, is_done) => this.change(changed, is_done),
        this.region);
      this.motion = new play.Motion(this);
      this.hands = new play.Hands(this);
      this.listen();
      this.wanted = text;
      this.solve(true);
      if (this.state || !linked) return;
      // The page's own scene stands for one that is none.
      this.history = new play.History(own);
      this.go(own);
      this.change(linked, true);
    }

    listen() {
      const click = (id, act) => by_id(id).addEventListener('click', act);
      click('undo', () => this.go(this.history.undo()));
      click('redo', () => this.go(this.history.redo()));
      document.addEventListener('keydown', (event) => {
        if (!(event.ctrlKey || event.metaKey) || event.target.matches('textarea, input')) return;
        const key = event.key.toLowerCase();
        if (key !== 'z' && key !== 'y') return;
        event.preventDefault();
        this.go(key === 'y' || event.shiftKey ? this.history.redo() : this.history.undo());
      });
      for (const button of document.querySelectorAll('[data-view]'))
        button.addEventListener('click', () => {
          this.view.choose(button.dataset.view);
          if (this.motion.shown === null) this.meters = null;
          this.draw_again();
        });
      by_id('text').addEventListener('change', () => this.replace(by_id('text').value));
      for (const id of ['text', 'contacts'])
        by_id(id).closest('details').addEventListener('toggle', () => this.fill_open());
      click('pivots', async () => {
        play.links.say('tracing the pivots ..');
        play.links.say(await play.explore(this.background, `pivots ${this.motion.seconds()}`,
          this.wanted));
      });
      click('close', () => by_id('explorer').close());
      // The next one opens on an empty frame, never on these pivots.
      by_id('explorer').addEventListener('close', () => { by_id('frame').srcdoc = ''; });
      click('link', async () => play.links.say(await play.links.copy('scene', this.wanted)));
      click('save-scene', () => play.links.save('scene.toml', 'text/plain', this.wanted));
      click('save-answer', () =>
        play.links.save('answer.json', 'application/json', this.state.written));
      click('save-picture', () =>
        play.links.save('grasp.svg', 'image/svg+xml', play.links.picture()));
      window.addEventListener('hashchange', async () => {
        const { scene, broken } = await play.links.carried();
        if (scene && scene !== this.wanted) this.replace(scene);
        if (broken) warn(broken);
      });
    }

    /// Another text than the controls were made for.
    replace(text) {
      if (this.view.name) this.view.choose(this.view.name); // where gravity pulls down in that one
      this.controls.forget();
      this.change(text, true);
    }

    /// Undo's and redo's: another text that is in the history already.
    go(text) {
      this.controls.forget();
      this.wanted = text;
      this.solve(true);
    }

    /// While a hand drags, once a frame; when it is done, in full.
    change(text, is_done) {
      this.wanted = text;
      if (is_done) {
        this.history.push(text);
        this.solve(true);
        return;
      }
      if (this.due) return;
      this.due = requestAnimationFrame(() => {
        this.due = null;
        this.solve(false);
      });
    }

    solve(in_full) {
      if (this.due) cancelAnimationFrame(this.due);
      this.due = null;
      const text = this.wanted;
      const begin = performance.now();
      try {
        this.in_full = in_full;
        const look = JSON.stringify({ ...this.look(), meters: this.hands.held ? this.meters : null });
        this.read(text, this.solver.ask(`${in_full ? 'solve' : 'drag'} ${look}`, text));
      } catch (refusal) {
        this.refuse(refusal.message);
        if (!(refusal instanceof play.Refusal)) throw refusal;
        return;
      } finally {
        this.took = performance.now() - begin;
        this.buttons();
      }
      if (!in_full) return;
      this.find_breaking(text);
      this.region.again(this.state);
    }

    read(text, reply) {
      const { answer, sentence, scene, grip_margin, is_bound, ...drawn } = JSON.parse(reply);
      const written = reply.slice(reply.indexOf('{', 1), reply.indexOf('\n, "sentence": ') + 1);
      this.motion.forget();
      this.background.drop('pivots');
      this.state = { text, answer, scene, written, sentence, grip_margin, is_bound, in_full: this.in_full };
      by_id('failure').hidden = true;
      for (const id of ['sentence', 'picture', 'facts']) by_id(id).classList.remove('stale');
      const title = scene.title || 'lcpush playground';
      if (by_id('title').textContent !== title) {
        by_id('title').textContent = title;
        document.title = `${scene.title || 'Playground'} \u2013 lcpush`;
      }
      by_id('sentence').textContent = this.state.sentence;
      by_id('checks').replaceChildren(...answer.warnings.map((warning) =>
        h('li', {}, `Check line ${warning.line}: ${warning.text}.`)));
      this.fill_open();
      play.facts.update(this.state, this.breaking?.text === text && this.breaking.answer);
      this.controls.update(this.state);
      this.show(drawn);
    }

    /// What is folded away is not written at every step of a hand.
    fill_open() {
      const is_open = (id) => by_id(id).closest('details').open;
      if (is_open('text') && document.activeElement !== by_id('text')) by_id('text').value = this.wanted;
      if (is_open('contacts') && this.state) play.facts.contacts(this.state.answer);
    }

    /// The last scene that was one stays, and the text can be mended.
    refuse(message) {
      warn(this.state ? `${message}\nBelow stands the last scene that has none of this.` : message);
      for (const id of ['sentence', 'picture', 'facts']) by_id(id).classList.add('stale');
      this.fill_open();
      if (!this.state) by_id('text').closest('details').open = true;
    }

    async find_breaking(text) {
      let answer;
      try {
        const reply = await this.background.ask('break', 'break', text);
        if (reply === null) return;
        ({ answer } = JSON.parse(reply));
      } catch (refusal) {
        answer = { refusal: refusal.message };
      }
      this.breaking = { text, answer };
      if (this.state.text === text) play.facts.update(this.state, answer);
    }

    /// From where the state is looked at; `moment` of its motion, if any.
    look(moment) {
      return { full: this.state?.in_full, ...this.view.wanted(), meters: this.meters, moment,
        letter: window.innerWidth < 900 ? 12.5 : 7.5, dots: moment ? [] : this.reach.dots };
    }

    draw(moment) {
      if (!this.state) return;
      this.show(JSON.parse(this.solver.ask(`look ${JSON.stringify(this.look(moment))}`,
        this.state.text)));
    }

    /// The picture as the solver drew it. Who has the focus keeps it.
    show({ picture, meters, ...directions }) {
      const box = by_id('picture');
      const focused = document.activeElement?.closest?.('#picture [data-body]')?.dataset.body;
      this.meters = meters;
      this.view.drawn(directions);
      parsed(box, picture);
      const find = (name) => [...box.querySelectorAll('[data-body]')]
        .find((element) => element.dataset.body === name);
      if (focused) find(focused)?.focus({ preventScroll: true });
      if (this.held) find(this.held)?.classList.add('held');
      for (const button of document.querySelectorAll('[data-view]'))
        button.setAttribute('aria-pressed', String(button.dataset.view === this.view.name));
    }

    /// The object will go so far [m], and may turn: all of that is to be seen, before it sets off.
    async make_room(way) {
      if (way * this.meters < margin) return; // the picture keeps its scale
      const { width, height } = by_id('picture').querySelector('svg').viewBox.baseVal;
      const most = (Math.min(width, height) / 2 - margin) / (way + this.state.scene.reach);
      const from = this.meters, to = Math.min(from, most);
      const moments = matchMedia('(prefers-reduced-motion: reduce)').matches ? 1 : 24;
      for (let k = 1; k <= moments && to < from; k += 1) {
        this.meters = from * (to / from) ** (k / moments);
        this.draw();
        await new Promise(requestAnimationFrame);
      }
    }

    /// A body in somebody's hand.
    hold(name) {
      this.held = name;
      if (name) this.reach.show(name);
      else this.reach.hide();
      this.redraw();
    }
    redraw() {
      if (this.motion.shown === null) this.draw();
    }
    turn(dx, dy) {
      if (!this.state) return;
      this.view.turn(dx, dy);
      this.draw_again();
    }
    /// What is shown, a moment of the motion or its begin, from where it is looked at now.
    draw_again() {
      if (this.motion.shown === null) this.draw();
      else this.motion.seek(this.motion.shown);
    }
    pixels_per_meter() {
      const { width } = by_id('picture').getBoundingClientRect();
      return this.meters * width / by_id('picture').querySelector('svg').viewBox.baseVal.width;
    }

    buttons() {
      by_id('undo').disabled = this.history.done.length < 2;
      by_id('redo').disabled = this.history.undone.length === 0;
      const is_shown = this.state?.text === this.wanted;
      for (const id of ['play', 'time', 'reset', 'pivots', 'save-answer', 'save-picture'])
        by_id(id).disabled = !is_shown;
    }
  }

  (async () => {
    try {
      const module = await WebAssembly.compile(play.unpack(by_id('solver').textContent));
      const { scene, lcp, at, broken } = await play.links.carried();
      if (!by_id('scene')) {
        if (broken) warn(broken);
        await play.raw.start(module, { lcp, at });
        return;
      }
      const given = document.createElement('textarea');
      given.innerHTML = by_id('scene').textContent; // undoes what made it safe in the page
      const app = new Application(module, given.value, scene);
      if (broken) warn(broken);
      window.lcpush = { app, play };
    } catch (problem) {
      warn(`This page needs a browser with WebAssembly (2023 or later): ${problem.message}`);
      throw problem;
    }
  })();
})();
