// Damaged files: each is read, or refused by a FileError. Nothing else may happen (run under sanitizers,
// too).
#include "rtcore/io/recording/camera_list.h"
#include "rtcore/io/text/cam.h"
#include "rtcore/io/text/scn.h"
#include "rtcore/io/text/set.h"
#include "unit/text/text_test_support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>

namespace {

using test::Random;

int mutationCount() {
    const char* text = std::getenv("RT_MUTATIONS");
    const int count = text == nullptr ? 0 : std::atoi(text);
    return count > 0 ? count : 1500;
}

std::size_t place(Random& random, const std::string& text) { return random.below(text.size() + 1); }

std::string piece(Random& random, const std::string& text) {
    return text.substr(place(random, text), random.below(40));
}

/// Damages `text` in one of several ways; `other` lends pieces.
std::string mutated(std::string text, const std::string& other, Random& random) {
    constexpr std::array<std::string_view, 24> tokens{"=",
                                                      "[",
                                                      "]",
                                                      "{",
                                                      "}",
                                                      "\"",
                                                      "'",
                                                      "\"\"\"",
                                                      "\n",
                                                      "\r",
                                                      ".",
                                                      ",",
                                                      "nan",
                                                      "-inf",
                                                      "1e999",
                                                      "-0.0",
                                                      "9223372036854775807",
                                                      "1979-05-27T07:32:00Z",
                                                      "true",
                                                      "\\u0000",
                                                      "\xFF",
                                                      "\xEF\xBB\xBF",
                                                      "a.b.c.d",
                                                      "[["};
    const std::size_t at = place(random, text);
    switch (random.below(8)) {
    case 0:
        return text.substr(0, at);
    case 1:
        return text.substr(at);
    case 2:
        return text.insert(at, tokens.at(random.below(tokens.size())));
    case 3:
        return text.insert(at, piece(random, other));
    case 4:
        return text.erase(at, random.below(12));
    case 5:
        return text.insert(at, 1, static_cast<char>(random.below(256)));
    case 6:
        return text.replace(at, random.below(12), tokens.at(random.below(tokens.size())));
    default:
        break;
    }
    if (at < text.size()) text[at] = static_cast<char>(text[at] ^ static_cast<char>(1U << random.below(8)));
    return text;
}

/// How many of the damaged examples were still read.
template <typename Read>
int survivors(const std::string& tag, std::uint32_t seed, Read read) {
    const auto examples = test::documentedExamples(tag);
    if (examples.empty()) return 0;
    Random random(seed);
    int readable = 0;
    for (int i = 0; i < mutationCount(); ++i) {
        std::string text = examples[random.below(examples.size())];
        for (std::size_t damages = 1 + random.below(3); damages > 0; --damages)
            text = mutated(text, examples[random.below(examples.size())], random);
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
    EXPECT_LT(readable, mutationCount());
}

TEST(Mutation, ScenesAreReadOrRefused) {
    expectSome(survivors("toml scn", 51, [](const std::string& text) {
        const rtcore::SceneFile scene = rtcore::parseSceneFile(text, "/s/x.scn");
        // What was read can be written and read again.
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
