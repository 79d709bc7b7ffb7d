#include "bspbuilder/builder_run.h"

#include "bspbuilder/build_report.h"
#include "bspbuilder/builder_options.h"

#include "common/cli/file_notes.h"
#include "common/cli/input_files.h"
#include "common/process/parent.h"
#include "common/process/seconds_since.h"
#include "common/process/stop.h"
#include "common/process/terminal.h"
#include "common/progress/progress.h"

#include "rtcore/accel/builder.h"
#include "rtcore/accel/validation.h"
#include "rtcore/io/bsp/bsp_checksum.h"
#include "rtcore/io/bsp/bsp_file.h"
#include "rtcore/io/bsp/bsp_layout.h"
#include "rtcore/io/images/image_format.h"
#include "rtcore/io/import/model_import.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <chrono>
#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace bspbuilder {

namespace {

using Clock = std::chrono::steady_clock;

// A .bsp of another format's ending would be taken for a damaged file of that format.
void refuseForeignEnding(const std::filesystem::path& output) {
    std::string ending = rtcore::extensionOf(output);
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    std::vector<std::string> foreign = app::modelExtensions();
    foreign.insert(foreign.end(), {"scn", "cam", "set", "mtl", "bin", "lst"});
    if (rtcore::findFormat(ending) == nullptr &&
        std::find(foreign.begin(), foreign.end(), ending) == foreign.end())
        return;
    throw app::UsageError("the output is a .bsp file, but " + output.string() +
                          " has the ending of another kind; name it " +
                          std::filesystem::path(output).replace_extension(".bsp").string());
}

// Nothing that might be precious is overwritten: neither the input nor any file that is no .bsp.
void checkOutput(const std::filesystem::path& input, const std::filesystem::path& output) {
    app::InputFiles inputs;
    inputs.add(input);
    inputs.refuse(output);
    refuseForeignEnding(output);
    std::error_code missing;
    const auto refuse = [&](const rtcore::Sentence& reason) {
        throw rtcore::FileError(rtcore::FailureKind::CannotWrite, output.string(), reason);
    };
    const std::filesystem::path folder = output.parent_path();
    if (!folder.empty() && !std::filesystem::is_directory(folder, missing)) {
        refuse(rtcore::say("there is no folder {0}; make it first", folder.string()));
    }
    if (std::filesystem::is_directory(output, missing)) refuse("this is a folder; name a file in it");
    if (!std::filesystem::is_regular_file(output, missing) ||
        std::filesystem::file_size(output, missing) == 0)
        return;
    std::array<char, 8> head{};
    std::ifstream(output, std::ios::binary).read(head.data(), head.size());
    if (!rtcore::isBsp(std::as_bytes(std::span(head)))) {
        refuse("there is a file of this name that is no .bsp file; remove it, or name another");
    }
}

[[noreturn]] void refuseInput(const BuilderOptions& options, const char* reason) {
    throw rtcore::FileError(rtcore::FailureKind::BadData, options.input.string(), reason);
}

void refuseBsp(const BuilderOptions& options) {
    if (rtcore::isBsp(rtcore::InputFile(options.input).head(rtcore::kBspMagic.size())))
        refuseInput(options,
                    rtcore::form("this is a .bsp file already; build from the model that it was made of"));
}

// Tells a file from what takes its place, or is written into it.
struct FileState {
    std::optional<rtcore::FileIdentity> file;
    std::uintmax_t size;
    std::filesystem::file_time_type written;
    friend bool operator==(const FileState&, const FileState&) = default;
};
FileState stateOf(const std::filesystem::path& path) {
    std::error_code unknown;
    return {rtcore::identityOf(path), std::filesystem::file_size(path, unknown),
            std::filesystem::last_write_time(path, unknown)};
}

// The model's file and the options that the .bsp is made from.
rtcore::BspIdentity identify(const BuilderOptions& options) {
    const rtcore::FileBytes file = rtcore::openFileBytes(options.input);
    return {file.bytes.size(), rtcore::crc32Of(file.bytes), buildOptionsHash(options)};
}

class Builder {
  public:
    Builder(const BuilderOptions& options, app::Progress& progress)
        : options_(options), progress_(progress) {}

    app::ExitCode run() {
        checkOutput(options_.input, options_.output);
        refuseBsp(options_);
        const FileState imported = stateOf(options_.input);
        import();
        // All of the file is read for it, and so only where it is a model.
        const rtcore::BspIdentity identity = identify(options_);
        if (stateOf(options_.input) != imported)
            refuseInput(options_, rtcore::form("it was changed while it was read; build again"));
        buildTree();
        write(identity);
        return tell();
    }

