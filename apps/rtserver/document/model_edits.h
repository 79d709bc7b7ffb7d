/// Edits of what is seen of a model: its materials, its parts and its sections.
#pragma once

#include "rtserver/document/document.h"

#include "rtcore/scene/material_edit.h"

#include <cstddef>
#include <span>

namespace rtserver {

// Materials of the model, counted from 0; all must be there. What surfaces are closed follows.

void editMaterials(Document& document, std::span<const std::size_t> materials,
                   const rtcore::MaterialOverride& change);
/// In place of all their edits but a priority that the look does not say.
void giveMaterials(Document& document, std::span<const std::size_t> materials,
                   const rtcore::MaterialOverride& look);
/// How `from` is shown becomes the look of the others; that of itself stays.
void copyMaterial(Document& document, std::size_t from, std::span<const std::size_t> materials);
void resetMaterials(Document& document, std::span<const std::size_t> materials); ///< as the files have them

/// Parts of this model. Rays and bodies pass through what is hidden.
void hideParts(Document& document, rtcore::HiddenParts hidden);

/// In place of those that sections left whole.
void leaveUncut(Document& document, rtcore::PartSet uncut);
/// By these planes, at most kMaxSectionPlanes.
void cutOpen(Document& document, rtcore::SectionPlanes sections);

} // namespace rtserver
