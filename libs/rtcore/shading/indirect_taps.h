/// The points of waves that take light which surfaces send to each other, and the light of the surroundings:
/// both are looked up for all of them together, where they are known (rtcore/irradiance).
#pragma once

#include "rtcore/irradiance/irradiance_record.h"
#include "rtcore/math/colour.h"
#include "rtcore/shading/lobe_taps.h"
#include "rtcore/shading/surface/material_table.h"
#include "rtcore/shading/wave.h"

#include <cstdint>
#include <vector>

namespace rtcore {

struct IndirectTap {
    Receiver receiver;
    Colour factor;            ///< of the irradiance over pi: the part that reaches the sample
    std::uint32_t sample = 0; ///< of the wave of primary rays
    bool primary = false;     ///< it is the primary hit of its sample

    Colour light(Colour irradiance) const;
};

/// The size of pixels where a ray has come so far.
struct PixelSize {
    float atEye = 0, perLength = 0;
    float at(float length) const { return atEye + perLength * length; }
};

/// How points are collected.
struct TapRules {
    PixelSize pixel;
    std::uint32_t lobeRays = 1; ///< of each point with a narrow lobe
    float minLobe = 0;          ///< of the weight of a lobe in its sample; fainter ones count as matte
};

/// The points of waves that take indirect light.
struct IndirectTaps {
    std::vector<IndirectTap> matte; ///< all lobes but those of `lobes`
    std::vector<LobeTap> lobes;

    void clear() {
        matte.clear();
        lobes.clear();
    }
    /// Appends the points of a wave whose light has been divided.
    void add(const MaterialTable& materials, const Wave& wave, const TapRules& rules);
};

} // namespace rtcore
