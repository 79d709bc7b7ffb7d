/// Tables of the documents that are made from tables of the code. Such a section of a file stands between the
/// lines
/// "<!-- NAME -->" and "<!-- end -->".
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <string>
#include <string_view>

namespace test {

/// "| first | second |\n"; the bars within a cell are escaped.
inline std::string tableRow(std::initializer_list<std::string_view> cells) {
    std::string row = "|";
    for (const std::string_view cell : cells) {
        row += ' ';
        for (const char c : cell) row += c == '|' ? std::string("\\|") : std::string(1, c);
        row += " |";
    }
    return row + "\n";
}

/// Expects that the section `name` of the file at `path` is `wanted`. With RT_RENEW_DOCS in the environment
/// it is written there instead.
inline void expectSection(const std::string& path, const std::string& name, const std::string& wanted) {
    std::ifstream file(path, std::ios::binary);
    std::string page{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const std::string mark = "<!-- " + name + " -->\n";
    const std::size_t marked = page.find(mark), begin = marked + mark.size();
    const std::size_t end = marked == std::string::npos ? marked : page.find("<!-- end -->\n", begin);
    if (end == std::string::npos) {
        ADD_FAILURE() << path << " has no section \"" << name << "\": write the lines " << mark
                      << "<!-- end -->\nwhere it is to stand";
    } else if (std::getenv("RT_RENEW_DOCS") != nullptr) {
        std::ofstream(path, std::ios::binary) << page.replace(begin, end - begin, wanted);
    } else {
        EXPECT_EQ(page.substr(begin, end - begin), wanted)
            << "RT_RENEW_DOCS=1 in the environment of this test (--gtest_filter="
            << testing::UnitTest::GetInstance()->current_test_info()->test_suite_name()
            << ".*) writes the section \"" << name << "\" of " << path << " anew";
    }
}

} // namespace test
