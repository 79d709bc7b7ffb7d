/// The colour of black bodies.
#pragma once

#include "rtcore/math/colour.h"

namespace rtcore {

/// Kelvin: what blackbodyColour() is made for. A candle has 1900, a bulb 2700, the sun 5800, an overcast sky
/// 6500.
inline constexpr double kMinTemperature = 1667, kMaxTemperature = 25000;

/// CIE 1931 chromaticity.
struct Chromaticity {
    double x = 0, y = 0;
};

/// The chromaticity of a black body of that temperature, within the limits above; off by 0.001 at most. Cubic
/// splines of Kim et al., US patent 7024034 (2006), as Kang et al., "Design of Advanced Color Temperature
/// Control System for HDTV Applications", J. Korean Phys. Soc. 41 (2002), gives them.
Chromaticity blackbodyChromaticity(double kelvin);

/// Its linear colour of luminance 1; what is outside of the primaries (blue below 1900 K) is 0. The same bits
/// on every processor.
Colour blackbodyColour(float kelvin);

} // namespace rtcore
