/// An image and what is known of its surfaces, in one file.
#pragma once

#include "rtcore/io/images/image_notes.h"
#include "rtcore/render/frame.h"
#include "rtcore/scene/image.h"

#include <filesystem>
#include <span>
#include <vector>

namespace renderer {

/// Replaces `path` by an EXR of the radiance; where the frame's background is hidden, with its alpha as A, by
/// which the radiance counts as multiplied. The same size and errors as below.
void writeExr(const std::filesystem::path& path, const rtcore::HdrImage& radiance, const rtcore::Frame& frame,
              std::span<const rtcore::ImageText> texts);

/// Replaces `path` by an EXR with the radiance as R, G, B, with A as above, and the AOVs depth, normal,
/// albedo, direct and occlusion, by the names that other programs look for; with guideAlbedo and guideNormal
/// where the frame has guides, with `sampled` where effects made the radiance another than the frame's, and
/// with `error` where `errors`, EstimatedError::pixels, are not empty. Its AOVs are not empty, and all are of
/// the size of `radiance`. Throws rtcore::FileError CannotWrite.
void writeAovs(const std::filesystem::path& path, const rtcore::HdrImage& radiance,
               const rtcore::Frame& frame, const std::vector<float>& errors,
               std::span<const rtcore::ImageText> texts);

} // namespace renderer