  private:
    void import() {
        const auto start = Clock::now();
        std::atomic<bool> stop{false};
        rtcore::ImportOptions import = options_.import;
        import.stop = &stop;
        const app::ProgressScope scope(progress_, {"importing", {}, &stop});
        rtcore::ImportedModel imported = rtcore::importModel(options_.input, import);
        report_.importSeconds = app::secondsSince(start);
        for (const rtcore::Sentence& warning : imported.report.warnings) {
            const rtcore::Sentence ofFile = rtcore::say("{0}: {1}", options_.input.string(), warning);
            progress_.tell(rtcore::say("warning: {0}", ofFile));
            warnings_.push_back(rtcore::warningLine(warning));
        }
        model_ = std::move(imported.model);
        report_.degenerate = imported.report.degenerateTriangles;
        report_.nonFinite = imported.report.nonFiniteTriangles;
        report_.unconnected = imported.report.unconnectedTriangles;
        report_.equal = imported.report.equalTriangles;
        report_.primitives = imported.report.ignoredPrimitives;
        report_.format = imported.report.origin.format;
        origin_ = std::move(imported.report.origin);
        if (import.up) origin_.up = import.up;
        if (import.metresPerUnit) origin_.metresPerUnit = import.metresPerUnit;
        app::throwIfStopped();
    }

    void buildTree() {
        rtcore::BuildProgress build;
        const auto fraction = [&build] {
            const std::uint64_t all = build.triangles.load();
            return all == 0 ? 0.0 : static_cast<double>(build.finished.load()) / static_cast<double>(all);
        };
        const app::ProgressScope scope(progress_, {"building the tree", fraction, &build.cancel});
        try {
            tree_ = rtcore::buildKdTree(model_.mesh, options_.build, &report_.build, &build);
        } catch (const rtcore::BuildCancelled&) {
            throw rtcore::FileError(rtcore::FailureKind::Stopped, "", "stopped");
        }
        app::throwIfStopped();
    }

    void write(const rtcore::BspIdentity& identity) {
        const auto start = Clock::now();
        const app::ProgressScope scope(progress_, {"writing", {}, nullptr});
        rtcore::writeBsp(options_.output, model_, &tree_, identity, warnings_, origin_);
        report_.writeSeconds = app::secondsSince(start);
    }

    app::ExitCode tell() {
        fillReport();
        const bool very = options_.verbosity == Verbosity::VeryVerbose;
        if (options_.verbosity != Verbosity::Quiet) app::writeOutput(describeModel(report_));
        if (!very && !options_.histogramBands) return app::ExitCode::Done;

        const rtcore::KdStatistics statistics = measure();
        TreeVerdict verdict;
        if (very) {
            verdict = check();
            app::writeOutput(describeTree(report_, statistics, verdict));
        }
        if (options_.histogramBands) app::writeOutput(describeLeaves(statistics, *options_.histogramBands));
        return verdict.sound() ? app::ExitCode::Done : app::ExitCode::Failed;
    }

    void fillReport() {
        report_.triangles = model_.mesh.triangles.size();
        report_.vertices = model_.mesh.vertices.size();
        report_.materials = model_.materials.size();
        report_.textures = model_.textures.size();
        report_.lights = model_.lights.size();
        report_.cameras = model_.cameras.size();
        std::error_code unknown;
        const std::uintmax_t size = std::filesystem::file_size(options_.output, unknown);
        report_.fileBytes = unknown ? 0 : size;
        report_.peakBytes = app::peakMemoryBytes();
    }

    rtcore::KdStatistics measure() const {
        const rtcore::BuildOptions& build = options_.build;
        const float intersection = build.intersectionCost > 0
                                       ? build.intersectionCost
                                       : rtcore::automaticIntersectionCost(model_.mesh.triangles.size());
        return rtcore::computeStatistics(tree_, build.traversalCost, intersection);
    }

    TreeVerdict check() {
        const app::ProgressScope scope(progress_, {"checking the tree", {}, nullptr});
        const auto start = Clock::now();
        TreeVerdict verdict;
        verdict.structure = rtcore::validateKdTree(tree_, model_.mesh.triangles.size());
        if (!verdict.structure) verdict.coverage = rtcore::validateCoverage(tree_, model_.mesh);
        verdict.seconds = app::secondsSince(start);
        return verdict;
    }

    const BuilderOptions& options_;
    app::Progress& progress_;
    rtcore::Model model_;
    std::vector<std::string> warnings_; ///< lines of the .bsp
    rtcore::ModelOrigin origin_;
    rtcore::KdTree tree_;
    BuildReport report_;
};

} // namespace

app::ExitCode runBuilder(const app::Arguments& arguments) {
    const BuilderOptions options = readBuilderOptions(arguments);
    if (options.parent) app::stopWithParent(*options.parent);
    app::Progress progress(builderSpec().name, options.progress);
    if (arguments.has("quality") && !arguments.has("fast"))
        progress.tell(rtcore::say("warning: {0}", rtcore::form("--quality counts with --fast only")));
    return Builder(options, progress).run();
}

} // namespace bspbuilder
