// The keys of a [[finger]] or [[pusher]] that say where it touches the object.
#pragma once

#include "lcpush/types.hpp"
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

} // namespace lcpush::desktop
