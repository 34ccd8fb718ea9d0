// From where the grasp is seen: an orthographic projection that can be turned.
(() => {
  const { dot, cross, scale, add, unit, turned } = drawing.vectors;

  /// Directions of the scene that point right, up and out of the picture. y is up, if it can be.
  const fixed = {
    front: { right: [1, 0, 0], up: [0, 1, 0] },
    top: { right: [1, 0, 0], up: [0, 0, -1] },
    side: { right: [0, 0, -1], up: [0, 1, 0] },
    things: { right: unit([0.86, 0, -0.51]), up: unit([-0.18, 0.94, -0.3]) },
  };

  class View {
    constructor(name = 'front') { this.choose(name); }

    choose(name) {
      this.name = name;
      const { right, up } = fixed[name];
      this.right = right;
      this.toward = unit(cross(right, up));
      this.up = cross(this.toward, right);
    }

    /// By angles about the picture's axes, in rad.
    turn(about_up, about_right) {
      const by = add(scale(this.up, about_up), scale(this.right, about_right));
      const back = scale(by, -1); // the grasp turns, the eye the other way
      this.right = unit(turned(this.right, back));
      this.toward = unit(cross(this.right, turned(this.up, back)));
      this.up = cross(this.toward, this.right);
      this.name = '';
    }

    flat(v) { return [dot(this.right, v), -dot(this.up, v)]; }
    depth(v) { return dot(this.toward, v); }
    /// The direction of the scene that is (x, y) in the picture, y down.
    lifted([x, y]) { return add(scale(this.right, x), scale(this.up, -y)); }
  }

  play.View = View;
})();
