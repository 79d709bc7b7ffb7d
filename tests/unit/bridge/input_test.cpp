#include "bridge/control/input_state.h"
#include "bridge/control/own_edits.h"
#include "bridge/control/plain_name.h"

#include <gtest/gtest.h>

namespace {

using bridge::InputState;

bridge::InputMessage holding(std::uint32_t sequence, std::vector<std::uint8_t> keys) {
    return {sequence, 0, 0, std::move(keys), {}};
}

TEST(InputState, HoldsWhatTheLastMessageSays) {
    InputState input;
    EXPECT_TRUE(input.apply(holding(1, {'W', 'A'}), 0));
    EXPECT_TRUE(input.apply(holding(2, {'A'}), 0.1));
    EXPECT_FALSE(input.held()['W']);
    EXPECT_TRUE(input.held()['A']);
    EXPECT_FALSE(input.apply(holding(1, {'W'}), 0.2)) << "an old message";
    EXPECT_FALSE(input.held()['W']);
}

TEST(InputState, ReleasesAllAfterHalfASecondOfSilence) {
    InputState input;
    input.apply(holding(1, {'W'}), 0);
    EXPECT_FALSE(input.expire(0.4));
    input.apply(holding(2, {'W'}), 0.4);
    EXPECT_FALSE(input.expire(0.8)) << "the heartbeat came";
    EXPECT_TRUE(input.expire(0.91));
    EXPECT_TRUE(input.held().none());
    EXPECT_FALSE(input.expire(2)) << "told once";
}

TEST(OwnEdits, AreTakenBackByTheirNumber) {
    bridge::OwnEdits edits;
    edits.sent();
    EXPECT_FALSE(edits.mayUndo(7)) << "it is under way";
    edits.read({3, 7}, {});
    EXPECT_FALSE(edits.mayUndo(7)) << "of a state before its answer";
    edits.answered();
    EXPECT_TRUE(edits.busy()) << "the state is not read";
    edits.read({4, 7}, {});
    EXPECT_TRUE(edits.mayUndo(7));
    EXPECT_EQ(edits.undo(), 4);
    EXPECT_FALSE(edits.mayUndo(8)) << "another session";
    EXPECT_FALSE(edits.mayRedo(7));
    edits.read({5, 0}, {});
    EXPECT_FALSE(edits.mayUndo(7)) << "another client's edit came after it";
    EXPECT_FALSE(edits.mayUndo(0)) << "nobody's";
    edits.read({2, 8}, {4, 7});
    EXPECT_TRUE(edits.mayUndo(8));
    EXPECT_TRUE(edits.mayRedo(7));
    EXPECT_EQ(edits.redo(), 4);
    edits.clear();
    EXPECT_FALSE(edits.mayUndo(8));
    EXPECT_FALSE(edits.mayRedo(7));
}

TEST(PlainName, HasNoControlCharactersAndFortyAtMost) {
    EXPECT_EQ(bridge::plainName("An\nna\x7F\x01"), "Anna");
    EXPECT_EQ(bridge::plainName("\u009b31mA\u0085n\u202en\u2066a\u2069 \u00a0\u2013"), "31mAnna \u00a0\u2013")
        << "what rules terminals and directions";
    EXPECT_EQ(bridge::plainName("\u200eA\u200fn\u061cn\u2028a\xff"), "Anna") << "or is no text";
    EXPECT_EQ(bridge::plainName(std::string(100, 'x')).size(), 40U);
    std::string accents;
    for (int i = 0; i < 50; ++i) accents += "\u00e9";
    EXPECT_EQ(bridge::plainName(accents).size(), 80U) << "characters, not bytes";
}

} // namespace
