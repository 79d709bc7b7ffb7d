#include "web/bridged_server.h"

#include <sstream>

namespace test {

namespace {

/// The link behind "Driver: " in what the bridge printed; "" before it did.
std::string linkIn(const std::string& output, const std::string& label) {
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);)
        if (line.rfind(label, 0) == 0 && !lines.eof()) return line.substr(label.size());
    return {};
}

} // namespace

void BridgedServer::SetUp() {
    if (!chromiumProgram()) GTEST_SKIP() << "there is no Chromium";
    writeRoom(folder() / "room.obj");
}

void BridgedServer::startServer(const std::string& size) {
    server_.emplace(
        programPath("RTServer"),
        std::vector<std::string>{"room.obj", "--instance=" + instance_.name(), "--resolution=" + size},
        ProgramSettings{.folder = folder().path()});
    ASSERT_TRUE(server_->waitForError("ready: ")) << server_->wait().error;
}

void BridgedServer::startBridge(const std::vector<std::string>& options) {
    std::vector<std::string> words{"--instance=" + instance_.name(), "--listen=127.0.0.1:0"};
    words.insert(words.end(), options.begin(), options.end());
    const std::filesystem::path output = folder() / ("links" + std::to_string(++bridges_) + ".txt");
    bridge_ = std::make_unique<RunningProgram>(
        programPath("RTBridge"), words, ProgramSettings{.folder = folder().path(), .outputFile = output});
    const bool told = eventually(
        [&] {
            viewerLink_ = linkIn(readBytes(output), "Viewer: ");
            return !viewerLink_.empty();
        },
        20s);
    ASSERT_TRUE(told) << readBytes(output);
    driverLink_ = linkIn(readBytes(output), "Driver: ");
}

WebPage BridgedServer::drive() {
    startServer();
    startBridge();
    startBrowser();
    WebPage page(browser(), driverLink());
    EXPECT_TRUE(showsFrame(page));
    return page;
}

void BridgedServer::capture(const WebPage& page) {
    page.value("document.getElementById('view').focus()");
    page.keyDown("Enter");
    page.keyUp("Enter");
    EXPECT_TRUE(page.becomes("document.getElementById('stage').classList.contains('captured')"));
}

ipc::Client& BridgedServer::client() {
    if (!client_) client_ = std::make_unique<ipc::Client>(instance_.name(), 20s);
    return *client_;
}

std::string BridgedServer::ask(const std::string& command) {
    const ipc::Reply reply = client().request(command, 60s);
    EXPECT_EQ(reply.status, ipc::ReplyStatus::Done) << command << ": " << reply.text;
    return reply.text;
}

std::string BridgedServer::host() const {
    const std::string rest = viewerLink_.substr(viewerLink_.find("//") + 2);
    return rest.substr(0, rest.find('/'));
}

} // namespace test
