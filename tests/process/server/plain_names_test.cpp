/// Names of others in all that RTServer and CUI print: nothing that a terminal obeys, nothing that turns the
/// direction of what stands around it.
#include "process/server/live_server.h"

#include "rtcore/settings/plain_text.h"

#include <gtest/gtest.h>

#include <csignal>
#include <string_view>

namespace {

using namespace test;

/// One of each kind: C0, DEL, C1, separators, marks of direction.
constexpr std::array<std::string_view, 13> kAttacks{"\x1b]0;owned\x07",
                                                    "\x1b]52;c;eA==\x07",
                                                    "\x7f",
                                                    "\u0085",
                                                    "\u009b31m",
                                                    "\u061c",
                                                    "\u200e\u200f",
                                                    "\u2028",
                                                    "\u2029",
                                                    "\u202e",
                                                    "\u202a\u202b",
                                                    "\u202c\u202d",
                                                    "\u2066\u2067\u2068\u2069"};

/// As a string of TOML in double quotes.
std::string inToml(std::string_view text) {
    std::string result;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        constexpr std::string_view digits = "0123456789abcdef";
        if (byte < 0x20 || byte == 0x7F)
            result += {'\\', 'u', '0', '0', digits[byte >> 4U], digits[byte & 15U]};
        else
            result += c;
    }
    return result;
}

/// `text` but for tabs and ends of lines; empty when nothing is wrong with it.
std::string controlsIn(std::string_view text) {
    std::string found;
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t end = std::min(rest.find_first_of("\t\n"), rest.size());
        const std::string shown = rtcore::printable(rest.substr(0, end));
        if (shown != rest.substr(0, end)) found += shown + '\n';
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return found;
}

class PlainNames : public LiveServer {
  protected:
    void SetUp() override {
        std::string model = "v -4 0 -4\nv 4 0 -4\nv 4 0 4\nv -4 0 4\n", scene;
        for (std::size_t i = 0; i < kAttacks.size(); ++i) {
            const std::string attack(kAttacks.at(i)), number = std::to_string(i);
            const std::string escaped = inToml(attack);
            model +=
                "o part" + attack + "z" + number + "\nusemtl mat" + attack + "z" + number + "\nf 1 2 3\n";
            scene += "[[light]]\nname = \"light" + escaped + "z\"\nkind = \"point\"\nposition = [0, 4, " +
                     number + "]\nintensity = [9, 9, 9]\n[[bookmark]]\nname = \"place" + escaped + "z" +
                     number + "\"\neye = [0, 2, " + number +
                     "]\nlookAt = [0, 0, -9]\n[[material]]\nname = \"none" + escaped + "z" + number +
                     "\"\nroughness = 0.5\n[[environment]]\nname = \"map" + escaped +
                     "z\"\nequirectangular = \"sky.hdr\"\n";
        }
        writeText(folder() / "m.obj", model);
        writeText(folder() / "sky.hdr", std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n") +
                                            "\x40\x40\x40\x80\x40\x40\x40\x80");
        writeText(folder() / name_,
                  "version = 2\nmodel = \"m.obj\"\n[camera]\neye = [0, 3, 6]\nlookAt = [0, 0, 0]\n" + scene);
    }

    const std::string name_ = "scene\u202e\x1b[31m.scn";
};

TEST_F(PlainNames, NoListingAndNoMessageHoldsAControl) {
    start({}, name_);
    for (const Names& listing :
         {Names{"lights"}, Names{"bookmarks"}, Names{"materials"}, Names{"parts"}, Names{"environments"},
          Names{"messages", "0"}, Names{"state"}, Names{"settings"}, Names{"light", "get", "1"},
          Names{"light", "get", "10"}, Names{"material", "get", "1"}, Names{"seen", "0.5", "0.5"},
          Names{"status"}, Names{"list"}, Names{"bindings"}}) {
        SCOPED_TRACE(testing::PrintToString(listing));
        const ProgramResult result = cui(listing);
        EXPECT_EQ(result.exitCode, 0) << result.error;
        EXPECT_EQ(controlsIn(result.output), "");
        EXPECT_EQ(controlsIn(result.error), "");
    }
    EXPECT_NE(ask({"lights"}).find("light\\xe2\\x80\\xaez"), std::string::npos);
    EXPECT_NE(ask({"environments"}).find("map\\xe2\\x80\\xaez"), std::string::npos);
    EXPECT_NE(ask({"messages", "0"}).find("none\\xe2\\x80\\xaez"), std::string::npos);
    for (const Names& wrong :
         {Names{"load", "scene", "no\u202e\x1b[31m.scn"}, Names{"material", "get", "\u202e\x9b"},
          Names{"bookmark", "go", "\u202e"}, Names{"part", "hide", "\x1b[31m"},
          Names{"environment", "open", "no\u202e.hdr"}, Names{"set", "\u202e", "1"}, Names{"\u202e"}}) {
        SCOPED_TRACE(testing::PrintToString(wrong));
        const ProgramResult result = cui(wrong);
        EXPECT_NE(result.exitCode, 0);
        EXPECT_EQ(controlsIn(result.output + result.error), "");
    }
    EXPECT_EQ(controlsIn(end(SIGTERM).error), "");
}

// Commands take a name as a list tells it.
TEST_F(PlainNames, ABookmarkIsKnownByTheNameThatIsTold) {
    start({}, name_);
    const std::string told = "place\\xe2\\x80\\xaez9";
    EXPECT_NE(ask({"bookmarks"}).find(told), std::string::npos);
    ask({"bookmark", "go", told});
    ask({"bookmark", "rename", told, "plain"});
    EXPECT_NE(ask({"bookmarks"}).find("\nplain\n"), std::string::npos);
    ask({"bookmark", "go", std::string("place\u2029z8")}); // its own name, too
    refused({"light", "name", "2", "no text \xff"}, 2, "UTF-8");
    ask({"light", "name", "2", "new\u202e\x1b]0;x\x07"});
    EXPECT_NE(ask({"lights"}).find("2 on new\\xe2\\x80\\xae\\x1b]0;x\\x07\n"), std::string::npos);
}

} // namespace
