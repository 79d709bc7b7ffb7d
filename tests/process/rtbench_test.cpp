/// rtbench as it is run by hand: figures, agreement with Embree where that is there, exit codes.
#include "process/sample_scene.h"

#include "bench/rtbench/contenders.h"

#include "rtcore/simd/instruction_set.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

#ifdef _OPENMP
constexpr const char* kThreads[] = {"1", "2"};
#else
constexpr const char* kThreads[] = {"1"};
#endif

class RtBench : public testing::Test {
  protected:
    void SetUp() override { test::writeRoom(folder / "room.obj"); }

    test::ProgramResult run(Words words) const {
        words.push_back("--progress=none");
        return test::runProgram(test::programPath("rtbench"), words, {.folder = folder.path()});
    }
    Json report() const { return Json::parse(test::readBytes(folder / "r.json")); }

    test::TemporaryFolder folder;
};

TEST_F(RtBench, RacesEveryKindOfRay) {
    const std::string tiny = RT_SOURCE_FOLDER "/data/tiny/tiny.scn";
    const test::ProgramResult result = run({tiny, "room.obj", "--size=64", "--rounds=2", "--json=r.json"});
    EXPECT_EQ(result.exitCode, 0) << result.error; // hits agree
    EXPECT_NE(result.output.find("\nroom: 168 triangles, headlight\n"), std::string::npos) << result.output;
    const Json json = report();
    ASSERT_EQ(json["scenes"].size(), 2U);
    EXPECT_EQ(json["scenes"][0]["name"], "tiny");
    for (const Json& scene : json["scenes"]) {
        for (const char* kind : {"primary", "shadow", "ao", "mirror", "bounce"}) {
            const Json& rays = scene["rays"][kind];
            EXPECT_GT(rays["ours"], 0) << kind;
            EXPECT_GE(rays["spread"], 0) << kind;
            EXPECT_EQ(rays["ratio"].is_number(), rtbench::hasEmbree()) << kind;
            EXPECT_EQ(rays["ratioRobust"].is_number(), rtbench::hasEmbree()) << kind;
            EXPECT_EQ(json["geomean"].contains(kind), rtbench::hasEmbree());
        }
    }
}

TEST_F(RtBench, TracesOnlyWhatIsAskedFor) {
    const test::ProgramResult result = run(
        {"room.obj", "--rays=bounce,primary", "--size=32", "--rounds=2", "--embree=off", "--json=r.json"});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    const Json rays = report()["scenes"][0]["rays"];
    EXPECT_EQ(rays.size(), 2U);
    EXPECT_TRUE(rays["primary"]["embree"].is_null());
    EXPECT_TRUE(rays["bounce"]["mode"].is_null());
    EXPECT_EQ(report()["geomean"], Json::object());
    EXPECT_FALSE(report().contains("frames"));
}

TEST_F(RtBench, RendersFrames) {
    const test::ProgramResult result = run({"room.obj", "--rays=none", "--frames", "--frame-size=64x36",
                                            "--threads=2", "--rounds=2", "--json=r.json"});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    const Json scene = report()["frames"]["scenes"][0];
    for (const char* kind : {"phong", "mirrors"}) {
        for (const char* threads : kThreads) {
            const Json& frame = scene.at(kind).at(threads);
            EXPECT_GT(frame["ours"], 0);
            EXPECT_GT(frame["fps"], 0);
            EXPECT_EQ(frame["ratio"].is_number(), rtbench::hasEmbree());
        }
    }
}

TEST_F(RtBench, HoldsBothSidesToAnInstructionSet) {
    for (const std::string& name : rtcore::instructionSets()) {
        const test::ProgramResult result = run({"room.obj", "--size=32", "--rounds=2", "--isa", name});
        EXPECT_EQ(result.exitCode, 0) << result.error;
        EXPECT_NE(result.output.find(", " + name), std::string::npos) << result.output;
    }
}

TEST_F(RtBench, TakesViewsByTheNameOfTheModel) {
    test::writeText(
        folder / "v.toml",
        "version = 1\n[[view]]\nscene = \"room\"\nname = \"front\"\neye = [0.0, 2.0, 6.0]\n"
        "at = [0.0, 1.0, 0.0]\nlight = [3.0, 9.0, 5.0]\n[[view]]\nscene = \"room\"\n"
        "name = \"away\"\neye = [0.0, 50.0, 6.0]\nat = [0.0, 99.0, 0.0]\nlight = [3.0, 9.0, 5.0]\n");
    const test::ProgramResult result =
        run({"room.obj", "--views=v.toml", "--size=32", "--rounds=2", "--json=r.json"});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_NE(result.error.find("room away: the view shows nothing"), std::string::npos) << result.error;
    EXPECT_EQ(report()["scenes"][0]["name"], "room front");
    EXPECT_EQ(report()["scenes"][1]["rays"].size(), 1U); // primary rays need no surface
}

TEST_F(RtBench, UsageErrors) {
    for (const Words& words : std::vector<Words>{{},
                                                 {"--size=64"},
                                                 {"room.obj", "--rays=primary,glossy"},
                                                 {"room.obj", "--rays="},
                                                 {"room.obj", "--rays=none"},
                                                 {"room.obj", "--isa=avx9000"},
                                                 {"room.obj", "--embree=perhaps"},
                                                 {"room.obj", "--frame-size=640"},
                                                 {"room.obj", "--frame-size=0x10"},
                                                 {"room.obj", "--threads=0"},
                                                 {"room.obj", "--nonsense"}}) {
        const test::ProgramResult result = run(words);
        EXPECT_EQ(result.exitCode, 2) << testing::PrintToString(words);
        EXPECT_EQ(result.output, "");
        EXPECT_NE(result.error.find("rtbench"), std::string::npos) << result.error;
    }
}

TEST_F(RtBench, FailuresHaveTheirExitCodes) {
    EXPECT_EQ(run({"missing.obj", "--json=r.json"}).exitCode, 66);
    EXPECT_EQ(run({"room.obj", "--views=missing.toml"}).exitCode, 66);
    test::writeText(folder / "v.toml", "version = 1\n[[view]]\nscene = \"room\"\n");
    EXPECT_EQ(run({"room.obj", "--views=v.toml"}).exitCode, 65);
    EXPECT_EQ(run({"room.obj", "--json=nowhere/r.json"}).exitCode, 73);
    EXPECT_EQ(test::filesIn(folder.path()), (Words{"room.obj", "v.toml"}));
}

TEST_F(RtBench, ControlCLeavesNothing) {
    test::RunningProgram program(
        test::programPath("rtbench"),
        {"room.obj", "--size=1024", "--rounds=1000", "--json=r.json", "--progress=json"},
        {.folder = folder.path()});
    ASSERT_TRUE(program.waitForError("primary"));
    program.send(SIGINT);
    EXPECT_EQ(program.wait().exitCode, 130);
    EXPECT_EQ(test::filesIn(folder.path()), Words{"room.obj"});
}

} // namespace
