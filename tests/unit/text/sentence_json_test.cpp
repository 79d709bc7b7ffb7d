/// Sentences on their way to programs that show them in another language.
#include "rtcore/io/text/sentence_json.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <string>

namespace {

using rtcore::say;
using rtcore::sentenceJson;

TEST(SentenceJson, HasTheFormAndWhatStandsInItsPlaces) {
    EXPECT_EQ(sentenceJson(say("there is nothing to undo")), R"(["there is nothing to undo"])");
    EXPECT_EQ(sentenceJson(say("{0}: {1}", std::string("a.cam"), say("no light {0}", 7))),
              R"(["{0}: {1}","a.cam",["no light {0}","7"]])");
    EXPECT_EQ(sentenceJson(std::string("a text")), R"("a text")");
}

TEST(SentenceJson, IsOneLineOfJsonWhateverANameHolds) {
    std::string name;
    for (int code = 0; code < 256; ++code) name += static_cast<char>(code);
    for (const std::string& each :
         {name, std::string("\"],[\"x"), std::string("\\"), std::string("\n2 offer x"),
          std::string("\xE2\x80\xAE"
                      "abc"),
          std::string(3, '\0')}) {
        const std::string text = sentenceJson(say("there is no {0}", each));
        EXPECT_EQ(text.find('\n'), std::string::npos);
        const auto read = nlohmann::json::parse(text, nullptr, false);
        ASSERT_TRUE(read.is_array()) << text;
        EXPECT_EQ(read.size(), 2U);
        EXPECT_EQ(read[0], "there is no {0}");
        for (const char c : read[1].get<std::string>()) EXPECT_GE(static_cast<unsigned char>(c), 0x20);
    }
}

} // namespace
