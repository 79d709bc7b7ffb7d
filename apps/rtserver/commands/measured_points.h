/// Points and lengths that commands measure.
#pragma once

#include "rtserver/commands/command_call.h"

#include "rtcore/measures/snap.h"

#include <cstddef>
#include <optional>
#include <string>

namespace rtserver {

/// What a pointer catches at two arguments from that one on, 0..1 from the left and from the top. Throws
/// rtcore::Refusal where there is nothing.
rtcore::Snap snapOf(const Call& call, std::size_t argument);

/// Three arguments from that one on, in doubles: the coordinates of the model's file.
rtcore::Vec3d filePointAt(const Call& call, std::size_t argument);

double metresPerUnitOf(const Call& call);

/// A last line where the unit is guessed; else "".
std::string guessLine(const Call& call);

/// What the parts enclose that the texts stand for, in cubic scene units. Throws rtcore::Refusal where one is
/// open, and app::UsageError where there is none of that name.
double volumeNamed(const Call& call, std::span<const std::string> texts);

} // namespace rtserver
