/// The variants of a scene as a document keeps them.
#pragma once

#include "rtcore/io/text/scn.h"
#include "rtcore/io/variants/variant_switch.h"
#include "rtcore/settings/render_settings.h"
#include "rtcore/survey/model_units.h"

#include <memory>
#include <optional>
#include <string>

namespace rtserver {

/// Immutable in steps of undo. Scenes that are copied share what is large.
struct VariantBook {
    rtcore::SceneVariants all;
    std::string active;                               ///< is shown, as it was or edited since; "": none
    std::shared_ptr<const rtcore::VariantScene> base; ///< what they are variants of; never null
    friend bool operator==(const VariantBook&, const VariantBook&) = default;
};

std::shared_ptr<const rtcore::VariantScene> variantScene(const rtcore::Scene& scene,
                                                         const rtcore::RenderSettings& settings);

/// The variants of a file, which says the base: `scene` and `settings` become what is shown of it. Without
/// variants they stay, and there is no base yet.
VariantBook takeVariants(const std::optional<rtcore::SceneFile>& file, rtcore::Scene& scene,
                         rtcore::RenderSettings& settings);

/// With the base in other units.
VariantBook inUnits(VariantBook book, const rtcore::ModelUnits& units);

} // namespace rtserver
