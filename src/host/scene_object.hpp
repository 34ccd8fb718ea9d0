// The table [object] of a scene file.
#pragma once

#include "lcpush/mechanics/scene.hpp"
#include "table_reader.hpp"

namespace lcpush::host {

const Schema& object_schema();

/// Mass, inertia about the centre of mass, and the centre of mass.
Object<double> read_object(const TableReader& table);

} // namespace lcpush::host
