// The table [object] of a scene file.
#pragma once

#include "lcpush/desktop/scene_io.hpp"
#include "scenes/table_reader.hpp"

namespace lcpush::desktop {

/// Mass, inertia about the centre of mass, and the centre of mass; what it looks like to `shape`.
/// S is double or Rational.
template <class S> Object<S> read_object(const TableReader& table, ObjectShape& shape);

} // namespace lcpush::desktop
