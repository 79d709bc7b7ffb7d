/// A model with the files that it needs, in a pack.
#pragma once

#include "rtserver/document/packed_files.h"

#include <filesystem>
#include <vector>

namespace rtserver {

/// The files that an import of the model opens beside the model itself, by absolute names.
std::vector<std::filesystem::path> companionsOf(const std::filesystem::path& model,
                                                const PackProgress& progress);

/// Copies the model and `companions` as they stand to each other. The copy is imported: of the companions
/// stay images that were decoded, and those without which the model would be another. Returns the model's
/// path there. Throws FileError: BadData for a model whose copy does not find its files, or finds them
/// outside of the pack; and what importModel() throws.
std::filesystem::path packModel(const std::filesystem::path& model,
                                const std::vector<std::filesystem::path>& companions, PackedFiles& pack);

} // namespace rtserver
