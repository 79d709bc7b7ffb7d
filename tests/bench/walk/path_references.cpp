#include "bench/walk/path_references.h"

#include "bench/walk/reference_key.h"

#include "common/process/stop.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/render/frame.h"
#include "rtcore/settings/settings_table.h"

#include <fmt/format.h>

#include <array>

namespace bench {

namespace {

constexpr std::array kSeeds{101, 102};

/// What paths read of them, and the samples and size of the options.
rtcore::RenderSettings pathSettings(const rtcore::RenderSettings& all, const WalkOptions& options) {
    rtcore::RenderSettings settings;
    for (const rtcore::Setting& row : rtcore::settingsTable()) {
        const bool ofPaths = !row.integrator || *row.integrator == rtcore::Integrator::Path;
        if (ofPaths && row.isOfImage()) row.set(settings, row.get(all));
    }
    settings.integrator = rtcore::Integrator::Path;
    settings.width = options.truthWidth;
    settings.height = options.truthHeight;
    settings.path.samples = options.truthSamples;
    settings.path.seedPerFrame = false;
    settings.indirect = {}; // without a net it lights no paths
    return settings;
}

} // namespace

PathReferences::PathReferences(const WalkOptions& options, const rtserver::Document& document,
                               const rtcore::RenderSettings& settings,
                               const std::vector<rtcore::Camera>& cameras)
    : options_(options), document_(document), cameras_(cameras), scene_(sceneKey(options)),
      settings_(pathSettings(settings, options)) {
    std::filesystem::create_directories(options.references);
}

rtcore::RenderSettings PathReferences::settingsOf(const Job& job) const {
    rtcore::RenderSettings settings = settings_;
    settings.path.seed = job.seed;
    return settings;
}

std::filesystem::path PathReferences::file(const Job& job) const {
    const auto settings = rtcore::settingAssignments(settingsOf(job), false);
    return options_.references / fmt::format("{:05}-{}-{:016x}.pfm", job.camera, job.seed,
                                             referenceKey(scene_, cameras_[job.camera], settings));
}

std::vector<PathReferences::Job> PathReferences::missing() const {
    std::vector<Job> jobs;
    for (std::size_t i = 0; i < cameras_.size(); i += static_cast<std::size_t>(options_.every)) {
        for (const int seed : kSeeds) {
            if (!std::filesystem::exists(file({i, seed}))) jobs.push_back({i, seed});
        }
    }
    return jobs;
}

void PathReferences::renderMissing() const {
    const std::vector<Job> jobs = missing();
    const auto renderer = rtcore::makeImageRenderer(rtcore::Integrator::Path);
    app::Progress progress("bench_walk", options_.progress);
    const auto count = static_cast<int>(jobs.size());
    for (int i = 0; i < count && !app::stopRequested(); ++i)
        if (!render(jobs[static_cast<std::size_t>(i)], {progress, i + 1, count}, *renderer)) break;
}

/// False when it was left.
bool PathReferences::render(const Job& job, const Turn& turn, rtcore::ImageRenderer& renderer) const {
    const rtcore::RenderSettings settings = settingsOf(job);
    const rtcore::View view{*document_.scene(), *document_.tracer(), cameras_[job.camera], settings};
    rtcore::RenderControl control;
    const app::ProgressScope scope(turn.progress,
                                   {.name = "rendering references",
                                    .fraction = [&] { return renderer.fraction(control); },
                                    .cancel = &control.cancel},
                                   turn.number, turn.count);
    rtcore::Frame frame;
    if (!renderer.render(view, control, {}, frame)) return false;
    rtcore::writeHdrImage(file(job), frame.radiance);
    return true;
}

PathReferences::Pair PathReferences::read(std::size_t camera) const {
    return {rtcore::readHdrImage(file({camera, kSeeds[0]})), rtcore::readHdrImage(file({camera, kSeeds[1]}))};
}

} // namespace bench
