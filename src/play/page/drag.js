// Taking bodies and the view by mouse, touch and keys.
(() => {
  const { by_id } = drawing.elements;
  const { scale } = drawing.vectors;

  const keys = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

  const body_at = ({ target }) => target.closest?.('[data-body]')?.dataset.body;

  class Hands {
    /// `app`: state, view, pixels_per_meter(), change(text, is_done), turn(dx, dy).
    constructor(app) {
      this.app = app;
      const box = by_id('picture');
      box.addEventListener('pointerdown', (event) => this.take(event));
      box.addEventListener('pointermove', (event) => this.carry(event));
      for (const end of ['pointerup', 'pointercancel'])
        box.addEventListener(end, (event) => this.leave(event));
      box.addEventListener('keydown', (event) => this.press(event));
      // A picture that is drawn anew takes the focus away to nowhere.
      box.addEventListener('focusout', ({ relatedTarget }) => {
        if (!relatedTarget || box.contains(relatedTarget)) return;
        this.app.reach.hide();
        this.app.redraw();
      });
    }

    take(event) {
      if (event.button > 0 || this.held) return;
      const body = body_at(event);
      by_id('picture').setPointerCapture(event.pointerId);
      const { state } = this.app;
      this.held = { body, pointer: event.pointerId, at: [event.clientX, event.clientY], state,
        names: body && play.edits.dragged_together(state, body, event.altKey) };
      this.app.hold(body);
    }

    carry(event) {
      const { held } = this;
      if (!held || held.pointer !== event.pointerId) return;
      const by = [event.clientX - held.at[0], event.clientY - held.at[1]];
      if (held.body) {
        const moved = this.app.view.lifted(scale(by, 1 / this.app.pixels_per_meter()));
        this.app.change(play.edits.dragged(held.state, held.names, moved), false);
        held.moved = true;
      } else {
        held.at = [event.clientX, event.clientY];
        this.app.turn(by[0] * 0.009, by[1] * 0.009);
      }
    }

    leave(event) {
      if (!this.held || this.held.pointer !== event.pointerId) return;
      const { moved } = this.held;
      this.held = null;
      this.app.hold(null);
      // Where it was let go; but where no scene is, as it was last.
      if (moved) this.app.change(this.app.due ? this.app.wanted : this.app.state.text, true);
    }

    press(event) {
      const by = keys[event.key];
      if (!by || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      const body = body_at(event);
      if (!body) {
        this.app.turn(by[0] * 0.1, by[1] * 0.1);
        return;
      }
      const { state, view } = this.app;
      const names = play.edits.dragged_together(state, body, event.altKey);
      const moved = view.lifted(scale(by, event.shiftKey ? 1e-4 : 1e-3));
      this.app.change(play.edits.dragged(state, names, moved), true);
      this.app.reach.show(body);
    }
  }

  play.Hands = Hands;
})();
