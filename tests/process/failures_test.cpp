/// Failures that come from outside: each kind has its exit code, and no file is left behind.
#include "process/sample_scene.h"

#include "rtcore/io/text/sentence_json.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <sstream>

#include <fcntl.h>
#include <unistd.h>

namespace {

using Names = std::vector<std::string>;

class Failures : public testing::Test {
  protected:
    void expect(const test::ProgramResult& result, int code, const std::string& message) {
        EXPECT_EQ(result.exitCode, code) << result.error;
        EXPECT_EQ(result.signal, 0);
        EXPECT_EQ(result.output, "");
        EXPECT_NE(result.error.find(message), std::string::npos) << result.error;
    }
    std::string file(const std::string& name) const { return (folder / name).string(); }

    test::TemporaryFolder folder;
};

TEST_F(Failures, MissingInputs) {
    test::writeRoom(folder / "room.obj");
    expect(test::renderer({file("none.scn"), "-o", file("a.png")}), 66, "none.scn");
    expect(test::renderer({file("none.obj"), "-o", file("a.png")}), 66, "none.obj");
    expect(test::renderer({file("room.obj"), "-o", file("a.png"), "--camera", file("none.cam")}), 66,
           "none.cam");
    expect(test::renderer({file("room.obj"), "-o", file("a.png"), "--set", file("none.set")}), 66,
           "none.set");
    expect(test::renderer({file("room.obj"), "-o", file("a.png"), "-l", file("none.lst")}), 66, "none.lst");
    expect(test::bspBuilder({file("none.obj"), file("a.bsp")}), 66, "none.obj");
    EXPECT_EQ(test::filesIn(folder.path()), std::vector<std::string>{"room.obj"});
}

TEST_F(Failures, BrokenInputs) {
    test::writeRoom(folder / "room.obj");
    test::writeText(folder / "bad.glb", "glTF and then nonsense");
    test::writeText(folder / "bad.scn", "version = 1\nmodle = \"room.obj\"\n");
    test::writeText(folder / "bad.set", "version = 1\n[still]\nwidth = \"wide\"\n");
    test::writeText(folder / "bad.cam", "version = 1\neye = [0.0, 0.0]\n");
    expect(test::renderer({file("bad.glb"), "-o", file("a.png")}), 65, "bad.glb");
    expect(test::renderer({file("bad.scn"), "-o", file("a.png")}), 65, "bad.scn:2");
    expect(test::renderer({file("room.obj"), "-o", file("a.png"), "--set", file("bad.set")}), 65,
           "bad.set:3");
    expect(test::renderer({file("room.obj"), "-o", file("a.png"), "--camera", file("bad.cam")}), 65,
           "bad.cam:2");
    expect(test::bspBuilder({file("bad.glb"), file("a.bsp")}), 65, "bad.glb");
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
    EXPECT_FALSE(std::filesystem::exists(folder / "a.bsp"));
}

TEST_F(Failures, FilesOfThisSuiteInTheWrongPlace) {
    test::writeRoom(folder / "room.obj");
    test::writeText(folder / "garbage.bsp", "no magic number");
    test::writeText(folder / "room.scn", "version = 1\nmodel = \"room.obj\"\n");
    test::writeText(folder / "empty.lst", "# nothing yet\n");
    expect(test::renderer({file("garbage.bsp"), "-o", file("a.png")}), 65, "build it again with BSPBuilder");
    expect(test::bspBuilder({file("room.scn"), file("a.bsp")}), 65, "give the model");
    expect(test::renderer({file("room.obj"), "-o", file("a.png"), "-l", file("empty.lst")}), 65,
           "names no .cam file");
}

// An attribute on a line of its own looks like the first line of a .scn.
TEST_F(Failures, XmlWithAVersionIsNoScene) {
    test::writeText(folder / "broken.dae", "<?xml\nversion=\"1.0\"?>\n<COLLADA\nversion=\"1.4.1\">\n");
    const test::ProgramResult result = test::renderer({file("broken.dae"), "-o", file("a.png")});
    expect(result, 65, "broken.dae");
    EXPECT_EQ(result.error.find("TOML"), std::string::npos) << result.error;
    EXPECT_EQ(result.error.find("version"), std::string::npos) << result.error;
}

TEST_F(Failures, NamesAndSizesThatMakeNoSense) {
    test::writeRoom(folder / "room.obj");
    expect(test::renderer({"", "-o", file("a.png")}), 2, "is empty");
    expect(test::bspBuilder({file("room.obj"), ""}), 2, "is empty");
    expect(test::renderer({file("room.obj"), "-w", "20000", "-h", "20000", "-o", file("a.png")}), 2,
           "too large");
}

TEST_F(Failures, ATruncatedBsp) {
    test::writeRoom(folder / "room.obj");
    ASSERT_EQ(test::bspBuilder({file("room.obj"), file("room.bsp")}).exitCode, 0);
    const std::string bytes = test::readBytes(folder / "room.bsp");
    test::writeText(folder / "half.bsp", bytes.substr(0, bytes.size() / 2));
    expect(test::renderer({file("half.bsp"), "-o", file("a.png")}), 65, "half.bsp");
}

// Parts that were never written are not read: neither for a checksum nor for a model.
TEST_F(Failures, FilesOfHolesAreRefusedByBothProgramsAlike) {
    test::writeRoom(folder / "room.obj");
    ASSERT_EQ(test::bspBuilder({file("room.obj"), file("room.bsp")}).exitCode, 0);
    const std::string bsp = test::readBytes(folder / "room.bsp");
    const std::string ply =
        "ply\nformat binary_little_endian 1.0\nelement vertex 5000000000\nproperty float x\n"
        "property float y\nproperty float z\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n";
    for (const auto& [name, head] : std::initializer_list<std::pair<const char*, std::string>>{
             {"holes.ply", ply}, {"holes.stl", "x"}, {"holes.obj", "v 0 0 0\n"}, {"holes.bsp", bsp}}) {
        test::writeText(folder / name, head);
        std::filesystem::resize_file(folder / name, 60'000'000'000);
        const std::string reason = file(name) + ": of its 60000 MB hardly any were ever written";
        expect(test::renderer({file(name), "-o", file("a.png")}), 65, reason);
        expect(test::bspBuilder({file(name), file("a.bsp")}), 65, reason);
        // Short enough to be read: what the head says decides before a checksum does.
        if (std::string(name) != "holes.ply") continue;
        std::filesystem::resize_file(folder / name, 3'000'000'000);
        for (const auto& result : {test::renderer({file(name), "-o", file("a.png")}),
                                   test::bspBuilder({file(name), file("a.bsp")})})
            expect(result, 65, "its head promises 5000000000 elements 'vertex', for which it has no room");
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "a.bsp"));
}

TEST_F(Failures, ABspIsNoInputForBspBuilder) {
    test::writeRoom(folder / "room.obj");
    ASSERT_EQ(test::bspBuilder({file("room.obj"), file("room.bsp")}).exitCode, 0);
    expect(test::bspBuilder({file("room.bsp"), file("b.bsp")}), 65, "is a .bsp file already");
}

TEST_F(Failures, AnInputIsNeverOverwritten) {
    test::writeRoom(folder / "room.obj");
    const std::string before = test::readBytes(folder / "room.obj");
    expect(test::bspBuilder({file("room.obj"), file("room.obj")}), 2, "input and output are the same file");
    std::filesystem::create_hard_link(folder / "room.obj", folder / "link.obj");
    expect(test::bspBuilder({file("room.obj"), file("link.obj")}), 2, "input and output are the same file");
    test::writeText(folder / "notes.txt", "precious");
    expect(test::bspBuilder({file("room.obj"), file("notes.txt")}), 73, "is no .bsp file");
    expect(test::bspBuilder({file("room.obj"), file("room.png")}), 2, "name it " + file("room.bsp"));
    EXPECT_FALSE(std::filesystem::exists(folder / "room.png"));
    EXPECT_EQ(test::readBytes(folder / "notes.txt"), "precious");
    EXPECT_EQ(test::readBytes(folder / "room.obj"), before);
}

TEST_F(Failures, OutputsThatCannotBeWritten) {
    test::writeRoom(folder / "room.obj");
    expect(test::renderer({file("room.obj"), "-o", file("none/a.png")}), 73, "none");
    expect(test::bspBuilder({file("room.obj"), file("none/a.bsp")}), 73, "none");
    expect(test::renderer({file("room.obj"), "-o", file("a.nonsense")}), 2, "extension");
    test::writeText(folder / "bad.scn", "version = 1\nmodel = \"room.obj\"\noutput = \"a.nonsense\"\n");
    expect(test::renderer({file("bad.scn")}), 65, "extension");
}

TEST_F(Failures, AFileThatMayNotGrow) {
    test::writeRoom(folder / "room.obj");
    // Blocks of 512 bytes: too few for the model that the importer hands over, for the image.
    for (const char* blocks : {"2", "128"}) {
        const std::string command = std::string("ulimit -f ") + blocks + "; '" +
                                    test::programPath("Renderer").string() +
                                    "' room.obj -w 200 -h 200 -o a.bmp --progress=none; echo $? > code";
        const test::ProgramResult result =
            test::runProgram("/bin/sh", {"-c", command}, {.folder = folder.path()});
        EXPECT_EQ(test::readBytes(folder / "code"), "73\n") << result.error;
        EXPECT_NE(result.error.find("File too large"), std::string::npos) << result.error;
        EXPECT_EQ(test::filesIn(folder.path()), (Names{"code", "room.obj"}));
    }
}

TEST_F(Failures, AFullDiskUnderAPicture) {
    test::writeRoom(folder / "room.obj");
    test::ProgramSettings settings;
    settings.outputFile = "/dev/full";
    const test::ProgramResult result =
        test::renderer({file("room.obj"), "-o", "-", "-w", "16", "-h", "16"}, settings);
    EXPECT_EQ(result.exitCode, 73) << result.error;
}

TEST_F(Failures, AClosedPipeIsAnErrorLikeAnyOther) {
    test::writeRoom(folder / "room.obj");
    // The reader is gone before the image comes: the subshell waits until it has ended.
    const std::string command = "( sleep 0.3; '" + test::programPath("Renderer").string() +
                                "' room.obj -o - -w 16 -h 16 --progress=none; echo $? > code ) | true";
    const test::ProgramResult result =
        test::runProgram("/bin/sh", {"-c", command}, {.folder = folder.path()});
    EXPECT_EQ(test::readBytes(folder / "code"), "73\n") << result.error;
    EXPECT_NE(result.error.find("Renderer: standard output: "), std::string::npos) << result.error;
}

/// A .cam of another scene: one warning, however many frames say the same.
TEST_F(Failures, LightsAndEnvironmentsThatTheSceneLacksAreLeftOut) {
    test::writeRoom(folder / "room.obj");
    test::writeCamera(folder / "a.cam", 0, "width = 16\nheight = 12\nlights = [true, false, true]\n");
    test::writeCamera(folder / "b.cam", 0, "width = 16\nheight = 12\nenvironment = 3\n");
    test::writeText(folder / "two.lst", "a.cam\nb.cam\n");
    const std::string lights = "a.cam switches 3 lights, but the scene has 1; these stay as they are";
    const std::string sky = "b.cam asks for environment 3";
    const auto render = [&](const char* image, const char* option, const char* cameras) {
        return test::renderer({file("room.obj"), "-o", file(image), option, file(cameras),
                               "--setting=indirect.mode=off"}); // which images of a list share
    };
    expect(render("a.png", "--camera", "a.cam"), 0, lights);
    expect(render("b.png", "--camera", "b.cam"), 0, sky);
    const test::ProgramResult list = render("f#.png", "--list", "two.lst");
    expect(list, 0, lights);
    EXPECT_EQ(list.error.find(sky), std::string::npos) << list.error;
    EXPECT_TRUE(test::readBytes(folder / "f1.png") == test::readBytes(folder / "a.png"));
    EXPECT_TRUE(test::readBytes(folder / "f2.png") == test::readBytes(folder / "b.png"));
}

TEST_F(Failures, ThePictureStandsBesideWarnings) {
    test::writeText(folder / "plain.mtl", "newmtl paper\nKd 1 1 1\nmap_Kd lost.png\n");
    test::writeText(folder / "plain.obj", "mtllib plain.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n"
                                          "usemtl paper\nf 1/1 2/1 3/1\n");
    const test::ProgramResult result =
        test::renderer({file("plain.obj"), "-o", file("a.png"), "-w", "16", "-h", "16"});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(test::pngFileSize(folder / "a.png"), (test::PictureSize{16, 16}));
    EXPECT_NE(result.error.find("texture 'lost.png' is missing"), std::string::npos) << result.error;
}

TEST_F(Failures, WhoReadsTheFirstLineOnlyIsNoFailure) {
    std::vector<const char*> programs{"Renderer", "BSPBuilder", "RTServer", "CUI"};
#ifdef RT_HAS_BRIDGE
    programs.push_back("RTBridge");
#endif
    for (const char* program : programs) {
        const std::string command =
            "{ '" + test::programPath(program).string() + "' --help; echo $? > code; } | head -n 1";
        const test::ProgramResult result =
            test::runProgram("/bin/sh", {"-c", command}, {.folder = folder.path()});
        EXPECT_EQ(test::readBytes(folder / "code"), "0\n") << program;
        EXPECT_EQ(result.error, "") << program;
    }
}

// A file that got the number of a closed stream would be written into.
TEST_F(Failures, ClosedStandardStreamsLeaveFilesAlone) {
    test::writeRoom(folder / "room.obj");
    test::writeCamera(folder / "a.cam", 0, "width = 16\nheight = 16\n");
    test::writeText(folder / "film.lst", "a.cam\nnone.cam\na.cam\n");
    const std::string command =
        "'" + test::programPath("Renderer").string() +
        "' room.obj -l film.lst -v --progress=json -o f#.ppm <&- >&- 2>&-; echo $? > code";
    test::runProgram("/bin/sh", {"-c", command}, {.folder = folder.path()});
    EXPECT_EQ(test::readBytes(folder / "code"), "66\n");
    for (const char* name : {"f1.ppm", "f3.ppm"}) {
        EXPECT_EQ(test::readBytes(folder / name).size(), 13U + 16 * 16 * 3) << name;
    }
    const std::string shown =
        "'" + test::programPath("Renderer").string() + "' room.obj -o - >&-; echo $? > code";
    test::runProgram("/bin/sh", {"-c", shown}, {.folder = folder.path()});
    EXPECT_EQ(test::readBytes(folder / "code"), "73\n");
}

// Names in a scene of somebody else's may hold what a terminal obeys: its title, its clipboard.
TEST_F(Failures, NamesInFilesDoNotReachTheTerminalRaw) {
    test::writeRoom(folder / "room.obj");
    test::writeText(folder / "a.scn", "version = 1\nmodel = \"\\u001b]0;owned\\u0007.obj\"\n");
    test::writeText(folder / "b.scn", "version = 1\nmodel = \"room.obj\"\n[[material]]\n"
                                      "name = \"\\u001b]52;c;x\\u0007\\u009b31m\"\n");
    const test::ProgramSettings here{.folder = folder.path()};
    const std::string texts =
        test::renderer({"a.scn", "-o", "a.png"}, here).error +
        test::renderer({"b.scn", "-w", "8", "-h", "8", "-o", "a.png"}, here).error +
        test::renderer({"\x1b]0;x\x07", "-o", "a.png"}, here).error +
        test::bspBuilder({"\x1b]0;x\x07.obj", "a.bsp"}, here).error +
        test::runProgram(test::programPath("RTServer"), {"a.scn", "-i", "raw"}, here).error +
        test::runProgram(test::programPath("CUI"), {"\x1b[31m"}, here).error;
    EXPECT_NE(texts.find("\\x1b]0;owned\\x07.obj"), std::string::npos) << texts;
    EXPECT_NE(texts.find("\\x1b]52;c;x\\x07\\xc2\\x9b31m"), std::string::npos) << texts;
    for (const char* raw : {"\x1b", "\x07", "\xc2\x9b"})
        EXPECT_EQ(texts.find(raw), std::string::npos) << texts;
}

TEST_F(Failures, NorDoLinesOfOutputOnATerminal) {
    test::writeRoom(folder / "room.obj");
    test::writeCamera(folder / "a.cam", 0);
    test::writeText(folder / "film.lst", "a.cam\n");
    const Names words{"room.obj", "-l", "film.lst", "-o", "\x1b]0;x\x07#.png", "--verify"};
    const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    ASSERT_TRUE(terminal >= 0 && ::grantpt(terminal) == 0 && ::unlockpt(terminal) == 0);
    const std::string end = ::ptsname(terminal);
    const int held = ::open(end.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC); // so that reading has no early end
    test::renderer(words, {.folder = folder.path(), .outputFile = end});
    std::array<char, 1000> shown{};
    const ssize_t count = ::read(terminal, shown.data(), shown.size());
    ::close(held);
    ::close(terminal);
    ASSERT_GT(count, 0);
    EXPECT_EQ(std::string(shown.data(), static_cast<std::size_t>(count)),
              "1\t\\x1b]0;x\\x071.png\tmissing\r\n");
    EXPECT_EQ(test::renderer(words, {.folder = folder.path()}).output, "1\t\x1b]0;x\x07"
                                                                       "1.png\tmissing\n");
}

TEST_F(Failures, AreTellableInAnotherLanguage) {
    const std::string forged = "\x1E[\"forged\"].glb";
    test::writeText(folder / forged, "no model at all");
    const auto lines = [&](const char* wanted) {
        const test::ProgramResult result =
            test::renderer({file(forged), "-o", file("a.png")}, {.environment = {{"RT_SENTENCES", wanted}}});
        EXPECT_EQ(result.exitCode, 65);
        std::vector<std::string> all;
        std::istringstream text(result.error);
        for (std::string line; std::getline(text, line);) all.push_back(line);
        return all;
    };
    EXPECT_EQ(lines("0").size(), 1U);
    const std::vector<std::string> both = lines("1");
    ASSERT_EQ(both.size(), 2U);
    EXPECT_EQ(both[1], lines("0")[0]);
    ASSERT_EQ(both[0][0], '\x1E');
    const auto said = rtcore::readSentenceJson(both[0].substr(1));
    ASSERT_TRUE(said);
    EXPECT_TRUE(said->isForm());
    EXPECT_EQ("Renderer: " + said->english(), both[1]);
    EXPECT_EQ(both[1].find('\x1E'), std::string::npos);
}

} // namespace
