/// The types of our files, as desktops find them out: other programs' .bsp and .scn stay theirs.
#include "process/sample_scene.h"

#include "rtcore/io/bsp/bsp_layout.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace {

using namespace test;
namespace fs = std::filesystem;

// Whom we share names with in shared-mime-info.
const char* const kOthers = R"(<?xml version="1.0"?>
<mime-info xmlns="http://www.freedesktop.org/standards/shared-mime-info">
  <mime-type type="application/x-godot-scene">
    <glob pattern="*.scn"/><magic><match type="string" value="[gd_scene " offset="0"/></magic>
  </mime-type>
  <mime-type type="application/toml"><sub-class-of type="text/plain"/><glob pattern="*.toml"/></mime-type>
</mime-info>
)";

class MimeTypes : public testing::Test {
  protected:
    void SetUp() override {
        if (!fs::exists("/usr/bin/update-mime-database")) GTEST_SKIP() << "there is no update-mime-database";
        if (!fs::exists("/usr/bin/gio")) GTEST_SKIP() << "there is no gio";
        const fs::path packages = folder / "mime" / "packages";
        fs::create_directories(packages);
        fs::copy_file(fs::path(RT_SOURCE_FOLDER) / "packaging" / "rtsuite-mime.xml",
                      packages / "rtsuite.xml");
        writeText(packages / "others.xml", kOthers);
        ProgramSettings quick;
        quick.environment = {{"PKGSYSTEM_ENABLE_FSYNC", "0"}};
        const ProgramResult made =
            runProgram("/usr/bin/update-mime-database", {(folder / "mime").string()}, quick);
        ASSERT_EQ(made.exitCode, 0) << made.error;
        EXPECT_EQ(made.error.find("rtsuite.xml"), std::string::npos) << made.error;
    }
    std::string typeOf(const std::string& name, const std::string& content) {
        writeText(folder / name, content);
        ProgramSettings settings;
        settings.environment = {{"XDG_DATA_HOME", folder.path().string()},
                                {"XDG_DATA_DIRS", folder.path().string()}};
        const std::string text =
            runProgram("/usr/bin/gio", {"info", "-a", "standard::content-type", (folder / name).string()},
                       settings)
                .output;
        const std::string label = "standard::content-type: ";
        const std::size_t begin = text.find(label);
        if (begin == std::string::npos) return "";
        return text.substr(begin + label.size(), text.find('\n', begin) - begin - label.size());
    }

    TemporaryFolder folder;
};

TEST_F(MimeTypes, AreToldByTheContentWhereTheNameIsShared) {
    const std::string magic(reinterpret_cast<const char*>(rtcore::kBspMagic.data()),
                            rtcore::kBspMagic.size());
    EXPECT_EQ(typeOf("a.bsp", magic + std::string(40, '\0')), "application/x-rtsuite-bsp");
    EXPECT_NE(typeOf("quake.bsp", std::string("IBSP\x2E\0\0\0", 8)), "application/x-rtsuite-bsp");
    EXPECT_EQ(typeOf("a.scn", "# a scene\nversion = 1\nmodel = \"room.obj\"\n"),
              "application/x-rtsuite-scene");
    EXPECT_EQ(typeOf("space.scn", std::string("Caligari V00.01BLH\0\1", 20)),
              "application/x-truespace-scene");
    EXPECT_EQ(typeOf("game.scn", "[gd_scene load_steps=2 format=3]\n"), "application/x-godot-scene");
    EXPECT_EQ(typeOf("other.toml", "version = 1\nmodel = \"a\"\n"), "application/toml");
    EXPECT_NE(typeOf("other.lock", "version = 3\n[[package]]\n"), "application/x-rtsuite-scene");
}

TEST_F(MimeTypes, OfCamerasAndSettings) {
    EXPECT_EQ(typeOf("a.cam", "version = 1\neye = [0, 0, 0]\n"), "application/x-rtsuite-camera");
    EXPECT_EQ(typeOf("a.set", "version = 1\n[live]\n"), "application/x-rtsuite-settings");
}

TEST_F(MimeTypes, OfTheScenesThatAreInstalled) {
    const fs::path data = fs::path(RT_SOURCE_FOLDER) / "data";
    for (const char* scene : {"nave", "mirrors", "organic"}) {
        const std::string name = std::string(scene) + ".scn";
        EXPECT_EQ(typeOf(name, readBytes(data / scene / name)), "application/x-rtsuite-scene") << name;
    }
}

} // namespace
