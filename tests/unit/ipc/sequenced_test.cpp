#include "ipc/channel/sequenced_value.h"
#include "ipc/layout/status.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace {

using namespace ipc;

struct Words {
    std::uint64_t word[32];
};

TEST(Sequenced, GivesWhatWasWritten) {
    Sequenced<Status> shared{};
    Status status{.frameSeconds = 0.5, .polygons = 12, .mode = 3};
    write(shared, status);
    Status copy;
    ASSERT_TRUE(read(shared, copy));
    EXPECT_EQ(copy, status);
}

TEST(Sequenced, AWriterThatDiedInTheMiddleGivesNothing) {
    Sequenced<Status> shared{};
    shared.sequence = 5;
    Status copy{.polygons = 42};
    EXPECT_FALSE(read(shared, copy));
    EXPECT_EQ(copy.polygons, 42u);
}

TEST(Sequenced, NeverGivesAMixture) {
    Sequenced<Words> shared{};
    std::atomic<bool> stop{false};
    std::thread writer([&] {
        for (std::uint64_t i = 1; i <= 50000; ++i) {
            Words words;
            for (auto& word : words.word) word = i;
            write(shared, words);
            if (i % 512 == 0) std::this_thread::yield();
        }
        stop = true;
    });
    int reads = 0, torn = 0;
    while (!stop || reads == 0) {
        Words words;
        if (!read(shared, words)) continue;
        ++reads;
        for (const auto word : words.word) torn += word != words.word[0];
    }
    writer.join();
    EXPECT_EQ(torn, 0) << "of " << reads;
}

} // namespace
