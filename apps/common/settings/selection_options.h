/// Reads the options of selectionOptionGroup(), and does what they say.
#pragma once

#include "common/cli/command_line.h"
#include "common/settings/section_options.h"

#include "rtcore/scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace app {

/// Which parts are seen, what is cut open and which lights are on, in place of what the scene says.
struct Selection {
    struct Part {
        std::string text; ///< as numbersNamed() takes it
        bool hide = true;
    };
    std::vector<std::string> isolated; ///< these alone; empty: no change
    std::vector<Part> parts;           ///< then, in order
    SectionChoice sections;
    std::vector<std::string> uncut;    ///< parts that sections leave whole, beside those of the scene
    std::optional<std::string> lights; ///< "all", "none", or names and ids, parted by commas
};

Selection readSelection(const Arguments& arguments);

/// `scene` may be a copy of another scene, or be copied later. Both throw UsageError where the scene has no
/// such part or light; the message names some that it has.
void selectParts(const Selection& selection, rtcore::Scene& scene);
/// The lights must be numbered. After what a .cam says of them, which it overrules.
void selectLights(const Selection& selection, rtcore::Scene& scene);

} // namespace app
