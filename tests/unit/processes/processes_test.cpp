#include "rtcore/platform/processes.h"

#include "rtcore/platform/error.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iterator>
#include <span>
#include <string>
#include <thread>

#include <sys/wait.h>

namespace {

using namespace rtcore;

ProcessResult shell(const std::string& script, const ProcessLimits& limits = {}) {
    return runProcess("/bin/sh", {"-c", script}, limits);
}

double secondsOf(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(Processes, ReportsExitCodeAndBothStreams) {
    const ProcessResult r = shell("echo out; echo err >&2; exit 7");
    EXPECT_EQ(r.end, ProcessEnd::Exited);
    EXPECT_EQ(r.code, 7);
    EXPECT_EQ(r.output, "out\n");
    EXPECT_EQ(r.errors, "err\n");
}

TEST(Processes, PassesArgumentsUnchanged) {
    const ProcessResult r = runProcess("/bin/sh", {"-c", "printf '%s|' \"$@\"", "x", "a b", "", "*", "-n"});
    EXPECT_EQ(r.output, "a b||*|-n|");
}

TEST(Processes, ReportsSignals) {
    const ProcessResult r = shell("kill -SEGV $$");
    EXPECT_EQ(r.end, ProcessEnd::Signalled);
    EXPECT_EQ(r.code, SIGSEGV);
    EXPECT_EQ(signalName(SIGSEGV), "Segmentation fault");
}

TEST(Processes, KeepsNoMoreOutputThanAsked) {
    ProcessLimits limits;
    limits.kept = 1000;
    const ProcessResult r = shell("head -c 3000000 /dev/zero; head -c 3000000 /dev/zero >&2", limits);
    EXPECT_EQ(r.code, 0);
    EXPECT_EQ(r.output.size(), 1000U);
    EXPECT_EQ(r.errors.size(), 1000U);
}

TEST(Processes, EndsWhatIsSilentTooLong) {
    ProcessLimits limits;
    limits.silence = 0.3;
    ProcessResult r;
    EXPECT_LT(secondsOf([&] { r = shell("sleep 100", limits); }), 5);
    EXPECT_EQ(r.end, ProcessEnd::SilenceLimit);
    // One that speaks is let be.
    r = shell("for i in 1 2 3 4 5 6 7 8; do echo $i; sleep 0.1; done", limits);
    EXPECT_EQ(r.end, ProcessEnd::Exited);
}

TEST(Processes, EndsWhatTakesTooMuchMemory) {
    ProcessLimits limits;
    limits.memory = 100'000'000;
    // The shell itself keeps the line. It grows within seconds, or fails first where strings are limited.
    const ProcessResult r = shell("x=aaaaaaaaaaaaaaaa; while :; do x=$x$x; done", limits);
    EXPECT_EQ(r.end, ProcessEnd::MemoryLimit);
    EXPECT_GT(r.peakMemory, limits.memory);
}

TEST(Processes, StopsWhenToldTo) {
    std::atomic<bool> stop = false;
    ProcessLimits limits;
    limits.stop = &stop;
    std::thread other([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        stop = true;
    });
    ProcessResult r;
    EXPECT_LT(secondsOf([&] { r = shell("sleep 100", limits); }), 5);
    other.join();
    EXPECT_EQ(r.end, ProcessEnd::Stopped);
}

TEST(Processes, LeavesNeitherZombiesNorGrandchildren) {
    const ProcessResult r = shell("sleep 100 & echo $!");
    EXPECT_EQ(r.end, ProcessEnd::Exited);
    const std::string grandchild = "/proc/" + r.output.substr(0, r.output.find('\n')) + "/status";
    bool gone = false;
    for (int i = 0; i < 100 && !gone; ++i) {
        std::ifstream file(grandchild);
        const std::string status((std::istreambuf_iterator<char>(file)), {});
        // Killed; it is for init to reap it.
        gone = status.empty() || status.find("Z (zombie)") != std::string::npos;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    EXPECT_TRUE(gone);
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
    EXPECT_EQ(errno, ECHILD);
}

TEST(Processes, GivesNoInputAndNoOpenFiles) {
    const ProcessResult r = shell("cat; ls /proc/self/fd | wc -l");
    EXPECT_EQ(r.code, 0);
    // 0, 1, 2 and the folder that ls reads.
    EXPECT_LE(std::atoi(r.output.c_str()), 4);
}

TEST(Processes, SaysWhichProgramIsMissing) {
    try {
        runProcess("/no/such/program", {});
        FAIL() << "no error";
    } catch (const FileError& error) {
        EXPECT_EQ(error.kind, FailureKind::NoInput);
        EXPECT_NE(std::string(error.what()).find("/no/such/program"), std::string::npos);
    }
}

TEST(Processes, NoticesTheEndAtOnce) {
    // Twenty starts of a program that does nothing: a watcher that slept 20 ms each time would need 0.4 s
    // more.
    const double one = secondsOf([] { std::system("/bin/true"); });
    const double twenty = secondsOf([] {
        for (int i = 0; i < 20; ++i) runProcess("/bin/true", {});
    });
    EXPECT_LT(twenty, 20 * (one * 4 + 0.01));
}

std::span<const std::byte> bytesOf(const std::string& text) { return std::as_bytes(std::span(text)); }

TEST(PipedProcesses, GetAllThatIsWritten) {
    const std::string much(3'000'000, 'x');
    PipedProcess process("/bin/sh", {"-c", "sleep 0.1; wc -c; echo err >&2; exit 5"}, {});
    EXPECT_TRUE(process.write(bytesOf(much)));
    EXPECT_TRUE(process.write(bytesOf("end")));
    const ProcessResult result = process.finish();
    EXPECT_EQ(result.end, ProcessEnd::Exited);
    EXPECT_EQ(result.code, 5);
    EXPECT_EQ(std::stoi(result.output), 3'000'003);
    EXPECT_EQ(result.errors, "err\n");
}

TEST(PipedProcesses, ThatEndEarlyEndTheWriting) {
    const std::string much(3'000'000, 'x');
    // The second leaves a child behind that holds the input open.
    for (const char* script :
         {"exec 0<&-; exit 4", "exec 3<&0; sleep 1000 & exit 4", "head -c 9 >/dev/null; exit 4"}) {
        PipedProcess process("/bin/sh", {"-c", script}, {});
        EXPECT_FALSE(process.write(bytesOf(much))) << script;
        EXPECT_EQ(process.finish().code, 4) << script;
    }
}

TEST(PipedProcesses, ThatTalkMuchDoNotBlock) {
    const std::string much(1'000'000, 'x');
    PipedProcess process("/bin/sh", {"-c", "head -c 2000000 /dev/zero >&2; cat"}, {});
    EXPECT_TRUE(process.write(bytesOf(much)));
    EXPECT_EQ(process.finish().errors.size(), ProcessLimits{}.kept);
}

TEST(PipedProcesses, CanBeStopped) {
    const std::string much(3'000'000, 'x');
    PipedProcess writing("/bin/sh", {"-c", "exec sleep 1000"}, [] { return true; });
    EXPECT_THROW(writing.write(bytesOf(much)), FileError);
    PipedProcess ending("/bin/sh", {"-c", "exec sleep 1000"}, [] { return true; });
    EXPECT_THROW(ending.finish(), FileError);
}

TEST(Programs, AreFoundOnThePath) {
    ASSERT_TRUE(findProgram("sh").has_value());
    EXPECT_TRUE(std::filesystem::exists(*findProgram("sh")));
    EXPECT_FALSE(findProgram("no-such-program-anywhere").has_value());
}

TEST(AttachedProcess, ReportsItsEnd) {
    EXPECT_EQ(runForeground("/bin/sh", {"-c", "exit 7"}, nullptr).code, 7);
    const ProcessResult killed = runForeground("/bin/sh", {"-c", "kill -9 $$"}, nullptr);
    EXPECT_EQ(killed.end, ProcessEnd::Signalled);
    EXPECT_EQ(killed.code, SIGKILL);
    try {
        runForeground("/nonexistent/program", {}, nullptr);
        FAIL() << "it does not exist";
    } catch (const FileError& error) {
        EXPECT_EQ(error.kind, FailureKind::NoInput);
    }
}

TEST(AttachedProcess, GetsTheSignalThatStopsUs) {
    const std::string script = "trap 'exit 5' TERM; while :; do sleep 0.01; done";
    EXPECT_EQ(runForeground("/bin/sh", {"-c", script}, [] { return SIGTERM; }).code, 5);
}

} // namespace
