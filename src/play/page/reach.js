// What would happen if a body stood elsewhere along its face: the push solved at many places, shown
// as dots while the body is held or has the focus.
(() => {
  const { by_id } = drawing.elements;
  const { add, subtract, scale, dot, length, unit } = drawing.vectors;
  const samples = 25;

  /// The direction along a body's face that runs most across the picture.
  function along(view, normal) {
    const in_face = (v) => subtract(v, scale(normal, dot(v, normal)));
    const [across, upward] = [in_face(view.right), in_face(view.up)];
    return unit(length(across) > 0.5 ? across : upward);
  }

  class Reach {
    /// `app`: state, view, background, redraw().
    constructor(app) { Object.assign(this, { app, turn: 0, dots: [] }); }

    /// Dots for the body `name`, from one end of the object to the other; null: none.
    async show(name) {
      this.turn += 1;
      const { turn, app } = this;
      const { state, view } = app;
      const body = state.scene.bodies.find((one) => one.name === name);
      if (!body) {
        this.dots = [];
        by_id('dot-key').replaceChildren();
        return;
      }
      const way = along(view, body.normal);
      const { middle } = body;
      const now = dot(subtract(middle, state.scene.center_of_mass), way);
      const half = 0.5 * dot(state.scene.shape.size, way.map(Math.abs)) || state.scene.reach;
      const names = play.edits.dragged_together(state, name, false);
      const by = (k) => scale(way, half * (2 * (k + 0.5) / samples - 1) - now);
      const found = await play.kinds_of(app.background, 'reach', samples,
        (k) => play.edits.dragged(state, names, by(k)), () => turn === this.turn);
      if (!found) return;
      this.dots = found.map((kind, k) =>
        ({ at: add(middle, by(k)), kind, words: play.kinds[kind] || 'no scene' }));
      by_id('dot-key').replaceChildren(`With ${name} there: `, ...play.key_of(found));
      app.redraw();
    }

    hide() { this.show(null); }
  }

  play.Reach = Reach;
})();
