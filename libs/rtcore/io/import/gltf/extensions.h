/// Extensions of glTF: what a file needs and what it uses of what is not read.
#pragma once

#include "rtcore/io/import/gltf/json_members.h"
#include "rtcore/platform/sentence.h"

#include <optional>

namespace rtcore::gltf {

struct Needs {
    std::optional<Sentence> fatal; ///< the geometry cannot be read
    std::optional<Sentence> loss;  ///< part of the model is missing or wrong
};

/// What the file requires and this reader does not read, with a remedy. Extensions of materials, which only
/// change how a surface looks, are no needs.
Needs needsOf(const Json& root);

/// What the file uses but does not need, and is not read, with what is lost; nothing where there is nothing.
std::optional<Sentence> ignoredOf(const Json& root);

} // namespace rtcore::gltf
