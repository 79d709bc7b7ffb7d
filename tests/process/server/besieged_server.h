/// An RTServer among visitors that are killed, stopped and badly behaved, and the server with them.
#pragma once

#include "process/ipc/troupe.h"
#include "process/sample_scene.h"

#include "ipc/endpoint/client.h"
#include "ipc/endpoint/viewer.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

namespace test {

/// Participant 0 is RTServer. Its scene is a triangle too small to be seen before a grey background, so that
/// every whole frame has one colour.
class Besieged : public testing::Test {
  protected:
    void SetUp() override {
        writeText(folder() / "speck.obj", "v 0 0 0\nv 1e-4 0 0\nv 0 1e-4 0\nf 1 2 3\n");
        writeText(folder() / "grey.scn",
                  "version = 1\nmodel = \"speck.obj\"\nbackground = [0.25, 0.5, 0.75]\n"
                  "[camera]\neye = [0.0, 0.0, 1000.0]\nforward = [0.0, 0.0, 1.0]\n"
                  "[live]\nexposure.mode = \"fixed\"\nexposure.value = 1.0\ndithering = false\n");
    }
    void TearDown() override {
        if (HasFailure()) std::printf("what RTServer printed:\n%.4000s\n", log().c_str());
    }

    ChildProcess newServer(const std::vector<std::string>& options = {}, ChildSettings settings = {}) const {
        std::vector<std::string> words{(folder() / "grey.scn").string(),
                                       "--instance=" + troupe.instance.name(), "--resolution=64x48",
                                       "--threads=1", "--fps-limit=300"};
        words.insert(words.end(), options.begin(), options.end());
        settings.outputFile = logFile();
        return {programPath("RTServer").string(), words, settings};
    }
    /// Starts it, in the place of a dead one too, and waits for its first frame.
    bool stands(const std::vector<std::string>& options = {}, const ChildSettings& settings = {}) {
        troupe.put(0, newServer(options, settings));
        return eventually([&] { return showsFrames(); }, 20s);
    }
    /// The server that runs now has drawn a frame.
    bool showsFrames() {
        if (!viewer && !meetServer()) return false;
        viewer->update();
        return viewer->serverProcess() == troupe[0].process() && viewer->readFrame(frame);
    }
    ProgramResult cui(const std::vector<std::string>& words) const {
        std::vector<std::string> all{"--instance=" + troupe.instance.name()};
        all.insert(all.end(), words.begin(), words.end());
        return runProgram(programPath("CUI"), all, {.folder = folder().path(), .timeoutSeconds = 60});
    }
    std::uint64_t frames(Clock::duration time) {
        viewer->readFrame(frame);
        const std::uint64_t before = frame.info.number;
        std::this_thread::sleep_for(time);
        viewer->readFrame(frame);
        return frame.info.number - before;
    }
    /// Ends in good order, and leaves nothing in shared memory.
    void expectGoodEnd() {
        for (int i = troupe.size() - 1; i > 0; --i) troupe[i].kill();
        troupe[0].send(SIGTERM);
        const int status = troupe[0].wait(5s);
        ASSERT_TRUE(status != -1 && WIFEXITED(status)) << status;
        EXPECT_EQ(WEXITSTATUS(status), 143);
        EXPECT_EQ(troupe.instance.segments(), std::vector<std::string>());
    }
    void expectNothingWrong() {
        EXPECT_EQ(troupe.sum(&Counters::torn), 0U);
        EXPECT_EQ(troupe.sum(&Counters::wrong), 0U);
    }
    /// All but the server, which has no counters of its own.
    std::vector<int> visitors() const {
        std::vector<int> all;
        for (int i = 1; i < troupe.size(); ++i) all.push_back(i);
        return all;
    }

    const TemporaryFolder& folder() const { return troupe.instance.folder(); }
    std::string logFile() const { return (folder() / "server.log").string(); }
    std::string log() const { return readBytes(logFile()); }

    Troupe troupe;
    std::unique_ptr<ipc::Viewer> viewer;
    ipc::Frame frame;

  private:
    bool meetServer() {
        try {
            viewer = std::make_unique<ipc::Viewer>(troupe.instance.name(), 1ms);
            return true;
        } catch (const ipc::Error& error) {
            if (error.problem != ipc::Problem::NoServer) throw;
            return false;
        }
    }
};

} // namespace test
