/// The Renderer's pictures of a walk's cameras: made once, kept as files.
#pragma once

#include "bench/walk/walk_options.h"

#include "rtcore/render/view.h"
#include "rtcore/scene/image.h"

#include <filesystem>

namespace bench {

/// As `Renderer` makes them, with an automatic exposure of each its own. A picture is known again by
/// everything that it is made from (reference_key.h), but not by the program that made it: empty the folder
/// when its pictures are to change.
class WalkReferences {
  public:
    /// The scene is named in the pictures' keys, with its time of change. Makes the folder.
    explicit WalkReferences(const WalkOptions& options);

    /// Read from its file, or rendered by all cores and kept.
    rtcore::LdrImage picture(const rtcore::View& view) const;

  private:
    std::filesystem::path file(const rtcore::View& view) const;

    std::filesystem::path folder_;
    std::string scene_;
};

} // namespace bench
