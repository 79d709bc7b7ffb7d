/// A run's report for programs: how its frames were made, and what they took.
#pragma once

#include "renderer/frame_list.h"
#include "renderer/picture_maker.h"
#include "renderer/renderer_options.h"

#include <filesystem>
#include <memory>

namespace renderer {

/// A JSON file (docs/manual.md, "A report of a run") that is replaced after each frame, so that a run that is
/// stopped leaves the report of those that it made.
class ReportFile {
  public:
    /// Without frames. Throws rtcore::FileError CannotWrite.
    ReportFile(std::filesystem::path path, const RendererOptions& options);
    ~ReportFile();
    ReportFile(const ReportFile&) = delete;
    ReportFile& operator=(const ReportFile&) = delete;

    /// Throws rtcore::FileError CannotWrite.
    void add(const FrameTask& frame, const FrameReport& report);

  private:
    struct Content;
    void write() const;

    std::filesystem::path path_;
    std::unique_ptr<Content> content_;
};

} // namespace renderer
