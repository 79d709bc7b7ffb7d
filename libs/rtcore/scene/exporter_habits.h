/// The defaults of programs that write models, and the conventions of formats.
#pragma once

#include "rtcore/platform/sentence.h"
#include "rtcore/scene/model_origin.h"

#include <array>
#include <string>

namespace rtcore {

enum class LengthUnit { Metre, Centimetre, Millimetre, Inch, Foot };
inline constexpr std::size_t kLengthUnits = 5;
inline constexpr std::array<double, kLengthUnits> kMetresIn{1, 0.01, 0.001, 0.0254, 0.3048};

/// Natural logarithms of odds: 0 says nothing, 1 is a hint, 3 all but sure.
struct OriginHabits {
    double zUp = 0; ///< for +z against +y
    /// Against each other; by LengthUnit.
    std::array<double, kLengthUnits> units{};
    Sentence name; ///< of the program, or else of the format: "OpenSCAD", "STL files"
};

/// Never fails: of an unknown program and format nothing is sure.
OriginHabits habitsOf(const ModelOrigin& origin);

} // namespace rtcore
