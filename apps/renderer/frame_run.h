/// Renders frames one after another, into files and into a film.
#pragma once

#include "renderer/film.h"
#include "renderer/frame_list.h"
#include "renderer/picture_maker.h"
#include "renderer/renderer_options.h"
#include "renderer/report_file.h"

#include "common/process/exit_codes.h"
#include "common/progress/progress.h"

#include <optional>
#include <vector>

namespace renderer {

/// Keeps count of the frames that fail, and the report of the others where one is asked for. `film` may be
/// null. All that it gets must outlive it.
class FrameRun {
  public:
    FrameRun(const RendererOptions& options, app::Progress& progress, PictureMaker& maker,
             Film* film = nullptr);

    /// The one frame of a run without a list. Throws as PictureMaker::make does.
    void renderOne(const FrameTask& frame);

    /// Frames of a list; may be called again for more of them. Those whose files are whole are not rendered
    /// again (unless --force): a film gets them from their files. A frame whose .cam is bad is reported and
    /// left out, and the film gets no frame any more; without any files, such a frame throws.
    void renderList(std::vector<FrameTask> frames);

    /// Says how many frames failed. The exit code is that of the first of them.
    app::ExitCode finish();

  private:
    void findFinished(std::vector<FrameTask>& frames);
    void renderListed(const FrameTask& frame, int index, int count);
    void make(const FrameTask& frame, int index, int count);
    void tell(const FrameTask& frame, const FrameReport& report);

    const RendererOptions& options_;
    app::Progress& progress_;
    PictureMaker& maker_;
    Film* film_;
    std::optional<ReportFile> report_;
    int asked_ = 0, failed_ = 0;
    app::ExitCode result_ = app::ExitCode::Done;
};

} // namespace renderer
