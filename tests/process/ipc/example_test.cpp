/// The client that docs/protocol.md shows, as it stands there.
#include "process/ipc/troupe.h"
#include "support/run_program.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace {

using namespace test;

TEST(Example, GetsAnAnswerAndAPicture) {
    Troupe troupe;
    troupe.start(0, "server");
    const ProgramResult result =
        runProgram(RT_IPC_EXAMPLE, {troupe.instance.name()}, {.folder = troupe.instance.folder().path()});
    EXPECT_EQ(result.exitCode, 0) << result.error;
    EXPECT_NE(result.output.find("ping: ping\n"), std::string::npos) << result.output;
    std::stringstream picture;
    picture << std::ifstream(troupe.instance.folder() / "frame.ppm", std::ios::binary).rdbuf();
    EXPECT_EQ(picture.str().substr(0, 13), "P6\n64 33\n255\n");
    EXPECT_EQ(picture.str().size(), 13u + 3 * 64 * 33);
}

TEST(Example, SaysThatThereIsNoServer) {
    const Troupe troupe;
    const ProgramResult result = runProgram(RT_IPC_EXAMPLE, {troupe.instance.name()});
    EXPECT_EQ(result.exitCode, 75);
    EXPECT_NE(result.error.find("no server '" + troupe.instance.name()), std::string::npos) << result.error;
}

} // namespace
