// Damaged files: each is read, or refused by a FileError. Nothing else may happen (run under sanitizers,
// too).
#include "rtcore/io/recording/camera_list.h"
#include "rtcore/io/text/cam.h"
#include "rtcore/io/text/scn.h"
#include "rtcore/io/text/set.h"
#include "support/damaged_text.h"
#include "unit/text/text_test_support.h"

#include <gtest/gtest.h>

namespace {

/// How many of the damaged examples were still read.
template <typename Read>
int survivors(const std::string& tag, std::uint32_t seed, Read read) {
    const auto examples = test::documentedExamples(tag);
    if (examples.empty()) return 0;
    test::DamagedText damaged(examples, test::kTomlTokens, seed);
    int readable = 0;
    for (long i = 0; i < test::damagedTexts(); ++i) {
        const std::string text = damaged.next();
        try {
            read(text);
            ++readable;
        } catch (const rtcore::FileError& error) {
            EXPECT_EQ(error.kind, rtcore::FailureKind::BadData);
            EXPECT_LT(std::string(error.what()).size(), 2000U);
        } catch (const std::exception& error) {
            ADD_FAILURE() << error.what() << "\n" << text;
        }
    }
    return readable;
}

/// Some damage goes unseen (in comments, in names), some does not.
void expectSome(int readable) {
    EXPECT_GT(readable, 0);
    EXPECT_LT(readable, test::damagedTexts());
}

TEST(Mutation, ScenesAreReadOrRefused) {
    expectSome(survivors("toml scn", 51, [](const std::string& text) {
        const rtcore::SceneFile scene = rtcore::parseSceneFile(text, "/s/x.scn");
        // A scene that was read can be written and read again.
        rtcore::parseSceneFile(rtcore::formatSceneFile(scene, "/s/x.scn"), "/s/x.scn");
    }));
}

TEST(Mutation, CamerasAreReadOrRefused) {
    expectSome(survivors("toml cam", 52, [](const std::string& text) {
        const rtcore::CameraFile camera = rtcore::parseCameraFile(text, "x.cam");
        EXPECT_EQ(rtcore::parseCameraFile(rtcore::formatCameraFile(camera), "x.cam"), camera);
    }));
}

TEST(Mutation, SettingsAreReadOrRefused) {
    expectSome(survivors("toml set", 53, [](const std::string& text) {
        const rtcore::SettingsFile settings = rtcore::parseSettingsFile(text, "x.set");
        EXPECT_EQ(rtcore::parseSettingsFile(rtcore::formatSettingsFile(settings), "x.set"), settings);
    }));
}

TEST(Mutation, ListsAreReadOrRefused) {
    expectSome(
        survivors("text list", 54, [](const std::string& text) { rtcore::parseCameraList(text, "l"); }));
}

} // namespace
