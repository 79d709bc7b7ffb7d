/// A Renderer that shows what it renders, and the viewer who looks.
#pragma once

#include "ipc/endpoint/viewer.h"
#include "ipc/layout/control_block.h"
#include "ipc/platform/segment.h"
#include "ipc/platform/system.h"
#include "process/sample_scene.h"
#include "support/ipc_instance.h"
#include "support/run_program.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace test {

using Names = std::vector<std::string>;
using Clock = std::chrono::steady_clock;

inline double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Fixture: a folder with room.bsp, an instance name, and at most one Renderer.
class LivePreview : public testing::Test {
  protected:
    void SetUp() override {
        writeRoom(folder() / "room.obj");
        ASSERT_EQ(bspBuilder({"room.obj", "room.bsp"}, {.folder = folder().path()}).exitCode, 0);
    }

    Names words(const Names& options) const {
        Names all{"room.bsp", "--preview=" + instance.name(), "--progress=none"};
        all.insert(all.end(), options.begin(), options.end());
        return all;
    }
    void start(const Names& options) {
        program.emplace(programPath("Renderer"), words(options), ProgramSettings{.folder = folder().path()});
    }
    ProgramResult run(const Names& options) const {
        return runProgram(programPath("Renderer"), words(options), {.folder = folder().path()});
    }

    /// Waits for the Renderer to be found.
    void look() { viewer.emplace(instance.name(), std::chrono::seconds(20)); }
    /// All frames that can be caught, up to the last one of the run.
    std::vector<ipc::Frame> watch() {
        std::vector<ipc::Frame> frames;
        ipc::Frame frame;
        while (viewer->waitForFrame(frame, std::chrono::seconds(60))) {
            frames.push_back(frame);
            if (frame.info.tag == ipc::kPreviewDone) break;
        }
        return frames;
    }
    /// Polls every millisecond; false when it did not come true in time.
    static bool within(double seconds, const std::function<bool()>& happened) {
        const Clock::time_point begin = Clock::now();
        while (!happened()) {
            if (secondsSince(begin) > seconds) return false;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return true;
    }
    /// Whether the lock that proves a Renderer's life is held.
    bool alive() const {
        const auto control = ipc::Segment::open(instance.names().control(), ipc::Access::Read, 0);
        return control && control->locked(ipc::kServerLock);
    }

    const TemporaryFolder& folder() const { return instance.folder(); }

    IpcInstance instance;
    std::optional<RunningProgram> program;
    std::optional<ipc::Viewer> viewer;
};

} // namespace test
