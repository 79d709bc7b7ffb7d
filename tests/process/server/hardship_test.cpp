/// Hardships of RTServer from outside: it is stopped, its names are removed, shared memory is full.
#include "process/server/besieged_server.h"

#include <functional>
#include <random>

#include <sched.h>
#include <sys/mount.h>

namespace {

using namespace test;

class Hardship : public Besieged {};

TEST_F(Hardship, WhileItIsStoppedCuiWaitsOrSaysSo) {
    ASSERT_TRUE(stands());
    troupe.start(1, "talker");
    troupe.start(2, "viewer");
    ASSERT_TRUE(troupe.progresses({1, 2}, 5s));
    std::mt19937 random(5);
    for (int round = 0; round < rounds(1); ++round) {
        const auto pause = std::chrono::milliseconds(100 + random() % 900);
        troupe[0].send(SIGSTOP);
        RunningProgram patient(programPath("CUI"),
                               {"--instance=" + troupe.instance.name(), "--timeout=20", "ping"});
        const auto start = Clock::now();
        const ProgramResult hasty = cui({"--timeout=0.05", "ping"});
        EXPECT_LT(Clock::now() - start, 1s);
        EXPECT_EQ(hasty.exitCode, 75) << hasty.output;
        EXPECT_NE(hasty.error.find("did not answer in time"), std::string::npos) << hasty.error;
        std::this_thread::sleep_until(start + pause);
        troupe[0].send(SIGCONT);
        const ProgramResult result = patient.wait();
        EXPECT_EQ(result.exitCode, 0) << result.error;
        EXPECT_EQ(result.output, "pong\n");
        ASSERT_TRUE(troupe.progresses({1, 2}, 1s)) << "round " << round;
    }
    EXPECT_EQ(troupe.board[1].epochs, 1U) << "nobody took it for dead";
    expectNothingWrong();
    expectGoodEnd();
}

TEST_F(Hardship, RemovedNamesComeBack) {
    ASSERT_TRUE(stands());
    troupe.start(1, "talker");
    troupe.start(2, "viewer");
    ASSERT_TRUE(troupe.progresses({1, 2}, 5s));
    for (int round = 0; round < rounds(2); ++round) {
        const std::uint64_t before = troupe.board[1].epochs;
        for (const std::string& name : troupe.instance.segments()) ipc::Segment::remove(name);
        ASSERT_TRUE(eventually([&] { return troupe.instance.segments().size() >= 2; }, 2s));
        const ProgramResult result = cui({"ping"});
        EXPECT_EQ(result.exitCode, 0) << result.error;
        EXPECT_TRUE(eventually([&] { return troupe.board[1].epochs > before; }, 1s));
        ASSERT_TRUE(troupe.progresses({1, 2}, 1s)) << "round " << round;
    }
    expectNothingWrong();
    expectGoodEnd();
}

// A name that is removed while no frame is drawn comes back, too, and whoever comes finds the last frame.
TEST_F(Hardship, PausedItStillLooksAfterItsNames) {
    ASSERT_TRUE(stands());
    EXPECT_EQ(cui({"wait-idle"}).exitCode, 0);
    EXPECT_EQ(cui({"pause"}).exitCode, 0);
    EXPECT_EQ(cui({"resolution", "2000", "1500"}).exitCode, 0) << "more memory than before";
    const auto newcomerSees = [&] {
        ipc::Frame seen;
        return ipc::Viewer(troupe.instance.name()).waitForFrame(seen, 1s) ? seen.info.width : 0;
    };
    EXPECT_EQ(newcomerSees(), 64U);
    const std::uint64_t epoch = ipc::Viewer(troupe.instance.name()).epoch();
    for (const std::string& name : troupe.instance.segments()) ipc::Segment::remove(name);
    EXPECT_TRUE(eventually([&] { return troupe.instance.segments().size() >= 2; }, 2s));
    EXPECT_EQ(newcomerSees(), 64U);
    EXPECT_NE(ipc::Viewer(troupe.instance.name()).epoch(), epoch);
    EXPECT_EQ(cui({"resume"}).exitCode, 0);
    EXPECT_EQ(cui({"wait-idle"}).exitCode, 0);
    EXPECT_EQ(newcomerSees(), 2000U);
    expectGoodEnd();
}

// Shared memory has room for them, but the server itself has not. It can tell beforehand, or else goes back.
TEST_F(Hardship, TooLittleMemoryForLargerFramesIsAnError) {
    if (kSanitized) GTEST_SKIP() << "a sanitizer takes all the address space that there is";
    ASSERT_TRUE(stands({}, {.addressBytes = 1'200'000'000}));
    const ProgramResult result = cui({"resolution", "9000", "9000"});
    EXPECT_EQ(result.exitCode, 75);
    EXPECT_NE(result.error.find("not enough memory for frames of 9000 x 9000"), std::string::npos)
        << result.error;
    ipc::Client client(troupe.instance.name());
    ipc::Ticket resolution = 0, idle = 0;
    troupe[0].send(SIGSTOP); // so that it takes both at once
    EXPECT_EQ(client.send("resolution 6000 6000", &resolution), ipc::SendStatus::Sent);
    EXPECT_EQ(client.send("wait-idle", &idle), ipc::SendStatus::Sent);
    troupe[0].send(SIGCONT);
    EXPECT_EQ(client.wait(resolution, 10s).status, ipc::ReplyStatus::Done);
    const ipc::Reply reply = client.wait(idle, 10s);
    EXPECT_EQ(reply.code, 75);
    EXPECT_EQ(reply.text.rfind("not enough memory for frames of 6000 x 6000", 0), 0U) << reply.text;
    EXPECT_EQ(cui({"get", "width"}).output, "64\n");
    EXPECT_EQ(cui({"wait-idle"}).exitCode, 0);
    expectGoodEnd();
}

// From where it can hardly start to where it has enough: whatever cannot be had is refused, and nothing ends
// it. (In the first 100 kB above the least that it starts with, not even its stack can grow.)
TEST_F(Hardship, InLittleMemoryASizeIsRefusedAndTheServerStays) {
    if (kSanitized) GTEST_SKIP() << "a sanitizer takes all the address space that there is";
    int stood = 0, refusals = 0;
    for (std::size_t bytes = 95'000'000; stood < 4 && bytes < 400'000'000; bytes += 10'000'000) {
        viewer.reset();
        troupe.put(0, newServer({"--resolution=32x24", "--threads=1"}, {.addressBytes = bytes}));
        const auto ended = [&] {
            troupe[0].wait(0s);
            return troupe[0].process() < 0;
        };
        const bool stands = eventually([&] { return ended() || showsFrames(); }, 20s) && !ended();
        if (!stands) continue; // too little even for that
        ++stood;
        for (const auto& [width, height] :
             {std::pair{"8000", "6000"}, {"1000", "600"}, {"2000", "1000"}, {"700", "400"}, {"64", "48"}}) {
            refusals += cui({"resolution", width, height}).exitCode == 75 ? 1 : 0;
            refusals += cui({"wait-idle"}).exitCode == 75 ? 1 : 0;
            EXPECT_EQ(cui({"ping"}).output, "pong\n") << width << " with " << bytes << "\n" << log();
        }
        expectGoodEnd();
    }
    EXPECT_EQ(stood, 4);
    EXPECT_GT(refusals, 0);
}

// Whatever waits for an answer, a frame or a command does so by another clock.
TEST_F(Hardship, TheWallClockIsNobodysMatter) {
    if (kSanitized) GTEST_SKIP() << "a sanitizer must be the first library of a program";
    const std::pair<std::string, std::string> unsteady{"LD_PRELOAD", RT_UNSTEADY_CLOCK};
    ASSERT_TRUE(stands({"--fps-limit=20"}, {.environment = {unsteady}}));
    const auto shell = [&](const std::vector<std::string>& words) {
        std::vector<std::string> all{"--instance=" + troupe.instance.name()};
        all.insert(all.end(), words.begin(), words.end());
        return runProgram(programPath("CUI"), all, {.environment = {unsteady}, .timeoutSeconds = 30});
    };
    const auto start = Clock::now();
    for (int round = 0; round < rounds(1); ++round) {
        std::this_thread::sleep_for(300ms); // it sleeps
        EXPECT_EQ(shell({"ping"}).output, "pong\n");
        EXPECT_EQ(shell({"key", "press", "w"}).exitCode, 0);
        EXPECT_GT(frames(300ms), 2U);
        EXPECT_EQ(shell({"key", "release", "all"}).exitCode, 0);
        EXPECT_EQ(shell({"wait-idle"}).exitCode, 0);
        troupe[0].send(SIGSTOP);
        const auto asked = Clock::now();
        EXPECT_EQ(shell({"--timeout=0.5", "ping"}).exitCode, 75);
        EXPECT_GT(Clock::now() - asked, 450ms);
        EXPECT_LT(Clock::now() - asked, 1s);
        troupe[0].send(SIGCONT);
    }
    EXPECT_LT(Clock::now() - start, rounds(1) * 5s);
    EXPECT_EQ(shell({"quit"}).exitCode, 0);
    EXPECT_NE(troupe[0].wait(2s), -1);
}

// The test's process gets mounts of its own, and with them all programs that it starts.
class FullMemory : public Besieged {
  protected:
    void inSmallMemory(const char* size, const std::function<void()>& body) {
        constexpr int kNotAllowed = 99;
        std::fflush(nullptr);
        const pid_t child = ::fork();
        if (child == 0) {
            if (::unshare(CLONE_NEWNS) != 0 ||
                ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
                ::mount("tmpfs", "/dev/shm", "tmpfs", 0, (std::string("size=") + size).c_str()) != 0) {
                ::_exit(kNotAllowed);
            }
            body();
            std::fflush(nullptr);
            ::_exit(HasFailure() ? 1 : 0);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        ASSERT_TRUE(WIFEXITED(status)) << status;
        if (WEXITSTATUS(status) == kNotAllowed) GTEST_SKIP() << "no mounts of our own: not root";
        EXPECT_EQ(WEXITSTATUS(status), 0) << "see above";
    }
    void refused(const std::vector<std::string>& words) {
        const ProgramResult result = cui(words);
        EXPECT_EQ(result.exitCode, 75) << result.error;
        EXPECT_NE(result.error.find("shared memory: needs "), std::string::npos) << result.error;
    }
};

TEST_F(FullMemory, ForLargerFramesIsAnErrorAndTheServerGoesOn) {
    inSmallMemory("16m", [this] {
        ASSERT_TRUE(stands());
        troupe.start(1, "talker");
        ASSERT_TRUE(troupe.progresses({1}, 5s));
        for (int round = 0; round < rounds(3); ++round) {
            refused({"resolution", "16384", "16384"});
            writeCamera(folder() / "huge.cam", 1, "width = 16000\nheight = 16000\n");
            refused({"load", "camera", "huge.cam"});
            EXPECT_TRUE(troupe.progresses({1}, 1s));
            EXPECT_LE(std::stoi(cui({"get", "width"}).output), 128);
        }
        EXPECT_EQ(cui({"resolution", "640", "400"}).exitCode, 0) << "what fits, fits";
        EXPECT_EQ(cui({"set", "antialiasing", "8"}).exitCode, 0) << "else it may be done between two words";
        EXPECT_EQ(cui({"wait-idle", "--timeout=0.01"}).exitCode, 75) << "the talker has it draw all the time";
        EXPECT_EQ(troupe.board[1].epochs, 1U);
        expectNothingWrong();
        expectGoodEnd();
    });
}

TEST_F(FullMemory, AtTheStartEndsItWithAMessage) {
    for (const auto& [size, resolution] : {std::pair{"64k", "8x8"}, std::pair{"16m", "8000x8000"}}) {
        inSmallMemory(size, [&] {
            ChildProcess server = newServer({std::string("--resolution=") + resolution});
            const int status = server.wait(10s);
            ASSERT_TRUE(status != -1 && WIFEXITED(status)) << status;
            EXPECT_EQ(WEXITSTATUS(status), 75);
            EXPECT_NE(log().find("shared memory: needs "), std::string::npos) << log();
            EXPECT_TRUE(troupe.instance.segments().empty());
        });
    }
}

} // namespace
