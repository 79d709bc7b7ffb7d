#include "bench/walk/walk_truth.h"

#include "bench/walk/path_truth.h"
#include "bench/walk/walk_errors.h"
#include "bench/walk/walk_references.h"

#include "rtcore/settings/settings_table.h"

namespace bench {

namespace {

rtcore::RenderSettings wantedSettings(const WalkOptions& options, const LiveServer& server) {
    const rtcore::RenderSettings live = server.document().settings();
    if (!options.still) return live;
    rtcore::RenderSettings settings;
    rtcore::applySettings(settings, server.document().world().loaded.still);
    rtcore::applySettings(settings, options.settings);
    settings.width = live.width;
    settings.height = live.height;
    return settings;
}

/// The Renderer's pictures by Whitted's rays, in the pixels of the window.
class RayTruth : public WalkTruth {
  public:
    RayTruth(const WalkOptions& options, const LiveServer& server, const std::vector<rtcore::Camera>& cameras)
        : options_(options), server_(server), cameras_(cameras), references_(options),
          settings_(wantedSettings(options, server)) {}

    PicturePair pairOf(const Published& picture, std::size_t camera) override {
        const rtserver::Document& document = server_.document();
        return {.shown = upsampled(picture.image, options_.width, options_.height),
                .wanted = references_.picture(
                    {*document.scene(), *document.tracer(), cameras_[camera], settings_})};
    }

  private:
    const WalkOptions& options_;
    const LiveServer& server_;
    const std::vector<rtcore::Camera>& cameras_;
    WalkReferences references_;
    rtcore::RenderSettings settings_;
};

} // namespace

std::unique_ptr<WalkTruth> makeTruth(const WalkOptions& options, const LiveServer& server,
                                     const std::vector<rtcore::Camera>& cameras) {
    if (options.truth == Truth::Paths)
        return std::make_unique<PathTruth>(options, server, cameras, wantedSettings(options, server));
    return std::make_unique<RayTruth>(options, server, cameras);
}

} // namespace bench
