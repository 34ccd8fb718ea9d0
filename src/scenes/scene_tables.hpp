// What the builder reads of a table: [object], and where a [[finger]] or [[pusher]] touches it.
#pragma once

#include "lcpush/desktop/scene_io.hpp"
#include "scenes/table_reader.hpp"

#include <string>
#include <vector>

namespace lcpush::desktop {

/// A contact patch in the scene's frame.
template <class S> struct Patch {
  Vector3<S> normal;  ///< unit, into the object
  Vector3<S> tangent; ///< unit, orthogonal to the normal
  std::vector<Vector3<S>> positions;
  std::vector<std::string> inexact; ///< as SceneOf has it
};

/// Reads and samples the patch: one point or more, no two coincident, all in one contact plane.
/// S is double or Rational.
template <class S> Patch<S> read_patch(const TableReader& table);

/// Mass, inertia about the centre of mass, and the centre of mass; what it looks like to `shape`.
/// S is double or Rational.
template <class S> Object<S> read_object(const TableReader& table, ObjectShape& shape);

} // namespace lcpush::desktop
