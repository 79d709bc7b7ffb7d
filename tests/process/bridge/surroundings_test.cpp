// The bridge and the system around it: names and files that are taken, signals, several servers.
#include "process/bridge/bridge_fixture.h"
#include "support/run_program.h"

#include <fmt/core.h>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

namespace {

using namespace test;
using nlohmann::json;

const std::string kBridgeProgram = std::string(RT_PROGRAM_FOLDER) + "/RTBridge";

class Surroundings : public BridgeTest {
  protected:
    ProgramResult second(const std::vector<std::string>& words) {
        std::vector<std::string> all{"--instance=" + instance.name()};
        all.insert(all.end(), words.begin(), words.end());
        return runProgram(kBridgeProgram, all, {.timeoutSeconds = 20});
    }
    static std::string tokenIn(const std::string& text, const std::string& label) {
        const std::size_t start = text.find("#t=", text.rfind(label)) + 3;
        return text.substr(start, text.find('\n', start) - start);
    }
};

TEST_F(Surroundings, APortThatIsTakenIsTold) {
    const ProgramResult result = second({fmt::format("--listen=127.0.0.1:{}", port)});
    EXPECT_EQ(result.exitCode, 75) << result.error;
    EXPECT_NE(result.error.find(std::to_string(port)), std::string::npos) << result.error;
    EXPECT_EQ(result.output, "") << "no links that lead elsewhere";
    EXPECT_FALSE(join()->event("roles").is_null());
}

TEST_F(Surroundings, TokenFilesAreWrittenOnceForTheirOwner) {
    const std::string file = (instance.folder() / "new").string();
    for (int round = 0; round < 2; ++round) {
        const std::string output = file + std::to_string(round);
        ChildProcess other(kBridgeProgram,
                           {"--instance=" + instance.name(), "--listen=127.0.0.1:0", "--token-file=" + file},
                           {.outputFile = output});
        EXPECT_TRUE(eventually([&] { return readAll(output).find("Viewer: ") != std::string::npos; }, 10s));
        EXPECT_EQ(tokenIn(readAll(output), "Driver: ") + "\n" + tokenIn(readAll(output), "Viewer: ") + "\n",
                  readAll(file));
    }
    struct stat facts {};
    ASSERT_EQ(::stat(file.c_str(), &facts), 0);
    EXPECT_EQ(facts.st_mode & 0777U, 0600U);
    const std::string folder = instance.folder().path().string();
    EXPECT_EQ(second({"--token-file=" + folder}).exitCode, 65) << "a folder";
    EXPECT_EQ(second({"--token-file=" + folder + "/no/such/folder"}).exitCode, 73);
}

// The tokens are not those of a file.
TEST_F(Surroundings, RenewalMakesOtherLinksAndClosesAllPages) {
    const std::string output = (instance.folder() / "renewed").string();
    bridge = ChildProcess(kBridgeProgram, {"--instance=" + instance.name(), "--listen=127.0.0.1:0"},
                          {.outputFile = output});
    ASSERT_TRUE(eventually([&] { return readAll(output).find("Viewer: ") != std::string::npos; }, 10s));
    const std::string before = readAll(output), old = tokenIn(before, "Driver: ");
    port = std::atoi(before.c_str() + before.find("127.0.0.1:") + 10);
    const auto client = join(old.c_str());
    bridge.send(SIGUSR1);
    EXPECT_EQ(client->closeCode(), 4003);
    ASSERT_TRUE(eventually([&] { return readAll(output).size() >= 2 * before.size(); }));
    WebClient late(port);
    late.hello(old);
    EXPECT_EQ(late.closeCode(), 4003);
    const std::string renewed = tokenIn(readAll(output), "Driver: ");
    EXPECT_NE(renewed, old);
    EXPECT_FALSE(join(renewed.c_str())->event("roles").is_null());
}

TEST_F(Surroundings, NoCoreIsWrittenAndNoRightsAreGained) {
    const std::string process = fmt::format("/proc/{}/", bridge.process());
    const std::string limits = readAll(process + "limits"), core = "Max core file size";
    const std::size_t at = limits.find(core);
    ASSERT_NE(at, std::string::npos);
    std::istringstream row(limits.substr(at + core.size()));
    std::string soft, hard;
    row >> soft >> hard;
    EXPECT_EQ(soft, "0");
    EXPECT_EQ(hard, "0");
    EXPECT_NE(readAll(process + "status").find("NoNewPrivs:\t1"), std::string::npos);
}

TEST_F(Surroundings, TheEndDoesNotWaitForAStill) {
    const auto client = join();
    server->show(1600, 1200);
    const auto part = client->binary(2, 20s);
    ASSERT_TRUE(part) << "more of it would come after an acknowledgement";
    bridge.send(SIGTERM);
    const int status = bridge.wait(10s);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 143);
}

