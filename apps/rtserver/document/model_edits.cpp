#include "rtserver/document/model_edits.h"

#include <utility>

namespace rtserver {

void editMaterials(Document& document, std::span<const std::size_t> materials,
                   const rtcore::MaterialOverride& change) {
    rtcore::Scene edited = *document.scene();
    for (const std::size_t material : materials)
        rtcore::editMaterial(edited, document.world().loaded.scene.materials, material, change);
    rtcore::closeSurfaces(edited, document.scene()->materials);
    document.publish(std::move(edited));
}

void resetMaterials(Document& document, std::span<const std::size_t> materials) {
    rtcore::Scene edited = *document.scene();
    for (const std::size_t material : materials)
        rtcore::resetMaterial(edited, document.world().loaded.scene.materials, material);
    rtcore::closeSurfaces(edited, document.scene()->materials);
    document.publish(std::move(edited));
}

void hideParts(Document& document, rtcore::HiddenParts hidden) {
    rtcore::Scene edited = *document.scene();
    edited.hiddenParts = std::move(hidden);
    document.publish(std::move(edited));
}

void leaveUncut(Document& document, rtcore::PartSet uncut) {
    rtcore::Scene edited = *document.scene();
    edited.uncutParts = std::move(uncut);
    document.publish(std::move(edited));
}

void cutOpen(Document& document, rtcore::SectionPlanes sections) {
    rtcore::Scene edited = *document.scene();
    edited.sections = std::move(sections);
    document.publish(std::move(edited));
}

} // namespace rtserver
