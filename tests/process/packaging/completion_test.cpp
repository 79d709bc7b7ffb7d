/// Tab in bash: the script that is installed, and what the programs answer it.
#include "common/commands/command_table.h"
#include "process/packaging/program_specs.h"
#include "process/server/live_server.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace {

using namespace test;
namespace fs = std::filesystem;

const char* const kBash = "/bin/bash";

// Calls a completion as readline does: with the line in words, parted at blanks and at COMP_WORDBREAKS.
const char* const kDriver = R"(
source "$1" || exit 3
COMP_LINE=$2 COMP_POINT=${#2} COMP_WORDS=() rest=$2
token='^[[:blank:]]*(([=:]+|([^[:blank:]=:\\]|\\.)+)(.*))$'
while [[ $rest =~ $token ]]; do
    COMP_WORDS+=("${BASH_REMATCH[2]}")
    rest=${BASH_REMATCH[4]}
done
[[ $COMP_LINE == *[[:blank:]] ]] && COMP_WORDS+=("")
COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
function=$(complete -p "${COMP_WORDS[0]}") && function=${function#*-F } && function=${function%% *}
$function || exit 4
((${#COMPREPLY[@]} == 0)) || printf '%s\n' "${COMPREPLY[@]}"
)";

using Replies = std::set<std::string>;

class Completion : public LiveServer {
  protected:
    void SetUp() override {
        if (!fs::exists(kBash)) GTEST_SKIP() << "there is no " << kBash;
        LiveServer::SetUp();
        for (const char* file : {"a.scn", "b.bsp", "c.cam", "my view.cam", "d.set", "notes.txt"})
            writeText(folder() / file, "");
        fs::create_directory(folder() / "sub");
    }
    std::set<std::string> complete(const std::string& line) const {
        const std::string program = line.substr(0, line.find(' '));
        const fs::path script =
            fs::path(RT_BUILD_FOLDER) / "share" / "bash-completion" / "completions" / program;
        ProgramSettings settings{.folder = folder().path()};
        settings.environment = {{"PATH", std::string(RT_PROGRAM_FOLDER) + ":" + std::getenv("PATH")}};
        const ProgramResult result =
            runProgram(kBash, {"-c", kDriver, "bash", script.string(), line}, settings);
        EXPECT_EQ(result.exitCode, 0) << line << result.error;
        EXPECT_EQ(result.error, "") << line;
        std::istringstream lines(result.output);
        std::set<std::string> replies;
        for (std::string reply; std::getline(lines, reply);) replies.insert(reply);
        return replies;
    }
};

TEST_F(Completion, OffersEachOptionOfTheHelp) {
    for (const app::ProgramSpec* spec : packagedPrograms()) {
        const std::string help = runProgram(programPath(spec->name), {"--help"}).output;
        const Replies offered = complete(spec->name + " -");
        const std::regex option(R"(\n  +((?:-[-a-z]+, )*--[a-z-]+)(=?))");
        Replies found;
        for (std::sregex_iterator each(help.begin(), help.end(), option), end; each != end; ++each) {
            std::istringstream spellings((*each)[1].str());
            for (std::string spelling; spellings >> spelling;) {
                if (spelling.ends_with(',')) spelling.pop_back();
                if (spelling.starts_with("--")) spelling += (*each)[2].str();
                found.insert(spelling);
            }
        }
        EXPECT_EQ(found, offered) << spec->name;
    }
}

TEST_F(Completion, OffersEachCommandOfTheHelp) {
    std::map<std::string, Replies> replies;
    for (const app::CommandSpec& command : app::commandTable()) {
        std::istringstream words{std::string(command.name)};
        std::string typed = "CUI ";
        for (std::string word; words >> word; typed += word + " ") {
            if (!replies.contains(typed)) replies[typed] = complete(typed);
            EXPECT_TRUE(replies[typed].contains(word)) << typed << word;
        }
    }
}

TEST_F(Completion, OfOptionsAndTheirValues) {
    EXPECT_EQ(complete("Renderer --form"), Replies{"--format="});
    EXPECT_EQ(complete("Renderer --format="), (Replies{"png", "ppm"}));
    EXPECT_EQ(complete("Renderer --format pn"), Replies{"png"});
    EXPECT_EQ(complete("BSPBuilder x.obj --progress=b"), Replies{"bar"});
    EXPECT_TRUE(complete("RTServer --isa=").contains("scalar"));
    EXPECT_EQ(complete("Renderer -a "), Replies{});
    EXPECT_EQ(complete("Renderer --nonsense="), Replies{});
    EXPECT_EQ(complete("Renderer -- --form"), Replies{});
}

TEST_F(Completion, OfSettings) {
    EXPECT_EQ(complete("Renderer --setting=maxD"), Replies{"maxDepth="});
    EXPECT_EQ(complete("Renderer --setting exposure.mode=f"), Replies{"fixed"});
    EXPECT_EQ(complete("CUI set exposure.m"), Replies{"exposure.mode"});
    EXPECT_EQ(complete("CUI set exposure.mode "), (Replies{"automatic", "fixed", "incident"}));
    EXPECT_EQ(complete("CUI set ambientOcclusion.on "), (Replies{"on", "off"}));
    EXPECT_EQ(complete("CUI get maxD"), Replies{"maxDepth"});
}

TEST_F(Completion, OfFilesByTheirExtension) {
    EXPECT_EQ(complete("Renderer "), (Replies{"a.scn", "b.bsp", "room.obj", "sub"}));
    EXPECT_EQ(complete("Renderer --camera="), (Replies{"c.cam", "my view.cam", "sub"}));
    EXPECT_EQ(complete("Renderer --camera my\\ v"), Replies{"my view.cam"});
    EXPECT_EQ(complete("RTServer a.scn --set "), (Replies{"d.set", "sub"}));
    EXPECT_EQ(complete("BSPBuilder room.obj "), (Replies{"b.bsp", "sub"}));
    EXPECT_EQ(complete("Renderer no"), Replies{"notes.txt"}) << "any file where no usual one fits";
    EXPECT_EQ(complete("CUI load camera "), (Replies{"c.cam", "my view.cam", "sub"}));
    EXPECT_EQ(complete("CUI load set "), (Replies{"d.set", "sub"}));
}

TEST_F(Completion, OfCommandsAndTheirArguments) {
    EXPECT_EQ(complete("CUI camera l"), (Replies{"lens", "look-at"}));
    EXPECT_TRUE(complete("CUI light 1 ").contains("off"));
    EXPECT_TRUE(complete("CUI light ").contains("temperature"));
    EXPECT_EQ(complete("CUI key press sp"), Replies{"space"});
    EXPECT_TRUE(complete("CUI key release ").contains("all"));
    EXPECT_EQ(complete("CUI play st"), Replies{"stop"});
    EXPECT_EQ(complete("CUI bind k ju"), Replies{"jump"});
    EXPECT_EQ(complete("CUI --timeout 3 fp"), Replies{"fps"});
    EXPECT_EQ(complete("CUI render a.png "), Replies{"--"});
    EXPECT_EQ(complete("CUI render a.png -- --antia"), Replies{"--antialiasing="});
    EXPECT_EQ(complete("CUI render a.png -- -a 3 --format="), (Replies{"png", "ppm"}));
}

TEST_F(Completion, OfInstancesThatRun) {
    start();
    EXPECT_TRUE(complete("CUI --instance=").contains(instance.name()));
    EXPECT_EQ(complete("CUI -i " + instance.name()), Replies{instance.name()});
#ifdef RT_HAS_BRIDGE
    EXPECT_EQ(complete("RTBridge -i " + instance.name()), Replies{instance.name()});
    EXPECT_EQ(complete("RTBridge --start="), (Replies{"a.scn", "b.bsp", "room.obj", "sub"}));
#endif
}

} // namespace
