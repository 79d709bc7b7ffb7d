/// A list of frames from its first to its last, with the film of it.
#pragma once

#include "renderer/picture_maker.h"
#include "renderer/renderer_options.h"

#include "common/cli/input_files.h"
#include "common/process/exit_codes.h"
#include "common/progress/progress.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace renderer {

/// Finds ffmpeg, when a film is asked for. When there is none: throws rtcore::FileError NoInput that says how
/// to make the film, unless the frames are kept in files and so are worth rendering.
std::optional<std::filesystem::path> findFilmMaker(const RendererOptions& options);

/// Renders the frames of a list that is complete (`cameras`) or, with --follow, of one that still grows. A
/// film appears under its name only when all its frames are in it. Folders of frames that are missing are
/// made, and what killed runs left there is removed. Returns the exit code of the first bad frame. Throws
/// app::UsageError when an output is one of `inputs` or of the .cam files, before anything is written;
/// rtcore::FileError: CannotWrite when an output cannot be written or ffmpeg fails, Stopped, and for a film
/// that lacks frames, or ffmpeg.
app::ExitCode runList(const RendererOptions& options, const std::vector<std::filesystem::path>& cameras,
                      const std::vector<std::filesystem::path>& patterns, const app::InputFiles& inputs,
                      const std::optional<std::filesystem::path>& ffmpeg, PictureMaker& maker,
                      app::Progress& progress);

} // namespace renderer
