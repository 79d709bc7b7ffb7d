// The licences of what the programs are linked with.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace {

std::string contentOf(const std::string& path) {
    std::ifstream file(std::string(RT_SOURCE_FOLDER) + "/" + path);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

TEST(Licences, AreToldOfEachLibraryThatSetUpInstalls) {
    const std::string document = contentOf("docs/licences.md");
    std::istringstream packages(contentOf("scripts/packages.txt"));
    int libraries = 0;
    for (std::string line; std::getline(packages, line);) {
        const std::string name = line.substr(0, line.find_first_of(" |#"));
        if (!name.ends_with("-dev")) continue;
        ++libraries;
        EXPECT_NE(document.find("`" + name + "`"), std::string::npos) << name;
    }
    EXPECT_GT(libraries, 10);
}

} // namespace
