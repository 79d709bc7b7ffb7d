// Modules of the page by themselves, by the scripts in `modules/`: the function of a test's name, in a
// browser.
#include "web/module_page.h"

#include "bridge/stream/motion_encoder.h"

#include "rtcore/motion/key_codes.h"

#include <set>

namespace {

using test::Json;

class PageModules : public test::ModulePage {};
class Painter : public test::ModulePage {};

TEST_F(PageModules, KeysHaveTheNumbersOfTheServer) {
    passes("key_table_test.js", {{"ArrowLeft", rtcore::KeyLeft},
                                 {"ArrowRight", rtcore::KeyRight},
                                 {"ArrowUp", rtcore::KeyUp},
                                 {"ArrowDown", rtcore::KeyDown},
                                 {"ShiftLeft", rtcore::KeyShift},
                                 {"ShiftRight", rtcore::KeyShift},
                                 {"Space", rtcore::KeySpace},
                                 {"Enter", rtcore::KeyReturn},
                                 {"PageUp", rtcore::KeyPageUp},
                                 {"PageDown", rtcore::KeyPageDown},
                                 {"Home", rtcore::KeyHome},
                                 {"End", rtcore::KeyEnd},
                                 {"Insert", rtcore::KeyInsert},
                                 {"Delete", rtcore::KeyDelete},
                                 {"Backspace", rtcore::KeyBackspace},
                                 {"KeyX", rtcore::KeyControl}});
}

TEST_F(PageModules, LinksAreChecked) { passes("links_test.js"); }
TEST_F(PageModules, BookmarksAreChecked) { passes("links_test.js"); }
TEST_F(PageModules, ALinkToAViewHoldsNoToken) { passes("links_test.js"); }
TEST_F(PageModules, AViewIsGoneToWithAndWithoutPerspective) { passes("links_test.js"); }
TEST_F(PageModules, AViewIsSharedByTheSystemOrCopied) { passes("links_test.js"); }
TEST_F(PageModules, SlidersGoByFactorsWhereTheRangeIsWide) { passes("fields_test.js"); }
TEST_F(PageModules, ALabelLeadsBackByADoubleClick) { passes("fields_test.js"); }
TEST_F(PageModules, OneOfAFewStepsIsPressedOrNone) { passes("fields_test.js"); }

TEST_F(PageModules, SticksHoldKeys) { passes("sticks_test.js", {{"shift", rtcore::KeyShift}}); }
TEST_F(PageModules, AGamepadLetsGoOfItsKeysWithTheWindow) { passes("sticks_test.js"); }

TEST_F(PageModules, AHeldKeyDelaysNothing) { passes("input_test.js"); }
TEST_F(PageModules, CommandLetsGoOfKeysAndTheWheelHasSteps) { passes("input_test.js"); }

TEST_F(PageModules, AModelInTheHandNeverFallsBehind) { passes("orbit_test.js"); }
TEST_F(PageModules, PointsAreShownWithPerspectiveAndWithout) { passes("measures_test.js"); }
TEST_F(PageModules, LinesAreClippedBeforeTheEye) { passes("measures_test.js"); }
TEST_F(PageModules, MeasuresHaveLabels) { passes("measures_test.js"); }
TEST_F(PageModules, AnswersAreRead) { passes("measuring_test.js"); }
TEST_F(PageModules, TapsBecomeMeasures) { passes("measuring_test.js"); }
TEST_F(PageModules, ATapThatIsAnsweredAfterTheEndIsNone) { passes("measuring_test.js"); }
TEST_F(PageModules, NotesAreTextWithoutControlCharacters) { passes("notes_test.js"); }
TEST_F(PageModules, NotesHaveAHead) { passes("notes_test.js"); }
TEST_F(PageModules, PlansAreRead) { passes("plan_test.js"); }
TEST_F(PageModules, StoreysOfPlansAreThoseOfTheSuite) { passes("plan_test.js"); }
TEST_F(PageModules, ATapOnAPlanLeadsThere) { passes("plan_test.js"); }
TEST_F(PageModules, PlansShowWhereOneLooks) { passes("plan_test.js"); }
TEST_F(PageModules, ADoubleClickTurnsThere) { passes("directions_test.js"); }
TEST_F(PageModules, TheScreenIsKeptOnOnce) { passes("wake_lock_test.js"); }
TEST_F(PageModules, SectionsHaveASideAndATrack) { passes("sections_test.js"); }
TEST_F(PageModules, VariantsAreChosenByTheirNumbers) { passes("variants_test.js"); }

TEST_F(PageModules, UndoWaitsForTheLastOne) { passes("edits_test.js"); }
TEST_F(PageModules, ARefusedEditIsToldOnceItIsOver) { passes("edits_test.js"); }

TEST_F(PageModules, AJpegOfStripsIsDecodedInParts) {
    constexpr int kWidth = 1280, kHeight = 720;
    std::vector<std::byte> pixels(std::size_t(4) * kWidth * kHeight);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const std::size_t x = i / 4 % kWidth, y = i / 4 / kWidth;
        pixels[i] = static_cast<std::byte>(i % 4 == 0 ? x / 5 : i % 4 == 1 ? y / 3 : (x + y) / 8);
    }
    const bridge::SharedFrame frame =
        bridge::MotionEncoder().encode({pixels, kWidth, kHeight}, bridge::kRungs[0], {});
    std::ofstream(folder() / "strips.txt") << Json(frame->bytes).dump();
    passes("decoder_test.js", {{"file", "strips.txt"}, {"size", {kWidth, kHeight}}});
}
TEST_F(PageModules, BothWaysOfDecodingKeepEachPixel) { passes("decoder_test.js"); }

TEST_F(PageModules, FieldsShowAnotherUnit) { passes("fields_test.js"); }

TEST_F(PageModules, EachTextIsInBothLanguages) { passes("texts_test.js"); }
TEST_F(PageModules, WhatTheServerSaysIsTranslatedByItsForm) { passes("texts_test.js"); }
TEST_F(PageModules, PluralsAreRight) { passes("texts_test.js"); }
TEST_F(PageModules, SettingsAreCalledAsInTheWindow) { passes("texts_test.js"); }

TEST_F(Painter, DrawsNewerFramesOnly) { passes("painter_test.js"); }
TEST_F(Painter, DrawsAStillOverItsOwnFrameOnly) { passes("painter_test.js"); }
TEST_F(Painter, DrawsNoStillOfMissingParts) { passes("painter_test.js"); }
TEST_F(Painter, AcknowledgesWhatItSkips) { passes("painter_test.js"); }

// A function that no test names would never run.
TEST_F(PageModules, EachScriptHasItsTest) {
    std::set<std::string> tests;
    const testing::UnitTest& all = *testing::UnitTest::GetInstance();
    for (int suite = 0; suite < all.total_test_suite_count(); ++suite)
        for (int i = 0; i < all.GetTestSuite(suite)->total_test_count(); ++i)
            tests.insert(functionOf(*all.GetTestSuite(suite)->GetTestInfo(i)));
    for (const auto& file : std::filesystem::directory_iterator(RT_MODULE_SCRIPTS)) {
        const std::string name = file.path().filename().string();
        if (!name.ends_with("_test.js")) continue;
        for (const Json& function : with(name, "Object.keys(m)"))
            EXPECT_TRUE(tests.contains(function.get<std::string>())) << name << ": " << function;
    }
}

} // namespace
