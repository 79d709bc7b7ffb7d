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

using Step = bridge::OwnEdits::Step;

TEST(OwnEdits, TakeBackOnlyWhatTheSessionItselfDid) {
    bridge::OwnEdits edits;
    edits.sent(0);
    EXPECT_FALSE(edits.mayUndo(7, 0, "")) << "it is under way";
    edits.answered(7, Step::Edit, true);
    EXPECT_TRUE(edits.busy()) << "the state is not read";
    edits.read(1, "set maxDepth");
    EXPECT_TRUE(edits.mayUndo(7, 1, "set maxDepth"));
    EXPECT_FALSE(edits.mayUndo(8, 1, "set maxDepth")) << "another session";
    EXPECT_FALSE(edits.mayUndo(7, 2, "light 1")) << "somebody else's edit came after it";
    edits.sent(1);
    edits.answered(7, Step::Undo, true);
    EXPECT_FALSE(edits.mayRedo(7, 0, "set maxDepth"));
    edits.read(0, "");
    EXPECT_FALSE(edits.mayUndo(7, 0, ""));
    EXPECT_TRUE(edits.mayRedo(7, 0, "set maxDepth"));
    edits.sent(0);
    edits.answered(7, Step::Redo, true);
    edits.read(1, "set maxDepth");
    EXPECT_TRUE(edits.mayUndo(7, 1, "set maxDepth"));
}

TEST(OwnEdits, JoinEditsOfOneGesture) {
    bridge::OwnEdits edits;
    for (int k = 0; k < 2; ++k) {
        EXPECT_EQ(edits.mayGoOn(7, k, "set bloom.radius"), k == 1);
        edits.sent(k);
        EXPECT_TRUE(edits.mayGoOn(7, k, "set bloom.radius"));
        edits.answered(7, Step::Edit, true);
        edits.read(1, "set bloom.radius");
    }
    EXPECT_FALSE(edits.mayGoOn(8, 1, "set bloom.radius"));
    edits.sent(1);
    edits.answered(7, Step::Undo, true);
    edits.read(0, "");
    EXPECT_FALSE(edits.mayUndo(7, 1, "set bloom.radius"));
}

TEST(OwnEdits, AreNoneThatChangeNothingOrThatOthersMadeMeanwhile) {
    bridge::OwnEdits edits;
    edits.sent(3);
    edits.answered(7, Step::Edit, true);
    edits.read(3, "light 2");
    EXPECT_FALSE(edits.mayUndo(7, 3, "light 2")) << "it changed nothing";
    edits.read(4, "light 5");
    EXPECT_FALSE(edits.mayUndo(7, 4, "light 5")) << "another's, later";
    edits.sent(4);
    edits.answered(7, Step::Edit, true);
    edits.read(6, "light 6");
    EXPECT_FALSE(edits.mayUndo(7, 6, "light 6")) << "two, of which one is another's";
    edits.sent(6);
    edits.answered(7, Step::Edit, false);
    edits.read(7, "light 7");
    EXPECT_FALSE(edits.mayUndo(7, 7, "light 7")) << "it was refused";
}

TEST(OwnEdits, MayBeTakenBackMoreOftenThanTheyWereMade) {
    bridge::OwnEdits edits;
    for (const Step step : {Step::Undo, Step::Redo, Step::Redo}) {
        edits.sent(0);
        edits.answered(7, step, true);
        edits.read(0, "");
    }
    EXPECT_FALSE(edits.mayUndo(7, 0, ""));
    EXPECT_FALSE(edits.mayRedo(7, 0, ""));
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
