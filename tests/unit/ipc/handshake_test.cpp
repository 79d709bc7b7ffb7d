/// A client faces segments that are not, not yet, or no longer a server of its version; and a server faces
/// obstacles at its names. Nobody may wait longer than told.
#include "ipc/endpoint/client.h"
#include "ipc/endpoint/link.h"
#include "ipc/endpoint/server.h"
#include "ipc/layout/control_block.h"
#include "support/ipc_instance.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <thread>

#include <sys/stat.h>

namespace {

using namespace ipc;
using namespace std::chrono_literals;

class Handshakes : public testing::Test {
  protected:
    std::filesystem::path controlFile() const { return "/dev/shm/" + instance.names().control(); }
    void writeControl(std::size_t bytes, char value) const {
        std::ofstream(controlFile(), std::ios::binary) << std::string(bytes, value);
        std::filesystem::permissions(controlFile(), std::filesystem::perms(0600));
    }
    // A control segment as a server would write it, changed; while the server's lock is held by us.
    void makeControl(const std::function<void(ControlHeader&)>& change) {
        control = Segment::createLocked(instance.names().control(), sizeof(ControlBlock), kServerLock);
        auto& block = *new (control->data()) ControlBlock;
        block.header.handshake = ownHandshake();
        block.header.epoch = 5;
        block.pulse.phase = ServerPhase::Running;
        block.header.magic = kControlMagic;
        change(block.header);
    }
    // The problem that a viewer and a client meet, or nothing.
    std::optional<Problem> problem() const {
        std::optional<Problem> viewers = attempt<Viewer>(), clients = attempt<Client>();
        EXPECT_EQ(viewers, clients);
        return clients;
    }
    template <class Endpoint>
    std::optional<Problem> attempt() const {
        const auto start = Clock::now();
        std::optional<Problem> met;
        try {
            const Endpoint endpoint(instance.name(), 50ms);
        } catch (const Error& error) {
            met = error.problem;
        }
        EXPECT_LT(Clock::now() - start, 1s);
        return met;
    }

