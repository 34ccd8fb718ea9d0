// The table [object] of a scene file.
#pragma once

#include "lcpush/host/scene_io.hpp"
#include "table_reader.hpp"

namespace lcpush::host {

const Schema& object_schema();

/// Mass, inertia about the centre of mass, and the centre of mass; what it looks like to `shape`.
/// S is double or Rational.
template <class S> Object<S> read_object(const TableReader& table, ObjectShape& shape);

} // namespace lcpush::host
