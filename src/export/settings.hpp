// The numbers of this room.
#pragma once

namespace lcpush::desktop {

struct ExportSettings {
  /// Of the object's size: balls that stand for contact points. An object turns about the ball's
  /// middle, not its edge: ten times as large, a block that tips is 1.3 % too slow.
  double ball = 0.002;
  /// Of the object's size: half a plate's side. Canonical motions go 40 sizes far.
  double plate = 100;
  /// Of the object's mass: a body that moves as prescribed, whatever presses on it; it gives way by
  /// so little.
  double heavy = 1e5;
  /// Of the object's mass: a finger without an inertia, which no engine takes. Lighter ones sink
  /// into soft contacts: of MuJoCo the depth is force over mass.
  double finger = 1;
  /// SDF's engines take the smaller of two frictions: the object's is above any body's.
  double object_friction = 1e6;
  /// The most bodies whose collisions 16 bits of SDF tell apart.
  int bodies = 16;
};

} // namespace lcpush::desktop
