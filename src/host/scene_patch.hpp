// The keys of a [[finger]] or [[pusher]] that say where it touches the object.
#pragma once

#include "lcpush/types.hpp"
#include "table_reader.hpp"

#include <vector>

namespace lcpush::host {

/// A contact patch in the scene's frame.
struct Patch {
  Vector3<double> normal;  ///< unit, into the object
  Vector3<double> tangent; ///< unit, orthogonal to the normal
  std::vector<Vector3<double>> positions;
};

/// The keys of every shape, and of the contact frame.
const Schema& patch_schema();

/// Reads and samples the patch: one point or more, no two coincident, all in one contact plane.
Patch read_patch(const TableReader& table);

} // namespace lcpush::host
