/// Cosines and sines of angles in degrees, the same bits on every processor, and back.
#pragma once

namespace rtcore {

/// cos of 0 <= degrees <= 180, evaluated in double; falls from 1 to -1, exactly 0 at 90.
float cosineOfDegrees(double degrees);

/// An angle with cosineOfDegrees(angle) == cosine for every float in [-1, 1] of at least 1e-7 in size or 0
/// (below: as near as doubles allow); the one with the fewest digits, as far as they are found. Clamps its
/// argument.
double degreesOfCosine(float cosine);

/// sin of half of 0 <= degrees <= 180, evaluated in double; rises from 0 to 1.
float sineOfHalf(double degrees);
/// An angle with sineOfHalf(angle) == sine for every float in [0, 1], as degreesOfCosine().
double degreesOfHalfSine(float sine);

} // namespace rtcore
