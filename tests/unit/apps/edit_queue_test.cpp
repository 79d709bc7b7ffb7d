#include "common/mirror/edit_queue.h"

#include <gtest/gtest.h>

namespace {

using namespace std::chrono_literals;
using app::EditQueue;
using Line = std::optional<std::string>;

constexpr EditQueue::Clock::time_point kStart{};

TEST(EditQueue, HasOneOfEachThingUnderWay) {
    EditQueue queue;
    EXPECT_EQ(queue.edit("set maxDepth", "set maxDepth 3"), Line("set maxDepth 3"));
    EXPECT_EQ(queue.edit("light power 1", "light power 1 5"), Line("light power 1 5")) << "another thing";
    EXPECT_TRUE(queue.isBusy("set maxDepth"));
    EXPECT_EQ(queue.edit("set maxDepth", "set maxDepth 4", false), Line());
    EXPECT_EQ(queue.edit("set maxDepth", "set maxDepth 5", false), Line());
    EXPECT_EQ(queue.answered("set maxDepth"), Line("set maxDepth 5")) << "the newest";
    EXPECT_EQ(queue.answered("set maxDepth"), Line());
    EXPECT_FALSE(queue.isBusy("set maxDepth"));
    EXPECT_TRUE(queue.isBusy("light power 1"));
}

TEST(EditQueue, JoinsThoseOfOneGesture) {
    EditQueue queue;
    EXPECT_EQ(queue.edit("a", "set a 1", {}, kStart), Line("set a 1"));
    EXPECT_EQ(queue.edit("a", "set a 2", {}, kStart + 100ms), Line());
    EXPECT_EQ(queue.answered("a"), Line("also set a 2"));
    EXPECT_EQ(queue.answered("a"), Line());
    EXPECT_EQ(queue.edit("a", "set a 3", {}, kStart + 900ms), Line("also set a 3"));
    EXPECT_EQ(queue.answered("a"), Line());
    EXPECT_EQ(queue.edit("a", "set a 4", {}, kStart + 2s), Line("set a 4")) << "after a pause";
    EXPECT_EQ(queue.answered("a"), Line());
    EXPECT_EQ(queue.edit("b", "set b 1", {}, kStart + 2s), Line("set b 1")) << "another thing";
    queue.answered("b");
    EXPECT_EQ(queue.edit("b", "set b 2", {}, kStart + 2s), Line("also set b 2"));
    queue.answered("b");
    queue.endGesture();
    EXPECT_EQ(queue.edit("b", "set b 3", {}, kStart + 2s), Line("set b 3")) << "undo lay between";
}

/// A step that was to begin does, though its first line is never sent.
TEST(EditQueue, LetsWhatTakesThePlaceOfTheFirstBeginTheStep) {
    EditQueue queue;
    queue.edit("a", "set a 1", false);
    queue.edit("a", "set a 2", false); // begins a step
    queue.edit("a", "set a 3", true);
    EXPECT_EQ(queue.answered("a"), Line("set a 3"));
}

TEST(EditQueue, ForgetsWhatAServerThatIsGoneWillNotAnswer) {
    EditQueue queue;
    queue.edit("a", "set a 1");
    queue.edit("a", "set a 2");
    queue.forget();
    EXPECT_EQ(queue.answered("a"), Line());
    EXPECT_EQ(queue.edit("a", "set a 3"), Line("set a 3"));
}

} // namespace
