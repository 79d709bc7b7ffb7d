/// A page of files, for tests of the bridge's modules by themselves: no server, no bridge.
#pragma once

#include "support/temporary_folder.h"
#include "web/web_page.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

namespace test {

/// Fixture: the modules as they are (those in RT_PAGE_MODULES, where that is set), and those that the build
/// makes. Skips where there is no Chromium.
class ModulePage : public testing::Test {
  protected:
    void SetUp() override {
        if (!chromiumProgram()) GTEST_SKIP() << "there is no Chromium";
        namespace fs = std::filesystem;
        const char* const asked = std::getenv("RT_PAGE_MODULES");
        for (const char* const from :
             {asked != nullptr ? asked : RT_PAGE_MODULES, RT_PAGE_MADE, RT_PAGE_PARTS})
            for (const fs::directory_entry& file : fs::directory_iterator(from))
                fs::copy_file(file.path(), folder_.path() / file.path().filename(),
                              fs::copy_options::skip_existing);
        std::ofstream(folder_ / "page.html") << "<!doctype html>";
        page_.emplace(sharedChromium({"--allow-file-access-from-files"}),
                      "file://" + (folder_ / "page.html").string());
        ASSERT_TRUE(page_->becomes("location.protocol === 'file:' && document.readyState === 'complete'"));
    }
    const WebPage& page() const { return *page_; }
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
