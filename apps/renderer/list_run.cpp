#include "renderer/list_run.h"

#include "renderer/film.h"
#include "renderer/film_rate.h"
#include "renderer/frame_list.h"
#include "renderer/frame_run.h"
#include "renderer/list_follower.h"

#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/processes.h"

#include <algorithm>
#include <set>
#include <string>

namespace renderer {

namespace {

using Paths = std::vector<std::filesystem::path>;

[[noreturn]] void failForWantOfFfmpeg(const RendererOptions& options, double framesPerSecond) {
    throw rtcore::FileError(
        rtcore::FailureKind::NoInput, options.video->string(),
        rtcore::say("there is no ffmpeg to make it; install it, or render the frames with -o "
                    "frame_####.png and make the film of them where it is: {0}",
                    encodeCommand(*options.video, framesPerSecond)));
}

class ListRun {
  public:
    ListRun(const RendererOptions& options, const Paths& patterns, const app::InputFiles& inputs,
            PictureMaker& maker, app::Progress& progress)
        : options_(options), patterns_(patterns), inputs_(inputs), maker_(maker), progress_(progress) {}

    app::ExitCode run(const Paths& cameras, const std::optional<std::filesystem::path>& ffmpeg) {
        std::vector<FrameTask> frames;
        if (!options_.follow) {
            maker_.setList(cameras);
            frames = framesOfChunk(framesOfList(cameras, options_.frames, patterns_), options_.chunk);
            if (frames.empty()) {
                progress_.tell(rtcore::form("there are more chunks than frames; this one is empty"));
                return app::ExitCode::Done;
            }
        }
        maker_.readNet();
        if (options_.video) inputs_.refuse(*options_.video);
        checkOutputs(frames);
        preparePlaces();
        const double rate = options_.framesPerSecond.value_or(recordedFrameRate(frames));
        if (options_.video && ffmpeg) return renderFilm(*ffmpeg, rate, frames);
        FrameRun run(options_, progress_, maker_);
        const app::ExitCode code = render(run, frames);
        if (options_.video) failForWantOfFfmpeg(options_, rate);
        return code;
    }

  private:
    app::ExitCode render(FrameRun& run, const std::vector<FrameTask>& frames) {
        if (options_.follow) {
            followList(run);
        } else {
            run.renderList(frames);
        }
        return run.finish();
    }

    void checkOutputs(const std::vector<FrameTask>& frames) {
        for (const FrameTask& frame : frames) inputs_.add(frame.camera);
        for (const FrameTask& frame : frames) refuseInputs(inputs_, frame);
    }

    /// Makes the folders of frames that are missing, and removes what killed runs left in them.
    void preparePlaces() {
        std::set<std::filesystem::path> folders;
        for (const std::filesystem::path& pattern : patterns_) {
            if (!isStandardOutput(pattern)) folders.insert(pattern.parent_path());
        }
        for (const std::filesystem::path& folder : folders) {
            if (makeFolder(folder) && options_.verbose) progress_.print("made the folder " + folder.string());
            rtcore::removeForgottenFiles(folder);
        }
    }

    void followList(FrameRun& run) {
        ListFollower follower(*options_.list, options_.followTimeout);
        std::size_t known = 0;
        while (known < static_cast<std::size_t>(options_.frames.last)) {
            const Paths cameras = follower.waitBeyond(known, progress_);
            const bool grown = cameras.size() > known;
            if (grown) maker_.setFirstOfList(cameras.front());
            const int next = static_cast<int>(known) + 1;
            const FrameRange fresh{std::max(next, options_.frames.first), options_.frames.last};
            known = cameras.size();
            const std::vector<FrameTask> frames = pickFrames(cameras, fresh, patterns_);
            checkOutputs(frames);
            run.renderList(frames);
            if (follower.ended()) return;
            if (!grown) break;
        }
        if (known < static_cast<std::size_t>(options_.frames.last)) {
            progress_.tell(rtcore::say(
                "warning: {0}",
                rtcore::form(
                    "the list has no end mark, but did not grow any more; it is taken as complete")));
        }
    }

    app::ExitCode renderFilm(const std::filesystem::path& ffmpeg, double rate,
                             const std::vector<FrameTask>& frames) {
        rtcore::replaceFile(*options_.video, [&](const std::filesystem::path& temporary) {
            Film film(ffmpeg, *options_.video, temporary, rate);
            FrameRun run(options_, progress_, maker_, &film);
            const app::ExitCode code = render(run, frames);
            if (code != app::ExitCode::Done) {
                const auto kind = code == app::ExitCode::BadData ? rtcore::FailureKind::BadData
                                                                 : rtcore::FailureKind::NoInput;
                throw rtcore::FileError(kind, options_.video->string(),
                                        "not written, since frames are missing");
            }
            const app::ProgressScope scope(progress_, {"finishing the film", {}, nullptr});
            film.finish();
        });
        return app::ExitCode::Done;
    }

    const RendererOptions& options_;
    const Paths& patterns_;
    app::InputFiles inputs_;
    PictureMaker& maker_;
    app::Progress& progress_;
};

} // namespace

std::optional<std::filesystem::path> findFilmMaker(const RendererOptions& options) {
    if (!options.video) return std::nullopt;
    auto ffmpeg = rtcore::findProgram("ffmpeg");
    if (!ffmpeg && options.outputs.empty()) {
        failForWantOfFfmpeg(options, options.framesPerSecond.value_or(kUsualFrameRate));
    }
    return ffmpeg;
}

app::ExitCode runList(const RendererOptions& options, const Paths& cameras, const Paths& patterns,
                      const app::InputFiles& inputs, const std::optional<std::filesystem::path>& ffmpeg,
                      PictureMaker& maker, app::Progress& progress) {
    return ListRun(options, patterns, inputs, maker, progress).run(cameras, ffmpeg);
}

} // namespace renderer
