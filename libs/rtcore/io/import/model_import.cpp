#include "rtcore/io/import/model_import.h"

#include "rtcore/io/bsp/bsp_file.h"
#include "rtcore/io/import/exchange_folder.h"
#include "rtcore/io/import/importer_exit.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/files.h"
#include "rtcore/platform/processes.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>

namespace rtcore {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kGigabyte = 1'000'000'000;

/// Says at once what no importer needs to be asked about.
void refuseNoModel(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) {
        throw FileError(FailureKind::NoInput, path.string(), "there is no such file; check the path");
    }
    if (!fs::is_regular_file(status)) {
        throw FileError(FailureKind::NoInput, path.string(), "it is not a file; give the path of a model");
    }
    if (InputFile(path).head(1).empty()) {
        throw FileError(FailureKind::BadData, path.string(), "it is empty; export the model again");
    }
}

fs::path importerProgram() {
    // The environment does not change while models are loaded.
    const char* const chosen = std::getenv("RT_IMPORTER"); // NOLINT(concurrency-mt-unsafe)
    return chosen != nullptr && *chosen != '\0' ? fs::path(chosen) : helperProgram("rtimport");
}

/// The importer's last message: libraries may have complained before.
Sentence lastLine(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    const std::size_t end = text.rfind('\n');
    if (end != std::string::npos) text.erase(0, end + 1);
    return text.empty() ? form("no reason given") : Sentence(text);
}

Sentence reasonOf(const ProcessResult& result) {
    return readRefusal(result.output).value_or(lastLine(result.errors));
}

[[noreturn]] void refuse(const fs::path& path, const Sentence& message,
                         FailureKind kind = FailureKind::BadData) {
    throw FileError(kind, path.string(), message);
}

[[noreturn]] void refuseToExport(const fs::path& path, const Sentence& problem) {
    refuse(path,
           say("{0}; open it in the program that wrote it and export it again, as glTF or OBJ for example",
               problem));
}

[[noreturn]] void refuseForMemory(const fs::path& path, const ProcessLimits& limits) {
    refuse(path, say("reading it takes more than the {0} MB of memory that the importer may use; raise that "
                     "(--memory-limit) if the model and its images are that large, else simplify it or "
                     "export it again",
                     limits.memory / 1'000'000));
}

[[noreturn]] void refuseForTime(const fs::path& path, const ProcessLimits& limits) {
    refuse(path,
           say("the importer got no further for {0} seconds and was ended; raise the time limit when the "
               "model is that large, else simplify it or export it again",
               fmt::format("{:g}", limits.silence)));
}

void throwExit(const fs::path& path, const ProcessResult& result, const ProcessLimits& limits) {
    switch (static_cast<ImporterExit>(result.code)) {
    case ImporterExit::Done:
        return;
    case ImporterExit::BadData:
        refuse(path, reasonOf(result));
    case ImporterExit::NoMemory:
        refuseForMemory(path, limits);
    case ImporterExit::CannotWrite:
        refuse(path, reasonOf(result), FailureKind::CannotWrite);
    case ImporterExit::Usage:
        break;
    }
    refuseToExport(path,
                   say("the importer failed (exit code {0}: {1})", result.code, lastLine(result.errors)));
}

void throwFailure(const fs::path& path, const ProcessResult& result, const ProcessLimits& limits) {
    switch (result.end) {
    case ProcessEnd::Exited:
        throwExit(path, result, limits);
        return;
    case ProcessEnd::Signalled:
        refuseToExport(path, say("the importer crashed (signal {0}, {1}) while reading it", result.code,
                                 signalName(result.code)));
    case ProcessEnd::MemoryLimit:
        refuseForMemory(path, limits);
    case ProcessEnd::SilenceLimit:
        refuseForTime(path, limits);
    case ProcessEnd::Stopped:
        refuse(path, "the import was stopped", FailureKind::Stopped);
    }
}

/// For names that this suite gives its own files: what may really be wrong with them.
void explainOwnFormats(const fs::path& path) {
    if (path.extension() == ".bsp") {
        refuse(path,
               "it is no .bsp of this suite, or its beginning is damaged; build it again with BSPBuilder");
    }
    if (path.extension() == ".scn" || path.extension() == ".cam" || path.extension() == ".set") {
        refuse(path, "it is no model; give the model or .bsp itself");
    }
}

} // namespace

ImportLimits importLimits(const fs::path& path, const ImportOptions& options) {
    const std::uint64_t size = storedBytes(path);
    // A file that names no buffers of its own is read within this time or never.
    const bool tiny = size < kTinyModel && path.extension() != ".gltf" && path.extension() != ".GLTF";
    const double seconds =
        tiny ? kTinyModelSeconds : kImportSeconds + kImportSecondsPerByte * static_cast<double>(size);
    return {options.memoryLimit > 0 ? options.memoryLimit : machineMemory() / 2,
            options.timeLimit > 0 ? options.timeLimit : seconds};
}

ImportedModel importModel(const fs::path& path, const ImportOptions& options) {
    refuseNoModel(path);
    const ImportLimits max = importLimits(path, options);
    const ProcessLimits limits{.memory = max.memory, .silence = max.seconds, .stop = options.stop};
    const fs::path importer = importerProgram();
    std::error_code error;
    if (!fs::exists(importer, error)) {
        refuse(importer,
               "the importer program is missing; install it beside this program or name it in RT_IMPORTER",
               FailureKind::NoInput);
    }
    // Triangles take about four times their room in a compact file; images are unpacked.
    const ExchangeFolder folder(kGigabyte + 6 * storedBytes(path));
    const fs::path exchanged = folder.path() / "model.bsp";
    const ProcessResult result = runProcess(
        importer,
        {"--parent", fmt::format("{}", processId()), "--memory", fmt::format("{}", limits.memory), "--crease",
         fmt::format("{:f}", options.creaseAngle.value_or(kCreaseAngle)), "--flip",
         options.flipTextures.value_or(false) ? "1" : "0", "--pose",
         poseText(options.pose.value_or(PoseChoice{})), "--threads", fmt::format("{}", options.threads),
         "--deflection", fmt::format("{:g}", options.deflection.value_or(kDeflection)), "--",
         fs::absolute(path).string(), exchanged.string()},
        limits);
    try {
        throwFailure(path, result, limits);
    } catch (const FileError& failure) {
        if (failure.kind == FailureKind::BadData) explainOwnFormats(path);
        throw;
    }
    ImportedModel imported;
    try {
        imported.model = readBsp(exchanged).model;
    } catch (const FileError& damage) {
        refuseToExport(path,
                       say("the importer handed over a model that cannot be used ({0})", damage.sentence()));
    }
    if (imported.model.mesh.triangles.empty())
        refuse(path, "it holds no triangles; give a model with surfaces");
    imported.report = readReport(result.output);
    return imported;
}

} // namespace rtcore
