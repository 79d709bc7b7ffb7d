#include "rtcore/io/import/import_report.h"

#include "rtcore/io/import/import_forms.h"

#include <gtest/gtest.h>

namespace {

using namespace rtcore;

TEST(ImportReport, SurvivesTheWay) {
    ImportReport report;
    report.origin = {"Wavefront", "Blender 3.4", Vec3{0, 0, 1}, 0.0254};
    report.degenerateTriangles = 3;
    report.ignoredPrimitives = 1;
    report.nonFiniteTriangles = 9;
    report.unconnectedTriangles = 4;
    report.equalTriangles = 77;
    addWarning(report, "texture 'a b.png' is missing");
    addWarning(report, say("{0}: {1}", std::string("a\"b"), say("a {0} inside", 7)));
    addFile(report, "/a b/c.obj");
    addFile(report, "/a b/ c.png ");
    addImage(report, "/a b/d.png");
    addFile(report, "/a b/c.obj");
    addFile(report, "/a\nfile x/\\n\\");
    addImage(report, "/a\n\n\\.png");
    EXPECT_EQ(report.files.size(), 5U);
    EXPECT_EQ(readReport("alive\nalive\n" + writeReport(report)), report);
}

TEST(ImportReport, StaysOneLineAWarningAndOfBoundedLength) {
    ImportReport report;
    addWarning(report, std::string("two\nlines\x01"));
    addWarning(report, say("{0} is long", std::string(10000, 'x')));
    EXPECT_EQ(warningLine(report.warnings[0]), R"("two\\x0alines\\x01")");
    EXPECT_LE(report.warnings[1].english().size(), 503U);
    for (int i = 0; i < 1000; ++i) addWarning(report, "w" + std::to_string(i));
    EXPECT_EQ(report.warnings.size(), 51U);
    addWarning(report, "w1");
    EXPECT_EQ(report.warnings.size(), 51U);
}

// Earlier versions wrote warnings as text.
TEST(ImportReport, ReadsWarningsOfText) {
    const Sentence read = readWarning("texture 'a b.png' is missing; its material is plain");
    EXPECT_EQ(read, say(import_forms::kMissingTexture, std::string("'a b.png'")));
    EXPECT_EQ(readWarning(warningLine(read)), read);
    for (const char* text : {"", "another", "7", "[", "[7]", "null"})
        EXPECT_EQ(readWarning(text), Sentence(std::string(text)));
}

TEST(ImportReport, ReadsAnything) {
    EXPECT_EQ(readReport(""), ImportReport{});
    EXPECT_EQ(readReport("degenerate\nfoo bar\n\n degenerate 7"), ImportReport{});
    EXPECT_EQ(readReport("degenerate many").degenerateTriangles, 0U);
}

TEST(ImportReport, NamesTheFirstOfMany) {
    const std::vector<std::string> names{"a", "b", "c", "d", "e"};
    const auto first = [&](std::size_t count) { return firstOf(std::span(names).first(count)).english(); };
    EXPECT_EQ(first(1), "'a'");
    EXPECT_EQ(first(2), "'a' and 'b'");
    EXPECT_EQ(first(3), "'a', 'b' and 'c'");
    EXPECT_EQ(first(4), "'a', 'b', 'c' and 1 more");
    EXPECT_EQ(first(5), "'a', 'b', 'c' and 2 more");
}

TEST(ImportReport, ARefusalIsAFormOnItsWay) {
    const std::string line = refusalLine(say("it has no {0}", std::string("\nrefusal [\"x\"]\n")));
    EXPECT_EQ(line.find('\n'), line.size() - 1);
    const auto read = readRefusal("alive\nrefusal [\"another\"]\n" + line + "alive\n");
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(read->text(), "it has no {0}");
    ASSERT_EQ(read->arguments().size(), 1U);
    EXPECT_FALSE(read->arguments()[0].isForm());
}

TEST(ImportReport, ARefusalIsReadFromAnything) {
    for (const char* text : {"", "\n", "refusal", "refusal ", "refusal x", "refusal 7\n",
                             "refusal [\"a\",7]\n", "arefusal [\"a\"]\n", " refusal [\"a\"]\n"}) {
        EXPECT_FALSE(readRefusal(text).has_value()) << text;
    }
    ImportReport report;
    addWarning(report, std::string("x\nrefusal [\"x\"]"));
    addFile(report, "/x\nrefusal [\"x\"]");
    EXPECT_FALSE(readRefusal(writeReport(report)).has_value());
}

} // namespace
