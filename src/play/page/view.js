// From where the grasp is seen: an orthographic projection that can be turned. Where its named views
// are, the solver says, for which gravity pulls down.
(() => {
  const { dot, cross, scale, add, unit, turned } = drawing.vectors;

  class View {
    constructor() { this.choose('front'); }

    choose(name) { Object.assign(this, { name, is_drawn: false }); }
    /// What is to be asked for.
    wanted() { return this.is_drawn ? { right: this.right, up: this.up } : { view: this.name }; }
    /// How it was drawn.
    drawn({ right, up }) { Object.assign(this, { right, up, is_drawn: true }); }

    /// By angles about the picture's axes, in rad.
    turn(about_up, about_right) {
      const by = add(scale(this.up, about_up), scale(this.right, about_right));
      const back = scale(by, -1); // the grasp turns, the eye the other way
      this.right = unit(turned(this.right, back));
      this.up = cross(unit(cross(this.right, turned(this.up, back))), this.right);
      Object.assign(this, { name: '', is_drawn: true });
    }

    flat(v) { return [dot(this.right, v), -dot(this.up, v)]; }
    /// The direction of the scene that is (x, y) in the picture, y down.
    lifted([x, y]) { return add(scale(this.right, x), scale(this.up, -y)); }
  }

  play.View = View;
})();
