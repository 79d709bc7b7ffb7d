#include "rtserver/document/variant_book.h"

#include "rtcore/sky/scene_sky.h"

#include <utility>

namespace rtserver {

std::shared_ptr<const rtcore::VariantScene> variantScene(const rtcore::Scene& scene,
                                                         const rtcore::RenderSettings& settings) {
    return std::make_shared<const rtcore::VariantScene>(rtcore::VariantScene{scene, settings.skyLight.on});
}

VariantBook takeVariants(const std::optional<rtcore::SceneFile>& file, rtcore::Scene& scene,
                         rtcore::RenderSettings& settings) {
    if (!file || file->variants.empty()) return {};
    const auto base = variantScene(scene, settings);
    rtcore::VariantScene shown = *base;
    switchVariant(shown, *base, rtcore::SceneVariant(), shownVariant(*file));
    scene = std::move(shown.scene);
    settings.skyLight.on = shown.skyLight;
    return {file->variants, file->activeVariant, base};
}

VariantBook inUnits(VariantBook book, const rtcore::ModelUnits& units) {
    rtcore::VariantScene base = *book.base;
    base.scene.up = units.up;
    base.scene.metresPerUnit = units.metresPerUnit;
    straightenSky(base.scene);
    book.base = std::make_shared<const rtcore::VariantScene>(std::move(base));
    return book;
}

} // namespace rtserver
