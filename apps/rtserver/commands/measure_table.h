/// The kept measures of a scene as text.
#pragma once

#include "rtcore/scene/kept_measure.h"
#include "rtcore/scene/local_origin.h"

#include <cstddef>
#include <string>

namespace rtserver {

/// How all measures of a scene are told.
struct MeasureStyle {
    const rtcore::KeptMeasures& measures;
    double metresPerUnit;
    rtcore::LocalOrigin origin; ///< of the scene
};

/// "3 distance 2.350 m 0 0 0, 2.35 0 0 door" of the measure at that index: points in the coordinates of the
/// model's file; without a name nothing stands for it.
std::string measureLine(const MeasureStyle& style, std::size_t index);

/// A table as RFC 4180 has it, with a line of names: number, kind, name, value, unit, points. Values have ten
/// digits. A name that a table program would take for a formula has a ' before it.
std::string measureTable(const MeasureStyle& style);

} // namespace rtserver
