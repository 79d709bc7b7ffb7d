/// One image after another in a preview, for a program that asks for them while its user moves: what is
/// loaded stays loaded.
#pragma once

#include "renderer/preview.h"
#include "renderer/renderer_options.h"

#include "common/process/exit_codes.h"
#include "common/progress/progress.h"

#include "rtcore/settings/settings_table.h"

#include <vector>

namespace renderer {

/// Renders the image of the options, then those of Requests, until standard input ends or a signal comes. The
/// scene is loaded again when its description, but for camera, bookmarks, measures and notes, or a file that
/// it was loaded from has changed. Throws what a run of one image throws, except for an image that is not
/// wanted any more.
app::ExitCode standBy(const RendererOptions& options, const std::vector<rtcore::SettingAssignment>& settings,
                      Preview& preview, app::Progress& progress);

} // namespace renderer
