// Text that is no TOML is refused in words of ours, whatever toml++ calls its fault.
#include "rtcore/io/text/toml_parser.h"
#include "rtcore/platform/sentence.h"
#include "support/damaged_text.h"
#include "unit/text/text_test_support.h"

#include <gtest/gtest.h>

namespace {

using Words = std::string;

struct Fault {
    const char *text, *said; ///< behind the file's name
};

constexpr Fault kFaults[] = {
    {"model = \"a.obj\nup = 1", "1:15: a text does not end; close its quotes on the same line"},
    {"model = 'a.obj\n", "1:15: a text does not end; close its quotes on the same line"},
    {"model = \"C:\\models\\a.obj\"",
     "1:13: a backslash has a meaning of its own in double quotes; write two of them, or put the text in "
     "single quotes"},
    {"model = \"C:\\users\"",
     "1:14: a backslash has a meaning of its own in double quotes; write two of them, or put the text in "
     "single quotes"},
    {"model = a.obj", "1:9: this is no value; a text stands in quotes, a switch is true or false"},
    {"model = tree.obj", "1:11: this is no value; a text stands in quotes, a switch is true or false"},
    {"model = island", "1:10: this is no value; a text stands in quotes, a switch is true or false"},
    {"on = true2", "1:10: this is no value; a text stands in quotes, a switch is true or false"},
    {"x = 1,5", "1:6: ',' does not belong on this line; begin a new one, or a comment with #"},
    {"x = 12cm", "1:7: this is no number; write it like 7, -0.5 or 1e6, and a text in quotes"},
    {"x = 1.5.2", "1:8: this is no number; write it like 7, -0.5 or 1e6, and a text in quotes"},
    {"x = 007", "1:8: this is no number; write it like 7, -0.5 or 1e6, and a text in quotes"},
    {"x = 1__2", "1:7: this is no number; write it like 7, -0.5 or 1e6, and a text in quotes"},
    {"x = 0x", "1:7: this is no number; write it like 7, -0.5 or 1e6, and a text in quotes"},
    {"x = 99999999999999999999", "1:25: 99999999999999999999 is too large a number"},
    {"x = 1e999", "1:10: 1e999 is too large a number"},
    {"x = 2026-13-01",
     "1:12: this is no date and no time; a text stands in quotes, a number is like 7, -0.5 or 1e6"},
    {"x = 12:61:00",
     "1:10: this is no date and no time; a text stands in quotes, a number is like 7, -0.5 or 1e6"},
    {"x = 1\xC2\xA0", "1:6: a character stands here that cannot be seen; delete it"},
    {"x = \x01", "1:5: a character stands here that cannot be seen; delete it"},
    {"x = 1 # \x01", "1:9: a character stands here that cannot be seen; delete it"},
    {"x = 1\r y = 2", "1:7: a character stands here that cannot be seen; delete it"},
    {"x = 1\f", "1:6: a character stands here that cannot be seen; delete it"},
    {"[a.=]", "1:4: a key cannot hold '='; it is of letters, digits, - and _, or stands in quotes"},
    {"[=]", "1:2: a key cannot hold '='; it is of letters, digits, - and _, or stands in quotes"},
    {"\"\"\"a\"\"\" = 1", "1:1: a key stands on one line; use one quote at each end, not three"},
    {"x = [1, 2", "1:10: the file ends in the middle of a line or a list; complete it"},
    {"x =", "1:4: the file ends in the middle of a line or a list; complete it"},
    {"[camera", "1:8: the file ends in the middle of a line or a list; complete it"},
    {"[]", "1:2: a section begins with [name] or [[name]]"},
    {"[ [a]]", "1:3: a section begins with [name] or [[name]]"},
    {"[camera\nx = 1", "1:8: a ] should stand here, not '\\n'; a section begins with [name] or [[name]]"},
    {"x = 1\nx = 2", "2:5: 'x' is there twice; keep one of them"},
    {"[camera]\n[camera]", "2:1: 'camera' is there twice; keep one of them"},
    {"camera = 1\n[camera.x]", "2:11: 'camera.x' is there twice; keep one of them"},
    {"x = 1\nx.y = 2",
     "2:1: a key is there twice, or once as a value and once as a section; keep one of them"},
    {"a = {b = 1}\n[a.c]",
     "2:6: a key is there twice, or once as a value and once as a section; keep one of them"},
    {"x : 1", "1:3: a = should stand here, not ':'; a line reads key = value"},
    {"eye [1, 2, 3]", "1:5: a = should stand here, not '['; a line reads key = value"},
    {"x =\ny = 1", "1:4: a value is missing here"},
    {"x = [1,,2]", "1:8: a value is missing here"},
    {"x = 1 y = 2", "1:7: 'y' does not belong on this line; begin a new one, or a comment with #"},
    {"<scene>", "1:1: a line cannot begin with '<'; it reads key = value, or [name]"},
    {"x = [1 2]", "1:8: a comma or ] should stand here, not '2'"},
    {"x = {a = 1,\n}", "1:12: what stands in braces reads { key = value, key = value }, all on one line"},
    {"x = {a = 1 b = 2}", "1:12: what stands in braces reads { key = value, key = value }, all on one line"},
};

Words said(const Words& text) {
    return test::badData([&] { rtcore::parseToml(text, "f"); });
}

TEST(TomlTexts, AreOurs) {
    for (const Fault& fault : kFaults) EXPECT_EQ(said(fault.text), Words("f:") + fault.said) << fault.text;
}

TEST(TomlTexts, OfDamagedFilesAreOursToo) {
    std::vector<Words> examples;
    for (const char* tag : {"toml scn", "toml cam", "toml set"})
        for (const Words& each : test::documentedExamples(tag)) examples.push_back(each);
    test::DamagedText damaged(examples, test::kTomlTokens, 55);
    long refused = 0;
    for (long i = 0; i < test::damagedTexts(); ++i) {
        const Words words = said(damaged.next());
        refused += words == "no error" ? 0 : 1;
        EXPECT_EQ(words.find("library"), Words::npos) << words;
    }
    EXPECT_GT(refused, 0);
}

TEST(TomlTexts, HaveBoundedNames) {
    const Words key(1 << 20, 'k');
    EXPECT_LT(said(key + " = 1\n" + key + " = 2").size(), 500U);
}

} // namespace
