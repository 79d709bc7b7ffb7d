/// The unit of the light in an image.
#pragma once

namespace rtcore {

struct LuminanceUnit {
    float ofOne = 1;       ///< the luminance of a radiance of 1; above 0
    bool absolute = false; ///< in cd/m^2; else numbers can be compared within an image alone
    friend bool operator==(const LuminanceUnit&, const LuminanceUnit&) = default;
};

} // namespace rtcore
