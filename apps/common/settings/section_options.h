/// Reads the options of selectionOptionGroup() that cut a scene open, and does what they say.
#pragma once

#include "common/cli/command_line.h"

#include "rtcore/scene/scene.h"

#include <optional>
#include <vector>

namespace app {

/// Planes in the coordinates of the model's file.
struct SectionChoice {
    struct Plane {
        rtcore::FilePoint point{};
        rtcore::Vec3 normal;
    };
    struct Box {
        rtcore::FilePoint lo{}, hi{};
    };
    std::vector<Plane> planes; ///< without these and a box those of the scene stay
    std::optional<Box> box;    ///< what is outside is taken away
    std::optional<rtcore::SectionLight> light;
    std::optional<rtcore::CapColours> caps;
};

/// Throws UsageError for what is no plane, and where there are more than kMaxSectionPlanes.
SectionChoice readSections(const Arguments& arguments);
void cutOpen(const SectionChoice& choice, rtcore::Scene& scene);

} // namespace app
