/// docs/tutorial.md, played: its commands as they stand there, in a new folder of a new user. Images are
/// small unless RT_TUTORIAL_FULL is set. The steps in the window are tried by tests/gui/tutorial_test.cpp.
#include "process/sample_scene.h"
#include "support/ipc_instance.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/platform/processes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <regex>
#include <sstream>

namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

const fs::path kSource = RT_SOURCE_FOLDER;
const std::string kInstance = "tour"; ///< of the tutorial's server

std::string replacedAll(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
    return text;
}

/// The texts between ```sh and ```.
Names shellBlocks() {
    Names blocks;
    std::istringstream page(test::readBytes(kSource / "docs" / "tutorial.md"));
    bool inside = false;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("```")) {
            inside = line == "```sh";
            if (inside) blocks.emplace_back();
        } else if (inside) {
            blocks.back() += line + "\n";
        }
    }
    return blocks;
}

/// The files that the commands say they write; of a list of frames the first.
Names outputsOf(const std::string& block) {
    static const std::regex output(
        R"((?:-o|--video|render|video start|plan|measure export|grid|save as) '?([^ '\n]+))");
    Names all;
    for (std::sregex_iterator found(block.begin(), block.end(), output), end; found != end; ++found)
        all.push_back(replacedAll((*found)[1], "####", "0001"));
    return all;
}

class Tutorial : public testing::Test {
  protected:
    void SetUp() override {
        for (const char* name : {"bin", "build/release", "home/Pictures/walk-0001.cams"})
            fs::create_directories(place() / name);
        fs::create_directory_symlink(kSource / "data", place() / "data");
        fs::create_directory_symlink(RT_PROGRAM_FOLDER, place() / "build/release/bin");
        const bool full = std::getenv("RT_TUTORIAL_FULL") != nullptr;
        addProgram("Renderer", full ? "" : " -w 96 -h 54 -a 1");
        addProgram("RTServer", full ? "" : " --resolution=96x54");
        if (!rtcore::findProgram("ffmpeg"))
            addScript("ffmpeg", "for film; do :; done\ncat > \"${film#file:}\"\n");
        actAsWindow();
    }
    void TearDown() override { run("CUI -i " + instance.name() + " exit"); }

    const fs::path& place() const { return instance.folder().path(); }

    void addScript(const std::string& name, const std::string& text) {
        test::writeText(place() / "bin" / name, "#!/bin/sh\n" + text);
        fs::permissions(place() / "bin" / name, fs::perms::owner_all);
    }
    /// The program, with options behind those that it is given.
    void addProgram(const std::string& name, const std::string& options) {
        addScript(name, "exec '" + test::programPath(name).string() + "' \"$@\"" + options + "\n");
    }

    /// The files that sections 3 and 5 have the window write.
    void actAsWindow() {
        const fs::path pictures = place() / "home/Pictures";
        fs::copy_file(kSource / "data/nave/aisle.cam", pictures / "camera-0001.cam");
        fs::copy_file(kSource / "data/nave/aisle.cam", pictures / "walk-0001.cams/000001.cam");
        fs::copy_file(kSource / "data/nave/altar.cam", pictures / "walk-0001.cams/000002.cam");
        test::writeText(pictures / "walk-0001.lst",
                        "# recording\nwalk-0001.cams/000001.cam\nwalk-0001.cams/000002.cam\n# end\n");
    }

    test::ProgramResult run(const std::string& script) {
        const std::string path = (place() / "bin").string() + ":" RT_PROGRAM_FOLDER ":/usr/bin:/bin";
        return test::runProgram("/bin/sh", {"-euc", script},
                                {.folder = place(),
                                 .environment = {{"PATH", path},
                                                 {"HOME", (place() / "home").string()},
                                                 {"RT_RENDERER", (place() / "bin/Renderer").string()}},
                                 .timeoutSeconds = 24 * 3600});
    }

    void expectContent(const std::string& name) const {
        const fs::path file = place() / name;
        ASSERT_TRUE(fs::exists(file)) << name;
        EXPECT_GT(fs::file_size(file), 0U) << name;
        if (file.extension() != ".png") return;
        const rtcore::LdrImage picture = rtcore::readLdrImage(file);
        const auto differs = [&](const rtcore::Rgba8& pixel) { return !(pixel == picture.pixels.front()); };
        EXPECT_TRUE(std::any_of(picture.pixels.begin(), picture.pixels.end(), differs))
            << name << " is empty";
    }

    test::IpcInstance instance;
};

TEST_F(Tutorial, CommandsDoWhatItSays) {
    if (!fs::exists(kSource / "data/nave/generated/nave.glb"))
        GTEST_SKIP() << "scripts/make_data.sh has not made the nave yet";
    const Names blocks = shellBlocks();
    ASSERT_GE(blocks.size(), 4U);
    std::size_t outputs = 0;
    for (const std::string& block : blocks) {
        if (block.find("bin/GUI ") != std::string::npos) continue; // the window has a test of its own
        SCOPED_TRACE(block);
        const bool serves = block.find("RTServer ") != std::string::npos;
        EXPECT_EQ(serves, block.find(" -i " + kInstance) != std::string::npos);
        const test::ProgramResult result =
            run(replacedAll(block, " -i " + kInstance, " -i " + instance.name()));
        ASSERT_EQ(result.exitCode, 0) << result.error;
        for (const std::string& output : outputsOf(block)) {
            expectContent(output);
            ++outputs;
        }
    }
    EXPECT_GE(outputs, 11U);
}

} // namespace
