/// Sentences whose form can be translated.
#include "rtcore/platform/error.h"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <string>

namespace {

using namespace rtcore;

TEST(Sentences, AreFilledIn) {
    EXPECT_EQ(Sentence().english(), "");
    EXPECT_EQ(say("nothing to fill in").english(), "nothing to fill in");
    EXPECT_EQ(say("{1} before {0}", "a", 2).english(), "2 before a");
    EXPECT_EQ(say("no {0}; {1}", 7, say("only {0} and {0}", std::string("b"))).english(),
              "no 7; only b and b");
}

TEST(Sentences, LeavePlacesAloneForWhichNothingStands) {
    EXPECT_EQ(say("{0} {1} {x} {", "a").english(), "a {1} {x} {");
    EXPECT_EQ(say("{0}", std::string("{0} {1}")).english(), "{0} {1}") << "a name is no form";
    EXPECT_FALSE(Sentence(std::string("text")).isForm());
    EXPECT_TRUE(Sentence("form").isForm());
}

TEST(Sentences, AreWhatExceptionsSay) {
    const Refusal refusal(say("there is no light {0}", 7));
    EXPECT_STREQ(refusal.what(), "there is no light 7");
    EXPECT_EQ(sentenceOf(refusal).text(), "there is no light {0}");
    const FileError error(FailureKind::BadData, "a.scn", say("{0} is empty", std::string("name")), 3, 4);
    EXPECT_STREQ(error.what(), "a.scn:3:4: name is empty");
    EXPECT_EQ(sentenceOf(error).arguments()[1].text(), "{0} is empty");
    const Sentence plain = sentenceOf(std::runtime_error("{0} of others"));
    EXPECT_FALSE(plain.isForm());
    EXPECT_EQ(plain.english(), "{0} of others");
}

TEST(Sentences, AreReadByTheirForms) {
    constexpr std::array forms{"texture {0} is missing", "{0}' and '{1}", "{0}: {1}", "all is well"};
    for (const char* text : {"texture 'a' is missing", "textures 'a' and 'b'", "all is well",
                             "x: y: all is well", "texture  is missing", "", "{0}", ": ", "a: ", "' and '"}) {
        EXPECT_EQ(readAs(text, forms).english(), text) << text;
    }
    const Sentence read = readAs("a b.obj: texture 'x: y' is missing", forms);
    ASSERT_EQ(read.text(), "{0}: {1}");
    EXPECT_EQ(read.arguments()[0].text(), "a b.obj");
    EXPECT_EQ(read.arguments()[1].text(), "texture {0} is missing");
    EXPECT_EQ(read.arguments()[1].arguments()[0].english(), "'x: y'");
    EXPECT_FALSE(readAs("something else", forms).isForm());
    std::string deep;
    for (int i = 0; i < 1000; ++i) deep += "a: ";
    EXPECT_EQ(readAs(deep + "b", forms).english(), deep + "b");
}

} // namespace
