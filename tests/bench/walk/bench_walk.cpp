/// bench_walk: what is seen while walking, beside what should be seen.
#include "bench/walk/played_walk.h"
#include "bench/walk/walk_options.h"
#include "bench/walk/walk_report.h"
#include "bench/walk/walk_truth.h"

#include "common/cli/run_program.h"
#include "common/process/stop.h"
#include "common/process/threads.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/io/recording/camera_list.h"
#include "rtcore/io/text/cam.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace bench {

namespace {

constexpr int kSheetRows = 6; ///< and the worst moment

std::vector<rtcore::Camera> readCameras(const WalkOptions& options) {
    std::vector<rtcore::Camera> cameras;
    for (const std::filesystem::path& file : rtcore::readCameraList(options.list)) {
        if (options.frames > 0 && std::ssize(cameras) == options.frames) break;
        cameras.push_back(rtcore::readCameraFile(file).camera);
        if (options.parallelWidth <= 0) continue;
        cameras.back().kind = rtcore::CameraKind::Orthographic;
        cameras.back().orthographicWidth = options.parallelWidth;
    }
    if (cameras.empty()) throw std::runtime_error(options.list.string() + " names no camera");
    return cameras;
}

PictureErrors errorsOfPair(const PicturePair& pair) {
    PictureErrors errors = errorsOf(pair.shown, pair.wanted, test::Flip(pair.wanted, pair.pixelsPerDegree));
    if (pair.light) {
        errors.relMse = pair.light->relMse;
        errors.blocks = pair.light->blocks;
        errors.bias = pair.light->bias;
    }
    if (pair.uncovered) {
        errors.uncoveredBlocks = pair.uncovered->blocks;
        errors.uncoveredBias = pair.uncovered->bias;
    }
    return errors;
}

class Comparison {
  public:
    Comparison(const WalkOptions& options, WalkTruth& truth, const std::vector<rtcore::Camera>& cameras,
               const std::vector<Published>& published)
        : options_(options), truth_(truth), cameras_(cameras), published_(published) {}

    std::vector<Moment> run() {
        std::vector<Moment> moments;
        app::Progress progress("bench_walk", options_.progress);
        for (std::size_t i = 0; i < cameras_.size(); i += static_cast<std::size_t>(options_.every)) {
            progress.begin({.name = "comparing", .fraction = {}}, static_cast<int>(i) + 1,
                           static_cast<int>(cameras_.size()));
            if (app::stopRequested()) break;
            moments.push_back(at(i));
        }
        progress.end();
        return moments;
    }

    void writeSheet(const std::vector<Moment>& moments) const {
        const auto worst =
            std::ranges::max_element(moments, {}, [](const Moment& moment) { return moment.errors.flip; });
        std::set<int> chosen{worst->camera};
        for (int i = 0; i < kSheetRows; ++i)
            chosen.insert(moments[static_cast<std::size_t>(i) * moments.size() / kSheetRows].camera);
        ContactSheet sheet;
        for (const int camera : chosen) {
            const auto i = static_cast<std::size_t>(camera);
            const PicturePair pair = truth_.pairOf(published_[pictureAt(i)], i);
            sheet.add(pair.shown, pair.wanted,
                      test::Flip(pair.wanted, pair.pixelsPerDegree).errors(pair.shown));
        }
        sheet.write(*options_.sheet);
    }

    void writePictures() const {
        std::filesystem::create_directories(*options_.pictures);
        for (std::size_t i = 0; i < cameras_.size(); ++i)
            rtcore::writeImage(*options_.pictures / fmt::format("{:05}.png", i),
                               upsampled(published_[pictureAt(i)].image, options_.width, options_.height));
    }

  private:
    /// The last picture that came before the end of the moment.
    std::size_t pictureAt(std::size_t camera) const {
        if (drawsEach(options_)) return camera;
        const double end = static_cast<double>(camera + 1) / options_.framesPerSecond;
        std::size_t last = 0;
        while (last + 1 < published_.size() && published_[last + 1].seconds <= end) ++last;
        return last;
    }

    Moment at(std::size_t camera) const {
        const std::size_t index = pictureAt(camera);
        const Published& picture = published_[index];
        Moment moment;
        moment.camera = static_cast<int>(camera);
        const double before = drawsEach(options_) || index == 0 ? 0 : published_[index - 1].seconds;
        moment.milliseconds = 1000 * (picture.seconds - before);
        moment.drawn = 1000 * picture.drawn;
        if (!drawsEach(options_))
            moment.age =
                1000 * (static_cast<double>(camera + 1) / options_.framesPerSecond - picture.seconds);
        moment.scale = static_cast<double>(picture.image.width) / options_.width;
        moment.errors = errorsOfPair(truth_.pairOf(picture, camera));
        if (index > 0 && !picture.light.empty() && !published_[index - 1].light.empty())
            moment.errors.change = changeOfLight(published_[index - 1].light, picture.light);
        return moment;
    }

