// The push goes on: steps of `move`, shown as they go.
(() => {
  const { by_id } = drawing.elements;
  const { decimal } = drawing.numbers;
  const { length } = drawing.vectors;
  const frames = 201;
  const duration = 4000; // ms for the whole motion

  class Motion {
    /// `app`: state, background, view, draw(moment).
    constructor(app) {
      Object.assign(this, { app, shown: null });
      by_id('play').addEventListener('click', () => (this.playing ? this.pause() : this.start()));
      by_id('reset').addEventListener('click', () => this.reset());
      by_id('time').addEventListener('input', () => {
        this.pause();
        this.seek(Number(by_id('time').value));
      });
    }

    /// Another scene: what was computed is none of its.
    forget() {
      if (!this.playing && !this.run && !by_id('motion').textContent) return;
      this.run = null;
      this.rewind();
    }

    rewind() {
      this.app.background.drop('move');
      this.show_playing(false);
      this.shown = null;
      by_id('time').value = 0;
      by_id('clock').textContent = '';
      if (!this.run) by_id('motion').textContent = '';
    }

    /// How far the push has gone that is shown.
    seconds() { return this.shown ? this.run.answer.frames[this.shown].time : 0; }

    async load() {
      const { text } = this.app.state;
      if (this.run?.text === text) return true;
      by_id('motion').textContent = 'following the push ..';
      try {
        const reply = await this.app.background.ask('move', `move 0 ${frames}`, text);
        if (reply === null || this.app.state.text !== text) return false;
        const { answer, sentence, poses } = JSON.parse(reply);
        const forces = answer.frames.slice(1).flatMap(({ bodies }) => bodies.map(({ force }) => force));
        this.run = { text, answer, poses, forces };
        by_id('time').max = answer.frames.length - 1;
        by_id('motion').textContent = sentence;
        if (answer.frames.length < 2) return false;
        await this.app.make_room(Math.max(...answer.frames.map(({ position }) => length(position))));
      } catch (refusal) {
        by_id('motion').textContent = refusal.message;
        return false;
      }
      return this.run?.text === text; // none, where the scene changed meanwhile
    }

    async start() {
      this.show_playing(true);
      if (!await this.load() || !this.playing) {
        this.pause();
        return;
      }
      const last = this.run.answer.frames.length - 1;
      const from = Number(by_id('time').value) < last ? Number(by_id('time').value) : 0;
      const begin = performance.now();
      const step = (now) => {
        if (!this.playing) return;
        const at = Math.min(last, from + Math.max(0, now - begin) / duration * last);
        this.seek(Math.round(at));
        if (at < last) requestAnimationFrame(step);
        else this.pause();
      };
      requestAnimationFrame(step);
    }

    show_playing(playing) {
      this.playing = playing;
      by_id('play').setAttribute('aria-pressed', String(playing));
      by_id('play').textContent = playing ? 'Pause' : 'Play the push';
    }
    pause() { this.show_playing(false); }

    reset() {
      this.rewind();
      this.app.draw();
    }

    async seek(wanted) {
      if (!await this.load()) return;
      const { answer, poses, forces } = this.run;
      const k = Math.min(wanted, answer.frames.length - 1); // it may end before its time
      const frame = answer.frames[k];
      by_id('time').value = k;
      by_id('clock').textContent = `${decimal(frame.time)} s`;
      by_id('time').setAttribute('aria-valuetext', `after ${decimal(frame.time)} s`);
      this.shown = k;
      // A step that sets everything going at once, or ends it, would dwarf the others.
      const sizes = forces.map((force) => length(this.app.view.flat(force))).sort((a, b) => a - b);
      const most_force = sizes[Math.floor(0.95 * sizes.length)] || 1e-9;
      const bodies = frame.bodies.map(({ force, normal_force }, b) => {
        const at = 4 * (k * frame.bodies.length + b);
        const [position, columns, middle, normal] = poses.slice(at, at + 4);
        const presses = k > 0 && length(normal) > 0;
        return { position, columns, middle, normal, force, normal_force: presses ? normal_force : null };
      });
      const path = answer.frames.slice(0, k + 1).flatMap(({ position }) => position);
      this.app.draw({ position: frame.position, rotation: frame.rotation, bodies, most_force, path });
    }
  }

  play.Motion = Motion;
})();
