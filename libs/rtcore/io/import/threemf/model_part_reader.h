/// Reads a model part of a 3MF package.
#pragma once

#include "rtcore/io/import/threemf/model_part.h"
#include "rtcore/io/import/threemf/package.h"

#include <string_view>

namespace rtcore::threemf {

/// Nothing of its numbers is trusted: corners of triangles exist; groups, entries and objects that are named
/// may not. Memory follows the bytes that are unpacked. Throws FileError BadData for what is no XML, as
/// Package::read() does, and std::bad_alloc.
PartContent readModelPart(Package& package, std::string_view name);

} // namespace rtcore::threemf
