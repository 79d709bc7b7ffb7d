/// The installed programs, in a folder that was moved since: everything is found relative to the program, and
/// is everybody's to read, whatever the umask of who installed it.
#include "process/sample_scene.h"
#include "support/ipc_instance.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace {

using namespace test;
namespace fs = std::filesystem;

#ifdef RT_HAS_BRIDGE
constexpr bool kHasBridge = true;
#else
constexpr bool kHasBridge = false;
#endif

void expectOpenToAll(const fs::path& prefix) {
    constexpr auto kRead = fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read;
    constexpr auto kRun = fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec;
    EXPECT_EQ(fs::status(prefix).permissions(), kRead | kRun | fs::perms::owner_write);
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(prefix)) {
        const fs::path place = entry.path().parent_path().filename();
        const bool runs = entry.is_directory() || place == "bin" ||
                          entry.path().filename().string().starts_with("rtimport");
        const auto wanted = kRead | fs::perms::owner_write | (runs ? kRun : fs::perms::none);
        EXPECT_EQ(entry.status().permissions(), wanted) << entry.path();
    }
}

TEST(Installation, WorksWhereverItIsMoved) {
    const IpcInstance instance;
    const TemporaryFolder& folder = instance.folder();
    const ProgramResult installed =
        runProgram("/bin/sh", {"-c", "umask 077 && exec \"$@\"", "sh", RT_CMAKE, "--install", RT_BUILD_FOLDER,
                               "--prefix", (folder / "first").string()});
    ASSERT_EQ(installed.exitCode, 0) << installed.error;
    fs::rename(folder / "first", folder / "moved here");
    const fs::path prefix = folder / "moved here", bin = prefix / "bin";
    expectOpenToAll(prefix);

    for (const char* program : {"BSPBuilder", "CUI", "RTServer", "Renderer"})
        EXPECT_TRUE(fs::exists(bin / program)) << program;
    EXPECT_EQ(fs::exists(bin / "RTBridge"), kHasBridge);
    const std::string fetch = "rtsuite-fetch-nets"; // a script
    EXPECT_EQ(runProgram(bin / fetch, {"--help"}).exitCode, 0);
    for (const std::string& program : filesIn(bin)) {
        if (program == fetch) continue;
        EXPECT_EQ(runProgram(bin / program, {"--version"}).exitCode, 0) << program;
        EXPECT_TRUE(fs::exists(prefix / "share" / "bash-completion" / "completions" / program)) << program;
        const fs::path page = prefix / "share" / "man" / "man1" / (program + ".1");
        EXPECT_TRUE(fs::exists(page) || fs::exists(page.string() + ".gz")) << program;
    }
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(prefix))
        EXPECT_NE(entry.path().extension(), ".tza") << "weights are no part of a package";
    for (const char* file : {"share/mime/packages/rtsuite.xml", "share/doc/rtsuite/copyright",
                             "share/rtsuite/scenes/nave/nave.scn", "share/rtsuite/scenes/nave/rose.cam"}) {
        EXPECT_TRUE(fs::exists(prefix / file)) << file;
    }

    const ProgramSettings here{.folder = folder.path()};
    writeRoom(folder / "room.obj");
    ProgramResult result = runProgram(bin / "BSPBuilder", {"room.obj", "room.bsp", "--progress=none"}, here);
    EXPECT_EQ(result.exitCode, 0) << result.error;
    result = runProgram(bin / "Renderer",
                        {"room.bsp", "-o", "a.png", "-w", "16", "-h", "9", "--progress=none"}, here);
    EXPECT_EQ(result.exitCode, 0) << result.error;
    RunningProgram server(bin / "RTServer",
                          {"room.obj", "--instance=" + instance.name(), "--resolution=16x9"}, here);
    ASSERT_TRUE(server.waitForError("ready: ")) << server.wait().error;
    for (const std::vector<std::string>& command :
         std::vector<std::vector<std::string>>{{"wait-idle"}, {"render", "b.png"}, {"exit"}}) {
        std::vector<std::string> words{"--instance=" + instance.name()};
        words.insert(words.end(), command.begin(), command.end());
        result = runProgram(bin / "CUI", words, here);
        EXPECT_EQ(result.exitCode, 0) << command.front() << ": " << result.error;
    }
    EXPECT_EQ(pngFileSize(folder / "b.png"), (PictureSize{16, 9}));
    EXPECT_EQ(server.wait().exitCode, 0);

    const fs::path scenes = prefix / "share" / "rtsuite" / "scenes";
    if (!fs::exists(scenes / "mirrors" / "generated" / "mirrors.glb"))
        GTEST_SKIP() << "scripts/make_data.sh has not been run: no scene was installed with its model";
    result = runProgram(bin / "Renderer",
                        {(scenes / "mirrors" / "mirrors.scn").string(), "-o", "mirrors.png", "-w", "16", "-h",
                         "9", "-a", "1", "--progress=none"},
                        here);
    EXPECT_EQ(result.exitCode, 0) << result.error;
}

} // namespace
