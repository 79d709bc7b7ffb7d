/// The model of a scene: from its file or the one that was built of it, with its tree.
#pragma once

#include "rtcore/io/loading/file_kind.h"
#include "rtcore/io/loading/loading.h"

#include <filesystem>

namespace rtcore {

/// `kind` is Bsp or Model. Takes its materials and its first camera, too.
void readModel(Loading& loading, const std::filesystem::path& path, InputFile file, FileKind kind,
               const ImportOptions& import);

/// The lights that it brings, among the scene's.
void takeModelLights(Scene& scene);

} // namespace rtcore
