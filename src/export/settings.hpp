// The numbers of this room.
#pragma once

namespace lcpush::desktop {

struct ExportSettings {
  /// Of the object's size: balls that stand for contact points. An object turns about the ball's
  /// middle, not its edge: ten times as large, a block that tips is 1.3 % too slow.
  double ball = 0.002;
  /// Of the object's size: half a plate's side. Canonical motions go 40 sizes far.
  double plate = 100;
  /// Of the object's mass: a body that moves as prescribed, which a contact does not push back.
  double heavy = 1e7;
  /// 1/s: gain over mass of the servo that holds its speed; a step of an engine's 2 ms goes a fifth
  /// of the way.
  double servo = 100;
  /// Of the object's mass: a finger without an inertia, which no engine takes. Lighter ones sink
  /// into soft contacts: of MuJoCo the depth is force over mass, and with a thousandth of it
  /// `beyond_the_grip` goes 59 % too little.
  double finger = 1;
  /// SDF's engines take the smaller of two frictions: the object's is above any body's.
  double object_friction = 1e6;
  /// The most bodies whose collisions 16 bits of SDF tell apart.
  int bodies = 16;
};

} // namespace lcpush::desktop
