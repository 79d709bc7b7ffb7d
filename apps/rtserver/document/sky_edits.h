/// Edits of what surrounds the scene: its sky, its environment maps, a look in place of both.
#pragma once

#include "rtserver/document/document.h"

#include "rtcore/look/lighting_preset.h"

#include <optional>

namespace rtserver {

/// Nothing: none, and what a model without lights is given is switched on again. A first one, and a map,
/// light the scene from then on (skyLight.on).
void setSky(Document& document, const std::optional<rtcore::Sky>& sky);
/// In place of all lights, of the sky and of the environment; skyLight.on follows.
void setLightingPreset(Document& document, rtcore::LightingPreset preset);

/// Counted from 0. Throws std::invalid_argument when the scene has fewer.
void setEnvironment(Document& document, int environment);
/// Shown from then on, in place of a sky.
void addEnvironment(Document& document, const rtcore::EnvironmentFile& file, rtcore::Environment environment);
void leaveEnvironment(Document& document); ///< neither sky nor map

// The one that is shown. They throw std::runtime_error where there is none, or nothing to turn.

void rotateEnvironment(Document& document, float degrees);
void scaleEnvironment(Document& document, float factor);

} // namespace rtserver
