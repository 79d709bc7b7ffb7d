#include "rtserver/document/model_edits.h"

#include "rtcore/io/variants/material_words.h"

#include <utility>

namespace rtserver {

namespace {

/// `edit` takes the scene, its materials as the files have them, and the number of one.
template <typename Edit>
void editEach(Document& document, std::span<const std::size_t> materials, Edit edit) {
    rtcore::Scene edited = *document.scene();
    for (const std::size_t material : materials)
        edit(edited, document.world().loaded.scene.materials, material);
    rtcore::closeSurfaces(edited, document.scene()->materials);
    document.publish(std::move(edited));
}

} // namespace

void editMaterials(Document& document, std::span<const std::size_t> materials,
                   const rtcore::MaterialOverride& change) {
    editEach(document, materials, [&](rtcore::Scene& scene, const auto& loaded, std::size_t i) {
        rtcore::editMaterial(scene, loaded, i, change);
    });
}

void giveMaterials(Document& document, std::span<const std::size_t> materials,
                   const rtcore::MaterialOverride& look) {
    editEach(document, materials, [&](rtcore::Scene& scene, const auto& loaded, std::size_t i) {
        rtcore::giveLook(scene, loaded, i, look);
    });
}

void copyMaterial(Document& document, std::size_t from, std::span<const std::size_t> materials) {
    const rtcore::Material shown = document.scene()->materials[from];
    editEach(document, materials, [&](rtcore::Scene& scene, const auto& loaded, std::size_t i) {
        if (i != from) rtcore::giveLook(scene, loaded, i, rtcore::lookOf(scene.model, shown, loaded[i]));
    });
}

void resetMaterials(Document& document, std::span<const std::size_t> materials) {
    editEach(document, materials, [](rtcore::Scene& scene, const auto& loaded, std::size_t i) {
        rtcore::resetMaterial(scene, loaded, i);
    });
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
