/// Sentences on their way to programs that show them in another language.
#include "rtcore/io/text/sentence_json.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <string>

namespace {

using rtcore::readSentenceJson;
using rtcore::say;
using rtcore::Sentence;
using rtcore::sentenceJson;

TEST(SentenceJson, HasTheFormAndWhatStandsInItsPlaces) {
    EXPECT_EQ(sentenceJson(say("there is nothing to undo")), R"(["there is nothing to undo"])");
    EXPECT_EQ(sentenceJson(say("{0}: {1}", std::string("a.cam"), say("no light {0}", 7))),
              R"(["{0}: {1}","a.cam",["no light {0}","7"]])");
    EXPECT_EQ(sentenceJson(std::string("a text")), R"("a text")");
}

TEST(SentenceJson, TakesWhatIsNearlyUtf8) {
    // Surrogates, beyond the last character, too long, cut off.
    for (const char* each :
         {"\xED\xA0\x80", "\xF4\x90\x80\x80", "\xC0\xAF", "\xF0\x80\x80\x80", "a\xE2\x80"}) {
        std::string text;
        EXPECT_NO_THROW(text = sentenceJson(say("there is no {0}", std::string(each))));
        EXPECT_TRUE(readSentenceJson(text)) << text;
    }
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

Sentence nested(int depth) {
    Sentence sentence = std::string("a text");
    for (int i = 0; i < depth; ++i) sentence = say("in {0}", sentence);
    return sentence;
}

TEST(SentenceJson, IsReadAsItWasWritten) {
    const Sentence written[] = {say("there is nothing to undo"), Sentence(std::string("a \"text\" \\[{0}")),
                                say("{0}: {1}", std::string("a.cam"), say("no light {0}", 7)), nested(32)};
    for (const Sentence& each : written) {
        const std::string text = sentenceJson(each);
        const auto read = readSentenceJson(text);
        ASSERT_TRUE(read.has_value()) << text;
        EXPECT_EQ(read->isForm(), each.isForm());
        EXPECT_EQ(read->text(), each.text());
        EXPECT_EQ(read->arguments().size(), each.arguments().size());
        EXPECT_EQ(read->english(), each.english());
        EXPECT_EQ(sentenceJson(*read), text);
    }
}

TEST(SentenceJson, OfAnyOtherTextNothingIsRead) {
    const auto repeated = [](const std::string& text, int times) {
        std::string all;
        for (int i = 0; i < times; ++i) all += text;
        return all;
    };
    for (const std::string& each : {std::string(),
                                    std::string(" "),
                                    std::string("a"),
                                    std::string("7"),
                                    std::string("null"),
                                    std::string("{}"),
                                    std::string("[]"),
                                    std::string("[7]"),
                                    std::string("[[\"a\"]]"),
                                    std::string(R"(["a",7])"),
                                    std::string(R"(["a",null])"),
                                    std::string(R"(["a",{}])"),
                                    std::string(R"(["a",["b",[]]])"),
                                    std::string(R"({"a":"b"})"),
                                    std::string(R"(["a"] "b")"),
                                    std::string(R"(["a")"),
                                    std::string("\"a"),
                                    std::string("\"\xFF\""),
                                    std::string("[\"\xC3\"]"),
                                    repeated("[", 100'000),
                                    repeated("[\"a\",", 100'000),
                                    repeated("[", 60'000),
                                    repeated("[\"a\",", 10'000),
                                    repeated("{\"a\":", 10'000),
                                    sentenceJson(nested(33)),
                                    '"' + std::string(65'519, 'a') + '"'}) {
        EXPECT_FALSE(readSentenceJson(each).has_value()) << each.substr(0, 40);
    }
    EXPECT_TRUE(readSentenceJson('"' + std::string(65'518, 'a') + '"').has_value());
}

} // namespace
