// A driver's link is good once; what a browser keeps of it lets nobody in.
#include "process/bridge/web_client.h"
#include "web/bridged_server.h"

namespace {

using test::WebPage;

class OnceLink : public test::BridgedServer {
  protected:
    static bool drives(const WebPage& page) {
        return page.becomes("document.getElementById('view').classList.contains('drives')");
    }
    static bool says(const WebPage& page, const std::string& words) {
        return page.becomes("document.getElementById('notices').textContent.includes('" + words + "')");
    }
    /// Whether a file of the folder has it, with letters of one byte or of two.
    static bool holds(const std::filesystem::path& folder, const std::string& token) {
        std::string wide;
        for (const char letter : token) wide += {letter, '\0'};
        std::error_code gone; // files come and go
        for (std::filesystem::recursive_directory_iterator file(folder, gone), end; file != end;
             file.increment(gone)) {
            if (!file->is_regular_file(gone)) continue;
            const std::string bytes = test::readBytes(file->path());
            if (bytes.find(token) != std::string::npos || bytes.find(wide) != std::string::npos) return true;
        }
        return false;
    }
    bool letsDriverIn(const std::string& token) const {
        const std::string where = host();
        test::WebClient client(std::stoi(where.substr(where.find(':') + 1)));
        client.hello(token);
        const test::Json welcome = client.event("welcome", std::chrono::seconds(2));
        return !welcome.is_null() && welcome["mayDrive"] == true;
    }
    static std::string tokenOf(const std::string& link) { return link.substr(link.find("#t=") + 3); }
};

TEST_F(OnceLink, LetsOnePageInWhichMayBeLoadedAgain) {
    startServer();
    startBridge();
    startBrowser();
    const std::string link = driverLink();
    const WebPage first(browser(), link);
    ASSERT_TRUE(drives(first));
    first.value("window.mark = 1");
    first.leave("location.reload()");
    ASSERT_TRUE(first.becomes("window.mark === undefined && document.readyState === 'complete'"));
    EXPECT_TRUE(drives(first)) << "loaded again";
    first.open("about:blank");
    ASSERT_TRUE(first.becomes("location.href === 'about:blank'"));
    first.leave("history.back()");
    ASSERT_TRUE(first.becomes("document.getElementById('view')"));
    EXPECT_TRUE(drives(first)) << "and after a page between";

    const WebPage second(browser(), link);
    EXPECT_TRUE(says(second, "has been used"));
    second.open(driverLink());
    EXPECT_TRUE(second.becomes("document.getElementById('pill-text').textContent !== ''"))
        << "the next one does";
    second.open(link);
    EXPECT_TRUE(says(second, "has been used"));
    EXPECT_TRUE(second.becomes("document.getElementById('pill-text').textContent !== ''"))
        << "it stays what it was";
}

// Keeps the token with which the page may come back, as it is told.
constexpr const char* kKeepOwn = R"(
window.Worker = class extends Worker {
    constructor(...words) {
        super(...words);
        this.addEventListener("message", ({ data }) => {
            const said = data.said ? JSON.parse(data.said) : {};
            if (said.event === "welcome") window.own = said.token;
        });
    }
};)";

// Killed, since a browser that is closed in order tells the bridge, where the page's token ends then.
TEST_F(OnceLink, THOROUGH_NothingThatABrowserKeepsLetsADriverIn) {
    startServer();
    startBridge();
    test::Chromium own;
    const std::string link = driverLink();
    const WebPage page = WebPage::ofProfile(own, "about:blank");
    page.call("Page.addScriptToEvaluateOnNewDocument", {{"source", kKeepOwn}});
    page.open(link);
    ASSERT_TRUE(drives(page));
    page.value("window.mark = 1");
    page.leave("location.reload()");
    ASSERT_TRUE(page.becomes("window.mark === undefined && document.readyState === 'complete'"));
    ASSERT_TRUE(drives(page));
    const std::string token = page.value("window.own");
    EXPECT_TRUE(letsDriverIn(token)) << "as long as the page is there";
    ASSERT_TRUE(test::eventually(
        [&] {
            own.listen(std::chrono::milliseconds(1000));
            return holds(own.profile(), tokenOf(link));
        },
        std::chrono::seconds(40)))
        << "it keeps the address";
    own.kill();
    EXPECT_FALSE(letsDriverIn(tokenOf(link)));
    EXPECT_FALSE(holds(own.profile(), token));
}

} // namespace
