/// An image and what is known of its surfaces, in one file.
#pragma once

#include "rtcore/io/images/image_text.h"
#include "rtcore/render/aovs.h"
#include "rtcore/scene/image.h"

#include <filesystem>
#include <span>

namespace renderer {

/// Replaces `path` by an EXR with the radiance as R, G, B and the AOVs depth, normal, albedo, direct and
/// occlusion, by the names that other programs look for. `aovs` is not empty and of the size of `radiance`.
/// Throws rtcore::FileError CannotWrite.
void writeAovs(const std::filesystem::path& path, const rtcore::HdrImage& radiance, const rtcore::Aovs& aovs,
               std::span<const rtcore::ImageText> texts);

} // namespace renderer
