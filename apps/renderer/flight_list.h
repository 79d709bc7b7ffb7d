/// The frames of a flight or a turntable, as a list of cameras like any other. Where no key frame has an
/// exposure, and images would find theirs one by one, that of the film is measured beforehand.
#pragma once

#include "renderer/picture_maker.h"
#include "renderer/renderer_options.h"

#include "rtcore/platform/temporary_folder.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace renderer {

/// How many frames options.flight has. Reads the scene's text alone. Throws FileError NoInput where the scene
/// has no flight of that name.
int framesOfFlight(const RendererOptions& options);

/// Holds the .cam files in a folder for temporary files while it lives.
class FlightList {
  public:
    /// Of options.flight. Throws FileError: the same, and CannotWrite, Stopped.
    FlightList(const RendererOptions& options, PictureMaker& maker);
    const std::vector<std::filesystem::path>& cameras() const { return cameras_; }

  private:
    rtcore::TemporaryFolder folder_;
    std::vector<std::filesystem::path> cameras_;
};

/// Writes options.makeList. Throws the same; the list must not be there yet.
void makeList(const RendererOptions& options, PictureMaker& maker, app::Progress& progress);

} // namespace renderer
