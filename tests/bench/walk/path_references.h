/// Images of a walk's cameras by path tracing: made once, kept as files.
#pragma once

#include "bench/walk/walk_options.h"

#include "rtserver/document/document.h"

#include "common/progress/progress.h"

#include "rtcore/render/image_renderer.h"
#include "rtcore/scene/camera.h"
#include "rtcore/scene/image.h"
#include "rtcore/settings/render_settings.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace bench {

/// Two of each camera, whose samples are independent, by the options' samples and size: radiance without
/// denoising and other effects. A file DIR/CAMERA-SEED-KEY.pfm is known again by its key (reference_key.h),
/// of those settings alone that paths read and that are not their default: empty the folder when paths or
/// defaults change.
class PathReferences {
  public:
    /// All must outlive it. Makes the folder.
    PathReferences(const WalkOptions& options, const rtserver::Document& document,
                   const rtcore::RenderSettings& settings, const std::vector<rtcore::Camera>& cameras);

    /// Renders what has no file yet, by all cores, of each options.every-th camera; progress goes to stderr.
    /// A file is replaced as a whole when its image is done. Returns early when the program was asked to
    /// stop: another call goes on with the image that was left.
    void renderMissing() const;

    struct Pair {
        rtcore::HdrImage one, other;
    };
    /// Read from their files. Throws rtcore::FileError.
    Pair read(std::size_t camera) const;

    /// With which they are rendered, but for the seed.
    const rtcore::RenderSettings& settings() const { return settings_; }

  private:
    struct Job {
        std::size_t camera;
        int seed;
    };
    rtcore::RenderSettings settingsOf(const Job& job) const;
    std::filesystem::path file(const Job& job) const;
    std::vector<Job> missing() const;
    /// The job's number of so many, from 1, is for the progress.
    struct Turn {
        app::Progress& progress;
        int number, count;
    };
    bool render(const Job& job, const Turn& turn, rtcore::ImageRenderer& renderer) const;

    const WalkOptions& options_;
    const rtserver::Document& document_;
    const std::vector<rtcore::Camera>& cameras_;
    std::string scene_;
    rtcore::RenderSettings settings_;
};

} // namespace bench
