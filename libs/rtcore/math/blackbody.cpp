#include "rtcore/math/blackbody.h"

#include <algorithm>

namespace rtcore {

namespace {

struct Cubic {
    double c3, c2, c1, c0;
    double operator()(double x) const { return ((c3 * x + c2) * x + c1) * x + c0; }
};

constexpr Cubic kCoolX{-0.2661239, -0.2343589, 0.8776956, 0.179910}; ///< up to 4000 K; of 1000 / kelvin
constexpr Cubic kHotX{-3.0258469, 2.1070379, 0.2226347, 0.240390};
constexpr Cubic kCoolY{-1.1063814, -1.34811020, 2.18555832, -0.20219683}; ///< up to 2222 K; of x
constexpr Cubic kWarmY{-0.9549476, -1.37418593, 2.09137015, -0.16748867}; ///< up to 4000 K
constexpr Cubic kHotY{3.0817580, -5.87338670, 3.75112997, -0.37001483};

} // namespace

Chromaticity blackbodyChromaticity(double kelvin) {
    constexpr double kWarm = 2222, kHot = 4000, kThousand = 1000;
    const double t = std::clamp(kelvin, kMinTemperature, kMaxTemperature);
    const double x = (t < kHot ? kCoolX : kHotX)(kThousand / t);
    return {x, (t < kWarm ? kCoolY : t < kHot ? kWarmY : kHotY)(x)};
}

Colour blackbodyColour(float kelvin) {
    const auto [x, y] = blackbodyChromaticity(static_cast<double>(kelvin));
    const double bigX = x / y, bigZ = (1 - x - y) / y;
    // From XYZ to the primaries of sRGB (IEC 61966-2-1).
    const auto channel = [](double value) { return static_cast<float>(std::max(value, 0.0)); };
    const Colour colour{channel(3.2406 * bigX - 1.5372 - 0.4986 * bigZ),
                        channel(-0.9689 * bigX + 1.8758 + 0.0415 * bigZ),
                        channel(0.0557 * bigX - 0.2040 + 1.0570 * bigZ)};
    return colour / luminance(colour);
}

} // namespace rtcore
