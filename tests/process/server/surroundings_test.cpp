/// The surroundings of a server: somebody else's things at its names, other environments, hardly any
/// descriptors.
#include "process/server/live_server.h"

#include "ipc/endpoint/client.h"

#include <chrono>
#include <set>

#include <sys/stat.h>

namespace {

using namespace test;
using namespace std::chrono_literals;

class Surroundings : public LiveServer {
  protected:
    std::string control() const { return "/dev/shm/" + instance.names().control(); }
    ProgramResult program(const std::string& name, const Names& words) const {
        return runProgram(programPath(name), words, {.folder = folder().path(), .timeoutSeconds = 20});
    }
};

// Its own user's pipes stand for those of others: opening them would hang as well.
TEST_F(Surroundings, APipeAtTheNameHangsNobody) {
    const auto mkpipe = [&] { ASSERT_EQ(::mkfifo(control().c_str(), 0600), 0); };
    mkpipe();
    EXPECT_EQ(program("CUI", {"list"}).exitCode, 0);
    EXPECT_EQ(cui({"--timeout=0.2", "ping"}).exitCode, 73);
    EXPECT_EQ(cui({"free"}).exitCode, 0);
    mkpipe();
    EXPECT_EQ(
        program("Renderer", {"room.obj", "-w", "8", "-h", "8", "--linger=0", "--preview=" + instance.name()})
            .exitCode,
        0);
    mkpipe();
    start();
    EXPECT_EQ(ask({"ping"}), "pong\n");
}

TEST_F(Surroundings, NamesOfOtherUsersAreNotListed) {
    if (::getuid() != 0) GTEST_SKIP() << "only root can be another user";
    ASSERT_EQ(::mkfifo(control().c_str(), 0666), 0);
    ASSERT_EQ(::chown(control().c_str(), 65534, 65534), 0);
    const ProgramResult list = program("CUI", {"list"});
    EXPECT_EQ(list.exitCode, 0);
    EXPECT_EQ(list.output.find(instance.name()), std::string::npos) << list.output;
    ::unlink(control().c_str());
}

// A program that opens and closes the file of its own lock, as any file dialog may.
TEST_F(Surroundings, ItsOwnNameReadAsAFileDoesNotUnlockIt) {
    start();
    refused({"load", "camera", control()}, 65, "");
    const ProgramResult second =
        program("RTServer", {"room.obj", "--instance=" + instance.name(), "--resolution=8x8"});
    EXPECT_EQ(second.exitCode, 75);
    EXPECT_NE(second.error.find("is already running"), std::string::npos) << second.error;
    refused({"free"}, 75, "is already running");
    EXPECT_EQ(ask({"ping"}), "pong\n");
}

TEST_F(Surroundings, OtherVariablesDoNotHideIt) {
    start();
    const TemporaryFolder elsewhere;
    const std::string path = elsewhere.path().string();
    const ProgramSettings settings{.folder = folder().path(),
                                   .environment = {{"XDG_RUNTIME_DIR", path}, {"TMPDIR", path}},
                                   .timeoutSeconds = 20};
    const std::string name = "--instance=" + instance.name();
    EXPECT_EQ(runProgram(programPath("CUI"), {name, "ping"}, settings).output, "pong\n");
    EXPECT_EQ(runProgram(programPath("RTServer"), {"room.obj", name}, settings).exitCode, 75);
}

// It works, or says why not.
TEST_F(Surroundings, DescriptorsMayBeFew) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer's look at the types of objects needs descriptors of its own";
#endif
    int working = 0;
    // With fewer than 4, or with others that it inherits, the system cannot even load its libraries.
    const std::string own = "exec 3>&- 4>&- 5>&- 6>&- 7>&- 8>&- 9>&-; ";
    for (int descriptors = 4; descriptors <= 20; descriptors += descriptors < 12 ? 1 : 4) {
        const std::string line = own + "ulimit -n " + std::to_string(descriptors) + "; exec " +
                                 programPath("RTServer").string() +
                                 " room.obj --resolution=8x8 --instance=" + instance.name();
        server.emplace("/bin/sh", Names{"-c", line}, ProgramSettings{.folder = folder().path()});
        if (server->waitForError("ready: ")) {
            EXPECT_EQ(ask({"ping"}), "pong\n") << descriptors;
            EXPECT_EQ(end(SIGTERM).exitCode, 143) << descriptors;
            ++working;
            continue;
        }
        const ProgramResult result = server->wait();
        EXPECT_TRUE((std::set{1, 66, 73, 75}.contains(result.exitCode)))
            << descriptors << ": " << result.exitCode;
        EXPECT_NE(result.error, "") << descriptors;
        EXPECT_TRUE(instance.segments().empty()) << descriptors;
    }
    EXPECT_GE(working, 3);
}

} // namespace
