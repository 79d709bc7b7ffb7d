/// Sorting the events of the exact builder.
#pragma once

#include "rtcore/accel/events.h"
#include "rtcore/scene/mesh.h"

#include <array>
#include <cstddef>

namespace rtcore {

/// Sorts events whose triangles already ascend among equal positions and kinds. `scratch` grows to the
/// largest number that it met, so that a thread can keep it.
void sortEvents(Event* events, std::size_t count, EventList& scratch);

/// Sorts events of which no two are equal, best a few; in any order.
void sortFewEvents(Event* events, std::size_t count);

/// The sorted events of all triangles along the three axes, numbered as they are in the mesh, whose bounds
/// are `bounds`. Makes OpenMP tasks when called inside a parallel region; the result does not depend on them.
std::array<EventList, 3> makeEvents(const Mesh& mesh, const Box3& bounds);

} // namespace rtcore