    const WalkOptions& options_;
    WalkTruth& truth_;
    const std::vector<rtcore::Camera>& cameras_;
    const std::vector<Published>& published_;
};

std::string paceOf(const std::vector<Published>& published) {
    constexpr double kLate = 0.040;
    int late = 0;
    for (std::size_t i = 1; i < published.size(); ++i)
        late += published[i].seconds - published[i - 1].seconds > kLate ? 1 : 0;
    const auto frames = static_cast<double>(published.size() - 1);
    return fmt::format("{} pictures in {:.2f} s, {:.1f} a second; {:.1f} % came later than {:.0f} ms\n",
                       frames, published.back().seconds, frames / published.back().seconds,
                       100 * late / std::max(frames, 1.0), 1000 * kLate);
}

/// How the image came to rest.
std::string restOf(const std::vector<Published>& rest, const WalkOptions& options) {
    double max = 0, sum = 0;
    for (std::size_t i = 1; i < rest.size(); ++i) {
        const test::Flip before(upsampled(rest[i - 1].image, options.width, options.height));
        const double flip = before.mean(upsampled(rest[i].image, options.width, options.height));
        max = std::max(max, flip);
        sum += flip;
    }
    return fmt::format("at rest: whole after {:.3f} s, in {} steps of mean FLIP {:.4f}, at most {:.4f}\n",
                       rest.back().seconds, rest.size() - 1,
                       sum / std::max(static_cast<double>(rest.size() - 1), 1.0), max);
}

std::vector<WalkStep> stepsOf(const std::vector<Published>& published) {
    std::vector<WalkStep> steps;
    for (const Published& picture : published)
        steps.push_back({picture.seconds, picture.detail, picture.camera});
    return steps;
}

std::vector<Published> publishedOf(const WalkOptions& options, LiveServer& server,
                                   const std::vector<rtcore::Camera>& cameras) {
    if (options.replay) return server.draw(readTrace(*options.replay));
    if (options.newSamples > 0) {
        std::vector<WalkStep> steps{{.camera = cameras.front()}};
        for (const rtcore::Camera& camera : cameras)
            steps.push_back(
                {.detail = {1, true, options.newSamples, rtcore::GatherBudget::kMaxTimes}, .camera = camera});
        std::vector<Published> published = server.draw(steps);
        published.erase(published.begin()); // the whole frame that it began with
        return published;
    }
    if (!options.fixed) return server.play(cameras);
    std::vector<Published> published = server.drawEach(cameras);
    if (published.size() != cameras.size()) throw std::runtime_error("a frame was left");
    return published;
}

app::ExitCode runWalk(const app::Arguments& arguments) {
    const WalkOptions options = readWalkOptions(arguments);
    app::useThreads(options.threads);
    const std::vector<rtcore::Camera> cameras = readCameras(options);
    LiveServer server(options);
    const std::unique_ptr<WalkTruth> truth = makeTruth(options, server, cameras);
    truth->prepare();
    if (app::stopRequested()) return app::stopExitCode(); // references that were made are kept
    const std::vector<Published> published = publishedOf(options, server, cameras);
    std::printf("%s, %d x %d, %zu cameras\n", options.scene.c_str(), options.width, options.height,
                cameras.size());
    if (options.replay || options.newSamples > 0) {
        fmt::print("the bits of all light: {:016x}\n", server.bits());
    } else if (!options.fixed) {
        std::fputs(paceOf(published).c_str(), stdout);
        std::fputs(restOf(server.rest(), options).c_str(), stdout);
    }
    if (options.trace) writeTrace(*options.trace, stepsOf(published));
    Comparison comparison(options, *truth, cameras, published);
    const std::vector<Moment> moments = comparison.run();
    if (app::stopRequested()) return app::stopExitCode();
    if (options.truth == Truth::Paths) std::fputs(tableOf(moments).c_str(), stdout);
    std::fputs(summaryOf(moments).c_str(), stdout);
    if (options.csv) writeCsv(*options.csv, moments);
    if (options.sheet) comparison.writeSheet(moments);
    if (options.pictures) comparison.writePictures();
    return app::ExitCode::Done;
}

} // namespace

} // namespace bench

int main(int argc, char** argv) {
    app::spinLittle(argv); // as the server does
    return app::runProgram(argc, argv, bench::walkSpec(), bench::runWalk);
}
