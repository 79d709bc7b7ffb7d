/// Light on a horizontal grid over the floor of a storey.
#pragma once

#include "rtserver/document/light_measuring.h"
#include "rtserver/document/measuring.h"

#include "rtcore/math/vec.h"

#include <span>
#include <string>
#include <vector>

namespace rtserver {

struct GridRequest {
    rtcore::Vec3 eye;     ///< whose floor, the first surface below, is that of the storey
    double height = 0.85; ///< over that floor, metres
    double spacing = 0.5; ///< between points, metres; above 0
};

/// Points over the model without its surroundings, whose middle is that of the grid, that look upwards: those
/// with a floor below that lies within 0.3 m of the storey's, or something that stands on it; under a roof,
/// if the eye is; and not in solids, whose surfaces are closed or
/// show their backs to all four sides, unless the eye is in one. Row by row, along the
/// first of the two level axes. Throws rtcore::Refusal where there is no such floor or no such point, or too
/// many of them.
std::vector<rtcore::WhitePoint> gridPoints(const MeasuredScene& measured, const GridRequest& request);

/// Measures them one after another and tells how far it is. Throws what Photometer throws.
std::vector<rtcore::MeasuredLight>
measureGrid(Photometer& photometer, std::span<const rtcore::WhitePoint> points, Measuring& measuring);

/// x,y,z,lux,standard_error: a line each, with the coordinates of the model's file.
std::string gridTable(std::span<const rtcore::WhitePoint> points,
                      std::span<const rtcore::MeasuredLight> light, const rtcore::Scene& scene);
/// "120 points, mean 412 lx, min 33 lx, max 1200 lx, uniformity 0.08": min over mean.
std::string gridText(std::span<const rtcore::MeasuredLight> light);

} // namespace rtserver
