/// The exposure of a film: measured at some of its frames beforehand, so that it does not jump from frame to
/// frame, and each part of the film has that of the whole.
#pragma once

#include "rtcore/motion/flight_course.h"
#include "rtcore/motion/monotone_track.h"

#include <span>
#include <vector>

namespace app {

/// What suits the view at one time of a flight.
struct MeasuredExposure {
    double time = 0;    ///< seconds
    float constant = 1; ///< the fixed constant c (.cam), above 0
};

/// The frames to be measured, in their order: about one a second, 61 at most, and all of a short film; 12 of
/// what is a turntable.
std::vector<int> framesToMeasure(const rtcore::FlightCourse& course, int frames);

/// Weighted means of what was measured, as an eye adapts: kAdaptation seconds before and after count for a
/// quarter. Between the measured times it is monotone. A turntable has one exposure all around, and what
/// else goes round goes on as it began. By the four operations and roots alone: the same bits everywhere.
class FilmExposure {
  public:
    static constexpr double kAdaptation = 1.5;

    /// At least one measurement, at times that rise.
    FilmExposure(std::span<const MeasuredExposure> measured, const rtcore::FlightCourse& course);

    float at(double time) const;

  private:
    rtcore::MonotoneTrack track_; ///< of 16th roots, whose means are nearly those of logarithms
};

} // namespace app
