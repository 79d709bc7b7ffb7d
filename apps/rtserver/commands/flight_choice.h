/// The flights of the scene, as their commands change them.
#pragma once

#include "rtserver/commands/command_call.h"

#include "rtcore/scene/flight.h"

#include <string>

namespace rtserver {

/// Throws rtcore::Refusal where none is called so.
const rtcore::Flight& flightNamed(const Call& call, const std::string& name);

/// Puts it in the place of that which was called so; as the last one, where there is none. Throws
/// rtcore::BadValue where it has a problemOf(), rtcore::Refusal where there are too many.
void putFlight(Document& document, const std::string& formerName, rtcore::Flight flight);

/// The view, as a key frame has it.
rtcore::Camera shownCamera(const Call& call);

} // namespace rtserver
