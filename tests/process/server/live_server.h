/// An RTServer of a test's own, and CUI to command it.
#pragma once

#include "process/sample_scene.h"
#include "support/ipc_instance.h"
#include "support/run_program.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace test {

using Names = std::vector<std::string>;

/// Fixture: a folder with room.obj, an instance name, and at most one server.
class LiveServer : public testing::Test {
  protected:
    void SetUp() override { writeRoom(folder() / "room.obj"); }

    /// Starts a server and waits for its first frame.
    void start(const Names& options = {}, const std::string& scene = "room.obj") {
        run(options, scene);
        ASSERT_TRUE(server->waitForError("ready: ")) << server->wait().error;
    }
    void run(const Names& options = {}, const std::string& scene = "room.obj") {
        Names words{scene, "--instance=" + instance.name(), "--resolution=64x48"};
        words.insert(words.end(), options.begin(), options.end());
        server.emplace(programPath("RTServer"), words, ProgramSettings{.folder = folder().path()});
    }
    ProgramResult end(int signal) {
        server->send(signal);
        return server->wait();
    }

    ProgramResult cui(const Names& words) const {
        Names all{"--instance=" + instance.name()};
        all.insert(all.end(), words.begin(), words.end());
        return runProgram(programPath("CUI"), all, {.folder = folder().path(), .timeoutSeconds = 60});
    }
    /// Must succeed; its output.
    std::string ask(const Names& words) const {
        const ProgramResult result = cui(words);
        EXPECT_EQ(result.exitCode, 0) << testing::PrintToString(words) << result.error;
        EXPECT_EQ(result.error, "");
        return result.output;
    }
    /// Must fail with that exit code and a message that holds `text`.
    void refused(const Names& words, int exitCode, const std::string& text) const {
        const ProgramResult result = cui(words);
        EXPECT_EQ(result.exitCode, exitCode) << testing::PrintToString(words) << result.error;
        EXPECT_EQ(result.output, "");
        EXPECT_EQ(result.error.rfind("CUI: ", 0), 0U) << result.error;
        EXPECT_NE(result.error.find(text), std::string::npos) << result.error;
    }

    const TemporaryFolder& folder() const { return instance.folder(); }
    std::string bytes(const std::string& file) const { return readBytes(folder() / file); }

    IpcInstance instance;
    std::optional<RunningProgram> server;
};

} // namespace test
