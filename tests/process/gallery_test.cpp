/// scripts/gallery.sh and its page: every figure has its images, its row and its command.
#include "process/sample_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const fs::path kProject = RT_SOURCE_FOLDER;
const fs::path kPictures = kProject / "docs" / "gallery";

test::ProgramResult gallery(const Words& words) {
    return test::runProgram(kProject / "scripts" / "gallery.sh", words,
                            {.environment = {{"RT_BIN", RT_PROGRAM_FOLDER}}, .timeoutSeconds = 300});
}

Words linesOf(const std::string& text) {
    Words lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

bool isJpeg(const fs::path& path) {
    const std::string bytes = test::readBytes(path);
    return bytes.size() > 1000 && bytes.starts_with("\xFF\xD8\xFF") && bytes.ends_with("\xFF\xD9");
}

/// As headings have it: More for more.
std::string capitalised(std::string word) {
    if (word[0] >= 'a' && word[0] <= 'z') word[0] = static_cast<char>(word[0] - 'a' + 'A');
    return word;
}

/// "8.6 cube" of each image, as --list has them.
std::vector<std::pair<std::string, std::string>> listed() {
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const std::string& line : linesOf(gallery({"--list"}).output)) {
        const std::size_t space = line.find(' ');
        pairs.emplace_back(line.substr(0, space), line.substr(space + 1));
    }
    return pairs;
}

TEST(Gallery, ListsAPictureForEveryFigure) {
    std::set<std::string> figures, names;
    for (const auto& [figure, name] : listed()) {
        figures.insert(figure);
        EXPECT_TRUE(names.insert(name).second) << name << " is there twice";
    }
    for (int figure = 1; figure <= 13; ++figure)
        EXPECT_TRUE(figures.contains("8." + std::to_string(figure))) << figure;
}

TEST(Gallery, PageShowsEveryPictureUnderItsFigure) {
    const std::string page = test::readBytes(kPictures / "README.md");
    std::set<std::string> files = {"README.md"};
    for (const auto& [figure, name] : listed()) {
        files.insert(name + ".jpg");
        EXPECT_TRUE(isJpeg(kPictures / (name + ".jpg"))) << name;
        const std::size_t shown = page.find("](" + name + ".jpg)");
        ASSERT_NE(shown, std::string::npos) << name;
        const std::size_t heading = page.rfind("\n## ", shown);
        ASSERT_NE(heading, std::string::npos) << name;
        const std::string title = page.substr(heading, page.find('\n', heading + 1) - heading);
        EXPECT_TRUE(title.find(capitalised(figure) + ":") != std::string::npos ||
                    title.find(figure + " ") != std::string::npos)
            << name << " stands under" << title;
    }
    const Words found = test::filesIn(kPictures);
    EXPECT_EQ(std::set<std::string>(found.begin(), found.end()), files);
}

TEST(Gallery, PageHasTheCommandsThatAreRun) {
    const Words page = linesOf(test::readBytes(kPictures / "README.md"));
    const Words commands = linesOf(gallery({"--commands"}).output);
    EXPECT_EQ(commands.size(), listed().size());
    for (const std::string& command : commands)
        EXPECT_NE(std::find(page.begin(), page.end(), command), page.end()) << command;
}

TEST(Gallery, RefusesAnUnknownName) {
    test::TemporaryFolder folder;
    const test::ProgramResult result = gallery({"--quick", "--output", folder.path().string(), "8.14"});
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_NE(result.error.find("'8.14'"), std::string::npos) << result.error;
    EXPECT_TRUE(test::filesIn(folder.path()).empty());
}

TEST(Gallery, RendersTheFigureAskedFor) {
    if (test::runProgram("/bin/sh", {"-c", "command -v python3"}).exitCode != 0)
        GTEST_SKIP() << "python3 is missing: the model cannot be made";
    test::TemporaryFolder folder;
    const test::ProgramResult result = gallery({"--quick", "--output", folder.path().string(), "8.6"});
    ASSERT_EQ(result.exitCode, 0) << result.error;
    EXPECT_EQ(test::filesIn(folder.path()), (Words{"cube-bloom.jpg", "cube.jpg"}));
    for (const std::string& name : test::filesIn(folder.path())) EXPECT_TRUE(isJpeg(folder / name)) << name;
    EXPECT_NE(result.output.find("[2/2] 8.6 cube-bloom"), std::string::npos) << result.output;
}

} // namespace
