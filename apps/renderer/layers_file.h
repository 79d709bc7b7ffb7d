/// A picture and what is known of its surfaces, in one file.
#pragma once

#include "rtcore/render/layers.h"
#include "rtcore/scene/image.h"

#include <filesystem>

namespace renderer {

/// Replaces `path` by an EXR with the radiance as R, G, B and the layers depth, normal, albedo, direct and
/// occlusion, by the names that other programs look for. `layers` is not empty and of the size of `radiance`.
/// Throws rtcore::FileError CannotWrite.
void writeLayers(const std::filesystem::path& path, const rtcore::HdrImage& radiance,
                 const rtcore::FrameLayers& layers);

} // namespace renderer
