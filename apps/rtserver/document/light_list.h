/// The lights of a document, by their ids.
#pragma once

#include "rtserver/document/document.h"

#include "rtcore/io/text/scn.h"

#include <cstddef>
#include <functional>
#include <optional>

namespace rtserver {

// They throw std::invalid_argument when the scene has no such light.

std::size_t lightOf(const rtcore::Scene& scene, int id); ///< its place among the scene's lights
/// Nothing: the other way round.
void switchLight(Document& document, int id, std::optional<bool> on);
/// `change` gets the light to be changed, but for its id; what it throws leaves the light as it is.
void changeLight(Document& document, int id, const std::function<void(rtcore::LightDescription&)>& change);
/// It gets an id of its own, which is returned.
int addLight(Document& document, rtcore::LightDescription light);
void removeLight(Document& document, int id);

} // namespace rtserver
