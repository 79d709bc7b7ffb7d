#include "renderer/frame_run.h"

#include "renderer/frame_check.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/platform/error.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <string>

namespace renderer {

namespace {

std::string savingText(const FrameReport& report) {
    const std::uint64_t taken = report.rays.rays[static_cast<std::size_t>(rtcore::RayKind::Primary)];
    const double saved = 100 - 100 * static_cast<double>(taken) / static_cast<double>(report.samples);
    return fmt::format("took {} of {} samples, {:.1f} % saved", taken, report.samples, saved);
}

// The file from which a film can take a finished frame as it is shown; null when there is none.
const std::filesystem::path* shownPicture(const FrameTask& frame) {
    const auto found = std::find_if(frame.outputs.begin(), frame.outputs.end(), [](const auto& output) {
        return !isStandardOutput(output) && !rtcore::isHdrFormat(output);
    });
    return found == frame.outputs.end() ? nullptr : &*found;
}

std::string places(const FrameTask& frame) {
    std::string where;
    for (const std::filesystem::path& output : frame.outputs) {
        where +=
            (where.empty() ? "" : ", ") + (isStandardOutput(output) ? "standard output" : output.string());
    }
    return where.empty() ? fmt::format("frame {} of the film", frame.number) : where;
}

} // namespace

FrameRun::FrameRun(const RendererOptions& options, app::Progress& progress, PictureMaker& maker, Film* film)
    : options_(options), progress_(progress), maker_(maker), film_(film) {
    if (options.report) report_.emplace(*options.report, options);
}

void FrameRun::renderOne(const FrameTask& frame) { make(frame, 1, 1); }

void FrameRun::renderList(std::vector<FrameTask> frames) {
    for (FrameTask& frame : frames) frame.filmed = film_ != nullptr;
    if (!options_.force) findFinished(frames);
    const auto count = static_cast<int>(
        std::count_if(frames.begin(), frames.end(), [](const FrameTask& frame) { return !frame.finished; }));
    asked_ += count;
    int index = 0;
    for (const FrameTask& frame : frames) {
        if (!frame.finished) {
            renderListed(frame, ++index, count);
        } else if (film_ != nullptr) {
            film_->add(rtcore::readLdrImage(*shownPicture(frame)), frame.number);
        }
    }
}

app::ExitCode FrameRun::finish() {
    if (failed_ > 0) {
        progress_.tell(rtcore::say("{0} of {1} frames failed", failed_, asked_));
    }
    return result_;
}

void FrameRun::findFinished(std::vector<FrameTask>& frames) {
    std::set<int> unfinished;
    for (const FileFlaw& flaw : findFlaws(frames, options_.threads, progress_)) {
        unfinished.insert(flaw.frame);
        if (!flaw.missing) {
            const auto again = rtcore::say("{0} is rendered again: {1}", flaw.file.string(), flaw.reason);
            progress_.tell(rtcore::say("warning: {0}", again));
        }
    }
    std::size_t there = 0;
    for (FrameTask& frame : frames) {
        const bool usable = film_ != nullptr ? shownPicture(frame) != nullptr : !frame.outputs.empty();
        frame.finished = usable && !unfinished.contains(frame.number);
        there += frame.finished ? 1 : 0;
    }
    if (there > 0) {
        progress_.tell(rtcore::say("{0} of {1} frames are there already (--force renders them again)", there,
                                   frames.size()));
    }
}

void FrameRun::renderListed(const FrameTask& frame, int index, int count) {
    try {
        make(frame, index, count);
    } catch (const rtcore::FileError& error) {
        const bool badData = error.kind == rtcore::FailureKind::BadData;
        const bool ofThisFrame = badData || error.kind == rtcore::FailureKind::NoInput;
        if (!ofThisFrame || frame.outputs.empty()) throw;
        progress_.tell(error.sentence());
        if (failed_++ == 0) result_ = badData ? app::ExitCode::BadData : app::ExitCode::NoInput;
        // A film with a gap is not what was asked for.
        film_ = nullptr;
        return;
    }
    if (film_ != nullptr) film_->add(maker_.developed(), frame.number);
}

void FrameRun::make(const FrameTask& frame, int index, int count) {
    const FrameReport made = maker_.make(frame, index, count);
    if (report_) report_->add(frame, made);
    tell(frame, made);
}

void FrameRun::tell(const FrameTask& frame, const FrameReport& report) {
    if (options_.verbose) {
        const double rays = static_cast<double>(report.rays.total());
        const double speed = report.renderSeconds > 0 ? rays / report.renderSeconds * 1e-6 : 0.0;
        progress_.print(fmt::format("rendered {} x {} in {:.3f} s, {:.0f} rays, {:.2f} Mrays/s", report.width,
                                    report.height, report.renderSeconds, rays, speed));
        if (report.samples > 0) progress_.print(savingText(report));
    }
    const bool logged = options_.hasFrames() && options_.progress == app::ProgressStyle::Plain;
    const bool kept = options_.hasFrames() || !frame.outputs.empty();
    if ((options_.verbose && kept) || logged) {
        progress_.print(fmt::format("wrote {} in {:.3f} s", places(frame), report.writeSeconds));
    }
}

} // namespace renderer
