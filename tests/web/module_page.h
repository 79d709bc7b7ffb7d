/// A page of files, for tests of the bridge's modules by themselves: no server, no bridge.
#pragma once

#include "support/temporary_folder.h"
#include "web/web_page.h"

#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

namespace test {

/// Fixture: the modules as they are (those in RT_PAGE_MODULES, where that is set), those that the build
/// makes, and the scripts that test them. Skips where there is no Chromium.
class ModulePage : public testing::Test {
  protected:
    void SetUp() override {
        if (!chromiumProgram()) GTEST_SKIP() << "there is no Chromium";
        namespace fs = std::filesystem;
        const char* const asked = std::getenv("RT_PAGE_MODULES");
        for (const char* const from :
             {asked != nullptr ? asked : RT_PAGE_MODULES, RT_PAGE_MADE, RT_MODULE_SCRIPTS})
            for (const fs::directory_entry& file : fs::directory_iterator(from))
                fs::copy_file(file.path(), folder_.path() / file.path().filename(),
                              fs::copy_options::skip_existing);
        std::ofstream(folder_ / "page.html") << "<!doctype html>";
        page_.emplace(sharedChromium({"--allow-file-access-from-files"}),
                      "file://" + (folder_ / "page.html").string());
        ASSERT_TRUE(page_->becomes("location.protocol === 'file:' && document.readyState === 'complete'"));
    }
    /// Runs the function of the running test in that script of `modules/`, with what it is given; failures
    /// are told with their file and line there.
    void passes(const std::string& script, const Json& given = {}) const {
        const std::string name = functionOf(*testing::UnitTest::GetInstance()->current_test_info());
        for (const Json& failure :
             with("expect.js", "m.failuresOf('" + script + "', '" + name + "', " + given.dump() + ")")) {
            const std::string at = failure["file"];
            ADD_FAILURE_AT((RT_MODULE_SCRIPTS "/" + (at.empty() ? script : at)).c_str(),
                           failure["line"].get<int>())
                << failure["text"].get<std::string>();
        }
    }
    /// `KeysHaveNumbers` is tested by `keysHaveNumbers`.
    static std::string functionOf(const testing::TestInfo& test) {
        std::string name = test.name();
        name[0] = static_cast<char>(std::tolower(name[0]));
        return name;
    }
    /// An expression that has the module as `m`.
    Json with(const std::string& module, const std::string& expression) const {
        return page_->value("import('./" + module + "').then((m) => " + expression + ")");
    }
    std::filesystem::path folder() const { return folder_.path(); }

  private:
    TemporaryFolder folder_;
    std::optional<WebPage> page_;
};

} // namespace test