TEST_F(Surroundings, BothPagesAreToldOfADeathAndSeeTheSuccessor) {
    const auto first = join(), second = join(kViewer);
    const auto becomes = [](WebClient& client, const std::string& state) {
        for (json event = client.event("server", 10s); !event.is_null(); event = client.event("server", 10s))
            if (event["state"] == state) return true;
        return false;
    };
    // Acknowledges all frames until one of another stream than `old`; 0: none came.
    const auto nextStream = [](WebClient& client, std::uint32_t old) {
        while (const auto frame = client.binary(1, 10s)) {
            client.acknowledge(*frame);
            if (const std::uint32_t stream = headerOf(frame->payload).stream; stream != old) return stream;
        }
        return std::uint32_t(0);
    };
    const std::uint32_t before = nextStream(*first, 0);
    ASSERT_NE(before, 0U);
    EXPECT_EQ(nextStream(*second, 0), before);
    server.reset();
    for (WebClient* const each : {first.get(), second.get()}) EXPECT_TRUE(becomes(*each, "gone"));
    startServer();
    // Its first frame may come before the event that it is there.
    for (WebClient* const each : {first.get(), second.get()}) EXPECT_NE(nextStream(*each, before), 0U);
    EXPECT_TRUE(eventually([&] { return first->request({{"do", "walk"}})["ok"] == true; }));
}

class TwoServers : public BridgeTest {
    void SetUp() override {
        startServer();
        other = std::make_unique<FakeServer>(otherInstance.name());
        startBridge({"--instance=" + otherInstance.name()});
    }

  protected:
    std::unique_ptr<WebClient> joinAt(const std::string& name) {
        auto client = std::make_unique<WebClient>(port);
        client->hello(kDriver, "test", {{"instance", name}});
        return client;
    }

    IpcInstance otherInstance;
    std::unique_ptr<FakeServer> other;
};

TEST_F(TwoServers, ArePagesOfTheirOwn) {
    const auto here = joinAt(instance.name()), there = joinAt(otherInstance.name());
    const json welcome = here->event("welcome"), beside = there->event("welcome");
    EXPECT_EQ(welcome["instances"], (json{instance.name(), otherInstance.name()}));
    EXPECT_EQ(beside["instance"], otherInstance.name());
    EXPECT_EQ(beside["role"], "driver") << "each has a driver";
    EXPECT_EQ(here->event("roles")["people"].size(), 1U);
    there->input({'W'});
    EXPECT_TRUE(eventually([&] { return other->isHeld('W'); }));
    EXPECT_FALSE(server->anyHeld());
    other->move(30);
    EXPECT_TRUE(there->binary(1));
    server.reset();
    EXPECT_EQ(there->request({{"do", "walk"}})["ok"], true) << "the death of one is no matter of the other's";
    EXPECT_TRUE(page("/health").starts_with("HTTP/1.1 200"));
    WebClient nowhere(port);
    nowhere.hello(kDriver, "test", {{"instance", "nowhere"}});
    EXPECT_EQ(nowhere.closeCode(), 4004);
}

class UnixSocket : public BridgeTest {
    void SetUp() override {
        startServer();
        startBridge({}, "unix");
    }

  protected:
    std::string path() const { return (instance.folder() / "rts" / (instance.name() + ".web")).string(); }
};

// Its queue is full.
TEST_F(UnixSocket, OfOneThatIsStoppedKeepsNoStartWaiting) {
    bridge.kill();
    std::filesystem::remove(path());
    sockaddr_un where{};
    where.sun_family = AF_UNIX;
    path().copy(where.sun_path, sizeof where.sun_path - 1);
    const auto open = [] { return ::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0); };
    const int stopped = open();
    ASSERT_EQ(::bind(stopped, reinterpret_cast<const sockaddr*>(&where), sizeof where), 0);
    ASSERT_EQ(::listen(stopped, 0), 0);
    std::vector<RawSocket> waiting;
    waiting.push_back(RawSocket::ofDescriptor(stopped));
    for (bool full = false; !full;) {
        const int each = open();
        full = ::connect(each, reinterpret_cast<const sockaddr*>(&where), sizeof where) != 0;
        waiting.push_back(RawSocket::ofDescriptor(each));
    }
    const ProgramResult second = runProgram(
        kBridgeProgram, {"--instance=" + instance.name(), "--listen=unix"}, {.timeoutSeconds = 20});
    EXPECT_EQ(second.exitCode, 75) << second.error;
}

TEST_F(UnixSocket, OfAKilledBridgeIsReplacedAndThatOfALivingOneIsNot) {
    const ProgramResult second = runProgram(
        kBridgeProgram, {"--instance=" + instance.name(), "--listen=unix"}, {.timeoutSeconds = 20});
    EXPECT_EQ(second.exitCode, 75) << second.error;
    bridge.kill();
    ASSERT_TRUE(std::filesystem::exists(path())) << "nothing could remove it";
    startBridge({}, "unix");
    WebClient client(RawSocket(path()), "127.0.0.1:8931", "http://127.0.0.1:8931");
    client.hello(kDriver);
    EXPECT_FALSE(client.event("welcome").is_null()) << links();
}

} // namespace
