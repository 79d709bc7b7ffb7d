/// Sunlight through clear air: the radiance of the sky in each direction, and of the sun.
#pragma once

#include "rtcore/math/colour.h"

#include <array>

namespace rtcore {

/// Luminance of the clear sky, cd/m^2, as linear sRGB: luminance() of a colour is that. Not below zero.
/// Its colours and their distribution are those of Preetham, Shirley and Smits, "A Practical Analytic Model
/// for Daylight", SIGGRAPH 1999, appendix 2; as a whole it is as bright as skyIlluminance() says, since the
/// paper's sky is about twice as bright as measured ones. Of a sun below the horizon the sky is that of
/// sunset, darker by a factor of ten for each 2.5 degrees, which is roughly what is measured until the sun is
/// 12 degrees below.
///
/// Immutable; safe from many threads. The same bits on every processor.
class ClearSky {
  public:
    /// Sine of the sun's elevation, -1..1; turbidity kMinTurbidity..kMaxTurbidity.
    ClearSky(float sinElevation, float turbidity);

    /// Values that depend on the height of a direction alone; `cosZenith` > 0.
    struct Height {
        std::array<float, 3> part;
    };
    Height height(float cosZenith) const;
    /// In a direction of that height, `cosSun` the cosine of its angle to the sun, or to the point of the
    /// horizon below which the sun is.
    Colour luminance(const Height& height, float cosSun) const;

  private:
    struct Perez {
        float a, b, c, d, e;
        float scale; ///< of the formula
        /// The factor that depends on the angle to the sun, in radians.
        float aroundSun(float angle, float cosine) const;
    };
    float levelIlluminance(float sun) const;
    std::array<Perez, 3> perez_; ///< Y, x, y
};

/// Illuminance, lux as linear sRGB, on a surface that faces the sun: sunlight (Planck, 5778 K) less what air,
/// haze and ozone take (the same paper, appendix 1, without gases and water vapour, which take below 1 % of
/// what is seen). Falls to nothing while the sun's disc sets. `sinElevation` -1..1.
Colour sunIlluminance(float sinElevation, float turbidity);

/// Illuminance, lux, of the sky without the sun on level ground: what air and haze scatter downwards of what
/// they take of the sun (Bird and Hulstrom, "A Simplified Clear Sky Model for Direct and Diffuse Insolation
/// on Horizontal Surfaces", SERI/TR-642-761, 1981, for each wavelength). `sinElevation` 0..1.
float skyIlluminance(float sinElevation, float turbidity);

} // namespace rtcore