    test::IpcInstance instance;
    std::optional<Segment> control; ///< locked
};

TEST_F(Handshakes, NothingThereIsNoServer) { EXPECT_EQ(problem(), Problem::NoServer); }

TEST_F(Handshakes, UnfinishedSegmentsAreNoServer) {
    for (const std::size_t bytes : {0ul, 1ul, 8ul, 575ul, 576ul, 4096ul, sizeof(ControlBlock)}) {
        writeControl(bytes, 0);
        EXPECT_EQ(problem(), Problem::NoServer) << bytes;
        writeControl(bytes, '\x5A');
        EXPECT_EQ(problem(), Problem::NoServer) << bytes;
    }
}

TEST_F(Handshakes, ASegmentWithoutItsServersLockIsNoServer) {
    makeControl([](ControlHeader&) {});
    control.reset();
    EXPECT_EQ(problem(), Problem::NoServer);
}

TEST_F(Handshakes, OtherVersionsAreNamed) {
    const std::function<void(ControlHeader&)> changes[] = {
        [](ControlHeader& h) { h.handshake.protocolVersion++; },
        [](ControlHeader& h) { h.handshake.protocolVersion--; },
        [](ControlHeader& h) { h.handshake.controlBytes--; },
        [](ControlHeader& h) { h.handshake.boostVersion += 100; },
        [](ControlHeader& h) { h.handshake.pointerBytes = 4; },
        [](ControlHeader& h) { h.handshake.byteOrder = 0x0201; }};
    for (const auto& change : changes) {
        makeControl(change);
        EXPECT_EQ(problem(), Problem::WrongVersion);
        Segment::remove(instance.names().control());
        control.reset();
    }
}

// Version 1 had its lock elsewhere.
TEST_F(Handshakes, AServerOfAnotherVersionWithoutThatLockLivesByItsPulse) {
    makeControl([](ControlHeader& h) { h.handshake.protocolVersion = 1; });
    control->unlock(kServerLock);
    EXPECT_EQ(problem(), Problem::NoServer);
    std::atomic<std::uint64_t>& alive = static_cast<ControlBlock*>(control->data())->pulse.alive;
    const std::jthread beating([&](const std::stop_token& stop) {
        for (; !stop.stop_requested(); ++alive) std::this_thread::sleep_for(2ms);
    });
    EXPECT_EQ(problem(), Problem::WrongVersion);
    EXPECT_THROW(Server({.instance = instance.name(), .patience = 0s}), Error);
    EXPECT_THROW(freeInstance(instance.name()), Error);
    EXPECT_EQ(instance.segments().size(), 1U);
}

TEST_F(Handshakes, MagicComesLast) {
    makeControl([](ControlHeader& h) { h.magic = 0; });
    EXPECT_EQ(problem(), Problem::NoServer);
}

TEST_F(Handshakes, NamesOpenToOthersAreRefused) {
    makeControl([](ControlHeader&) {});
    std::filesystem::permissions(controlFile(), std::filesystem::perms(0666));
    EXPECT_EQ(problem(), Problem::NotYours);
}

TEST_F(Handshakes, LinksAndFoldersAreRefused) {
    std::filesystem::create_symlink("/etc/passwd", controlFile());
    EXPECT_EQ(problem(), Problem::NotYours);
    std::filesystem::remove(controlFile());
    std::filesystem::create_directory(controlFile());
    EXPECT_EQ(problem(), Problem::NotYours);
    std::filesystem::remove(controlFile());
}

TEST_F(Handshakes, AServerReplacesWhatIsDead) {
    const std::function<void()> zoo[] = {
        [] {},
        [&] { writeControl(0, 0); },
        [&] { writeControl(1, 1); },
        [&] { writeControl(sizeof(ControlBlock), '\x5A'); },
        [&] { makeControl([](ControlHeader& h) { h.handshake.protocolVersion = 99; }); },
        [&] { std::filesystem::create_symlink("/nowhere", controlFile()); },
        [&] { std::ofstream("/dev/shm/" + instance.names().queue(3, 1)) << "old"; },
        [&] { std::ofstream("/dev/shm/" + instance.names().frames(1, 1)) << "old"; },
    };
    for (const auto& animal : zoo) {
        animal();
        control.reset();
        const auto start = Clock::now();
        {
            const Server server({.instance = instance.name(), .width = 16, .height = 16});
            EXPECT_EQ(instance.segments().size(), 2u);
            EXPECT_EQ(problem(), std::nullopt);
        }
        EXPECT_TRUE(instance.segments().empty());
        EXPECT_LT(Clock::now() - start, 1s);
    }
}

TEST_F(Handshakes, AFolderInTheWayIsToldNotWaitedFor) {
    std::filesystem::create_directory(controlFile());
    try {
        const Server server({.instance = instance.name(), .width = 16, .height = 16});
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.problem, Problem::NotYours) << error.what();
    }
    std::filesystem::remove(controlFile());
}

TEST_F(Handshakes, SegmentsAreForTheUserAlone) {
    for (const mode_t mask : {0, 022, 077}) {
        const mode_t before = ::umask(mask);
        const Server server({.instance = instance.name(), .width = 16, .height = 16});
        const Client client(instance.name());
        ::umask(before);
        for (const std::string& name : instance.segments()) {
            struct stat facts {};
            ASSERT_EQ(::stat(("/dev/shm/" + name).c_str(), &facts), 0);
            EXPECT_EQ(facts.st_mode & 07777, 0600u) << name;
        }
    }
}

TEST_F(Handshakes, OneServerPerInstance) {
    const Server server({.instance = instance.name(), .width = 16, .height = 16});
    const auto refused = [&] {
        try {
            const Server second({.instance = instance.name(), .patience = 10ms});
            return false;
        } catch (const Error& error) {
            return error.problem == Problem::AlreadyRunning &&
                   std::string(error.what()).find(std::to_string(processId())) != std::string::npos;
        }
    };
    EXPECT_TRUE(refused());
    EXPECT_EQ(problem(), std::nullopt);
    EXPECT_EQ(instance.segments().size(), 2u);
}

TEST_F(Handshakes, FreeRemovesOnlyWhatIsDead) {
    {
        const Server server({.instance = instance.name(), .width = 16, .height = 16});
        EXPECT_THROW(freeInstance(instance.name()), Error);
        bool listed = false;
        for (const Instance& found : listInstances()) {
            listed |= found.name == instance.name() && found.running && found.process == processId();
        }
        EXPECT_TRUE(listed);
    }
    EXPECT_EQ(freeInstance(instance.name()), 0);
    makeControl([](ControlHeader&) {});
    control.reset();
    EXPECT_EQ(freeInstance(instance.name()), 1);
    EXPECT_TRUE(instance.segments().empty());
    EXPECT_THROW(freeInstance("../x"), Error);
}

} // namespace
