/// An RTServer, an RTBridge beside it and a Chromium, for tests of the page.
#pragma once

#include "ipc/endpoint/client.h"
#include "process/sample_scene.h"
#include "support/ipc_instance.h"
#include "support/run_program.h"
#include "web/web_page.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace test {

/// Fixture. Skips where there is no Chromium.
class BridgedServer : public testing::Test {
  protected:
    void SetUp() override;

    /// In place of the one before, which is killed. `options`: added to its command line.
    void startServer(const std::string& size = "160x120", const std::vector<std::string>& options = {});
    void killServer() {
        client_.reset();
        server_.reset();
    }
    /// On a port that the system chooses, or `options` do; the links are known then.
    void startBridge(const std::vector<std::string>& options = {});
    /// Beside the first one, which goes on; the links are its own from then on.
    void startSecondBridge() {
        first_ = std::move(bridge_);
        startBridge({"--view-only"});
    }
    void startBrowser(const std::vector<std::string>& options = {}) { browser_ = &sharedChromium(options); }
    /// All three, and a page of the driver that shows the first frame.
    WebPage drive(const std::vector<std::string>& bridgeOptions = {});

    /// The page has shown a frame.
    static bool showsFrame(const WebPage& page) {
        return page.becomes("document.getElementById('waiting')?.hidden");
    }
    /// The exact image is shown.
    static bool isExact(const WebPage& page) {
        return page.becomes("document.getElementById('save')?.disabled === false");
    }
    /// Takes keyboard and mouse, by keyboard.
    static void capture(const WebPage& page);

    /// A command to the server that must succeed; its answer.
    std::string ask(const std::string& command);
    /// The pixels that `CUI screenshot` writes of the frame that is shown, 3 bytes each.
    std::string screenshotPixels();
    /// The pixels of a PNG file, 3 bytes each; "" while there is none.
    static std::string pngPixels(const std::filesystem::path& file);
    ipc::Client& client();
    Chromium& browser() { return *browser_; }
    /// Each is good once: another one each time, as soon as the last one was used.
    std::string driverLink();
    /// The address of the page, without a token.
    std::string address() const { return viewerLink_.substr(0, viewerLink_.find('#')); }
    const std::string& viewerLink() const { return viewerLink_; }
    /// "127.0.0.1:8931"
    std::string host() const;
    const std::string& instance() const { return instance_.name(); }
    RunningProgram& bridge() { return *bridge_; }
    const TemporaryFolder& folder() const { return instance_.folder(); }

  private:
    IpcInstance instance_;
    std::optional<RunningProgram> server_;
    std::unique_ptr<RunningProgram> bridge_, first_;
    Chromium* browser_ = nullptr;
    std::unique_ptr<ipc::Client> client_;
    std::string driverLink_, viewerLink_;
    std::filesystem::path links_; ///< the file of the links that the bridge printed
    int bridges_ = 0, screenshots_ = 0;
};

} // namespace test
