/// Command queues that are not what they should be: looked at before Boost, which believes them, does.
#include "ipc/channel/command_queue.h"
#include "ipc/layout/message_headers.h"
#include "ipc/platform/boost_interprocess.h"
#include "ipc/platform/segment.h"
#include "ipc/platform/system.h"
#include "support/ipc_instance.h"

#include <boost/interprocess/ipc/message_queue.hpp>

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace ipc;
using namespace std::chrono_literals;

class Queues : public testing::Test {
  protected:
    std::size_t queueBytes() {
        const CommandSender sender(name);
        return Segment::open(name, Access::Read, 1)->bytes();
    }
    test::IpcInstance instance;
    const std::string name = instance.names().queue(0, 7);
};

// Boost would wait a second for somebody to finish it.
TEST_F(Queues, OneThatWasNeverFinishedIsRefusedAtOnce) {
    const std::size_t whole = queueBytes();
    for (const std::size_t bytes : {std::size_t{1}, std::size_t{4096}, whole - 1, whole, whole + 1}) {
        const Segment zeros = Segment::create(name, bytes);
        const auto start = Clock::now();
        CommandReceiver receiver;
        EXPECT_EQ(CommandReceiver::open(name, receiver), QueueResult::Broken) << bytes;
        EXPECT_LT(Clock::now() - start, 500ms) << bytes;
        EXPECT_TRUE(instance.segments().empty()) << "its name is removed";
    }
}

TEST_F(Queues, RandomBytesInTheHeadOfOneAreNoticed) {
    const char* asked = std::getenv("RT_MUTATIONS");
    const int rounds = asked == nullptr ? 100 : std::max(1, std::atoi(asked) / 100);
    std::mt19937_64 random(14);
    int broken = 0;
    for (int round = 0; round < rounds; ++round) {
        CommandSender sender(name);
        const auto memory = Segment::open(name, Access::Write, 1);
        CommandReceiver receiver;
        ASSERT_EQ(CommandReceiver::open(name, receiver), QueueResult::Done);
        auto* bytes = static_cast<unsigned char*>(memory->data());
        const std::vector<std::byte> message(100, std::byte{3});
        ASSERT_EQ(sender.trySend(message), QueueResult::Done);
        // The counts and the index of messages; the mutex and the conditions between them are the C
        // library's.
        using Header = boost::interprocess::ipcdetail::mq_hdr_t<boost::interprocess::offset_ptr<void>>;
        const std::size_t mutex = 16 + offsetof(Header, m_mutex),
                          rest = 16 + offsetof(Header, m_cur_first_msg);
        for (int i = 0; i < 8; ++i) {
            std::size_t offset = random() % 512;
            while (offset >= mutex && offset < rest) offset = random() % 512;
            bytes[offset] = static_cast<unsigned char>(random());
        }
        std::vector<std::byte> received;
        for (int i = 0; i < 40; ++i) {
            const QueueResult result = receiver.tryReceive(received);
            if (result == QueueResult::Broken) ++broken;
            if (result != QueueResult::Done) break;
        }
    }
    EXPECT_GT(broken, rounds / 2);
}

// A client that was stopped in the 50 ns within which it has the queue's mutex.
TEST_F(Queues, OneWhoseMutexIsKeptIsGivenUpSoon) {
    CommandSender sender(name);
    const auto memory = Segment::open(name, Access::Write, 1);
    CommandReceiver receiver;
    ASSERT_EQ(CommandReceiver::open(name, receiver), QueueResult::Done);
    using Header = boost::interprocess::ipcdetail::mq_hdr_t<boost::interprocess::offset_ptr<void>>;
    auto& header = *reinterpret_cast<Header*>(static_cast<std::byte*>(memory->data()) + 16);
    ASSERT_EQ(header.m_max_num_msg, kCommandQueueLength);
    header.m_mutex.lock();
    const auto start = Clock::now();
    std::vector<std::byte> message;
    EXPECT_EQ(receiver.tryReceive(message), QueueResult::Broken);
    EXPECT_LT(Clock::now() - start, 1s);
    header.m_mutex.unlock();
}

} // namespace
