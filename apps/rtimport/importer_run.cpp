#include "rtimport/importer_run.h"

#include "common/process/stop.h"
#include "common/process/threads.h"

#include "rtcore/io/bsp/bsp_file.h"
#include "rtcore/io/import/importer_exit.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/processes.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace importer {

namespace {

using rtcore::ImporterExit;

struct Arguments {
    std::int64_t parent = 0;
    std::uint64_t memory = 0;
    float crease = 40;
    float deflection = 0; ///< 0 = the reader's own
    rtcore::PoseChoice pose;
    int threads = 0;
    bool flip = false; ///< textures stand on their heads
    std::string input, output;
};

const char* const kUsage =
    "Usage: rtimport [--parent PID] [--memory BYTES] [--crease DEGREES] [--flip 0|1] [--deflection F] "
    "[--pose rest|first|NAME@SECONDS] [--threads N] MODEL OUTPUT.bsp\n"
    "Reads a 3D model and writes it as a .bsp without a tree; BSPBuilder makes one with a "
    "tree. The report goes to standard output.\n";

/// False when the command line is wrong.
bool parse(int argc, char** argv, Arguments& arguments) {
    std::vector<std::string> files;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const char* const value = i + 1 < argc ? argv[i + 1] : "";
        if (word == "--") {
            files.insert(files.end(), argv + i + 1, argv + argc);
            break;
        }
        if (word == "--parent") {
            arguments.parent = std::strtoll(value, nullptr, 10);
        } else if (word == "--memory") {
            arguments.memory = std::strtoull(value, nullptr, 10);
        } else if (word == "--crease") {
            arguments.crease = std::strtof(value, nullptr);
        } else if (word == "--deflection") {
            arguments.deflection = std::strtof(value, nullptr);
        } else if (word == "--pose") {
            const auto pose = rtcore::readPose(value);
            if (!pose) return false;
            arguments.pose = *pose;
        } else if (word == "--threads") {
            arguments.threads = static_cast<int>(std::strtol(value, nullptr, 10));
        } else if (word == "--flip") {
            arguments.flip = std::strcmp(value, "1") == 0;
        } else {
            files.push_back(word);
            continue;
        }
        ++i;
    }
    if (files.size() != 2) return false;
    arguments.input = files[0];
    arguments.output = files[1];
    return true;
}

void limitSelf(const Arguments& arguments) {
    // Libraries and the heap's reserve take address space without using memory.
    constexpr std::uint64_t kReserve = 512'000'000;
    rtcore::disableCoreDumps();
    if (arguments.parent != 0) rtcore::dieWithParent(arguments.parent);
    if (arguments.memory != 0) rtcore::limitAddressSpace(arguments.memory + kReserve);
}

/// The parent counts the seconds since the last word. Not for each of a million parts.
void sayAlive() {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds kPause{50};
    static Clock::time_point next;
    const Clock::time_point now = Clock::now();
    if (now < next) return;
    next = now + kPause;
    std::fputs("alive\n", stdout);
    std::fflush(stdout);
}

void importModel(const Arguments& arguments, Reader read) {
    rtcore::FileImportOptions options;
    options.creaseAngle = arguments.crease;
    if (arguments.deflection > 0) options.deflection = arguments.deflection;
    options.pose = arguments.pose;
    options.memoryLimit = arguments.memory;
    options.alive = sayAlive;
    rtcore::FileImport result = read(arguments.input, options);
    if (arguments.flip) {
        for (rtcore::Vec2& t : result.model.texcoords) t.y = 1 - t.y;
        for (rtcore::Vec2& t : result.model.furtherTexcoords) t.y = 1 - t.y;
    }
    rtcore::writeBsp(arguments.output, rtcore::makeModel(std::move(result.model)), nullptr, {});
    std::fputs(rtcore::writeReport(result.report).c_str(), stdout);
    std::fflush(stdout);
    // Freeing a million small arrays one by one takes a tenth of the time of the whole import.
    std::_Exit(static_cast<int>(ImporterExit::Done));
}

/// For people, and for the parent, whose own may read another language.
ImporterExit complain(const std::exception& error, ImporterExit code) {
    std::fprintf(stderr, "%s\n", error.what());
    std::fputs(rtcore::refusalLine(rtcore::sentenceOf(error)).c_str(), stdout);
    std::fflush(stdout);
    return code;
}

ImporterExit run(const Arguments& arguments, Reader read) {
    try {
        limitSelf(arguments);
        app::useThreads(arguments.threads);
        importModel(arguments, read);
        return ImporterExit::Done;
    } catch (const rtcore::FileError& error) {
        const bool write = error.kind == rtcore::FailureKind::CannotWrite;
        return complain(error, write ? ImporterExit::CannotWrite : ImporterExit::BadData);
    } catch (const std::bad_alloc&) {
        std::fputs("there is not enough memory\n", stderr);
        return ImporterExit::NoMemory;
    } catch (const std::exception& error) {
        return complain(error, ImporterExit::BadData);
    }
}

} // namespace

int runImporter(int argc, char** argv, Reader read) {
    app::ignoreWritingSignals();
    Arguments arguments;
    if (!parse(argc, argv, arguments)) {
        std::fputs(kUsage, stderr);
        return static_cast<int>(ImporterExit::Usage);
    }
    return static_cast<int>(run(arguments, read));
}

} // namespace importer
