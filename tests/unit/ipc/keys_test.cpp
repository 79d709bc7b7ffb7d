#include "ipc/channel/keys.h"

#include <gtest/gtest.h>

#include <thread>

namespace {

using namespace ipc;

TEST(Keys, ATapBetweenTwoLooksIsNotLost) {
    KeyBoard board{};
    KeyWriter writer;
    KeyReader reader;
    writer.press(&board, 65);
    writer.release(&board, 65);
    writer.press(&board, 65);
    writer.release(&board, 65);
    KeyState state;
    reader.collect(board, state);
    EXPECT_FALSE(state.down[65]);
    EXPECT_EQ(state.presses[65], 2u);
    KeyState next;
    reader.collect(board, next);
    EXPECT_EQ(next.presses[65], 0u);
}

TEST(Keys, UniteOverClients) {
    KeyBoard one{}, two{};
    KeyWriter writerOne, writerTwo;
    KeyReader readerOne, readerTwo;
    writerOne.press(&one, 0);
    writerTwo.press(&two, 255);
    writerTwo.press(&two, 0);
    writerTwo.release(&two, 0);
    KeyState state;
    readerOne.collect(one, state);
    readerTwo.collect(two, state);
    EXPECT_TRUE(state.down[0]);
    EXPECT_TRUE(state.down[255]);
    EXPECT_EQ(state.presses[0], 2u);
    EXPECT_EQ(state.down.count(), 2u);
}

TEST(Keys, OfRestrainedClientsAreToldApart) {
    KeyBoard boards[3]{};
    KeyWriter writer;
    KeyState state;
    for (std::uint32_t restraint = 0; restraint < 3; ++restraint) {
        writer.press(&boards[restraint], 7);
        KeyReader().collect(boards[restraint], state, restraint);
    }
    EXPECT_EQ(state.presses[7], 3U);
    EXPECT_EQ(state.restrained[0][7], 2U) << "of the first level and more";
    EXPECT_EQ(state.restrained[1][7], 1U);
    EXPECT_EQ(state.restrained[1][8], 0U);
}

TEST(Keys, UnknownCodesAreIgnored) {
    KeyBoard board{};
    KeyWriter writer;
    for (const int key : {-1, 256, 100000}) {
        writer.press(&board, key);
        writer.release(&board, key);
    }
    KeyState state;
    KeyReader().collect(board, state);
    EXPECT_TRUE(state.down.none());
}

TEST(Keys, ANewBoardHoldsWhatIsDown) {
    KeyBoard old{}, fresh{};
    fresh.presses[5] = 99; // of somebody before us
    fresh.down[1] = ~std::uint64_t{0};
    KeyWriter writer;
    writer.press(&old, 5);
    writer.press(nullptr, 200);
    writer.restore(fresh);
    KeyState state;
    KeyReader().collect(fresh, state);
    EXPECT_EQ(state.down.count(), 2u);
    EXPECT_TRUE(state.down[5] && state.down[200]);
    EXPECT_EQ(state.presses[5], 0u);
}

TEST(Keys, WhoSeesAKeyDownHasSeenItsPress) {
    KeyBoard board{};
    std::thread presser([&] {
        KeyWriter writer;
        for (int i = 0; i < 20000; ++i) {
            writer.press(&board, 7);
            writer.release(&board, 7);
        }
    });
    KeyReader reader;
    KeyState sum;
    while (sum.presses[7] < 20000) {
        reader.collect(board, sum);
        if (sum.down[7]) {
            ASSERT_GT(sum.presses[7], 0u);
        }
    }
    presser.join();
    EXPECT_EQ(sum.presses[7], 20000u);
}

} // namespace
