#include "web/bridged_server.h"

#include <algorithm>
#include <sstream>

#include <png.h>

namespace test {

namespace {

/// The last link behind "Driver: " in what the bridge printed; "" before it did.
std::string linkIn(const std::string& output, const std::string& label) {
    std::istringstream lines(output);
    std::string last;
    for (std::string line; std::getline(lines, line);)
        if (line.rfind(label, 0) == 0 && !lines.eof()) last = line.substr(label.size());
    return last;
}

} // namespace

void BridgedServer::SetUp() {
    if (!chromiumProgram()) GTEST_SKIP() << "there is no Chromium";
    writeRoom(folder() / "room.obj");
}

void BridgedServer::startServer(const std::string& size, const std::vector<std::string>& options) {
    killServer();
    std::vector<std::string> words{"room.obj", "--instance=" + instance_.name(), "--resolution=" + size};
    words.insert(words.end(), options.begin(), options.end());
    server_.emplace(programPath("RTServer"), words, ProgramSettings{.folder = folder().path()});
    ASSERT_TRUE(server_->waitForError("ready: ")) << server_->wait().error;
}

void BridgedServer::startBridge(const std::vector<std::string>& options) {
    std::vector<std::string> words{"--instance=" + instance_.name()};
    words.insert(words.end(), options.begin(), options.end());
    // Tests of the page look at the server's own frames, unless they ask for others.
    for (const std::string option : {"--listen=127.0.0.1:0", "--rest=live"}) {
        const std::string name = option.substr(0, option.find('=') + 1);
        if (std::ranges::none_of(words, [&](const auto& word) { return word.starts_with(name); }))
            words.push_back(option);
    }
    links_ = folder() / ("links" + std::to_string(++bridges_) + ".txt");
    bridge_ = std::make_unique<RunningProgram>(
        programPath("RTBridge"), words,
        ProgramSettings{.folder = folder().path(),
                        .environment = {{"RT_KEEP_PRIORITY", "1"}}, // tests wait for its Renderer
                        .outputFile = links_});
    const bool told = eventually(
        [&] {
            viewerLink_ = linkIn(readBytes(links_), "Viewer: ");
            return !viewerLink_.empty();
        },
        20s);
    ASSERT_TRUE(told) << readBytes(links_);
    driverLink_.clear();
}

std::string BridgedServer::driverLink() {
    std::string newest;
    EXPECT_TRUE(eventually(
        [&] {
            newest = linkIn(readBytes(links_), "Driver: ");
            return newest != driverLink_;
        },
        10s))
        << "the last one was not used";
    return driverLink_ = newest;
}

WebPage BridgedServer::drive(const std::vector<std::string>& bridgeOptions) {
    startServer();
    startBridge(bridgeOptions);
    startBrowser();
    WebPage page(browser(), driverLink());
    EXPECT_TRUE(showsFrame(page));
    page.value("document.querySelector('#orbit[aria-pressed=\"true\"]')?.click()"); // who drives walks
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

std::string BridgedServer::screenshotPixels() {
    const auto file = folder() / ("screenshot" + std::to_string(++screenshots_) + ".png");
    const ProgramResult told =
        runProgram(programPath("CUI"), {"--instance=" + instance_.name(), "screenshot", file.string()});
    EXPECT_EQ(told.exitCode, 0) << told.error;
    return pngPixels(file);
}

std::string BridgedServer::pngPixels(const std::filesystem::path& file) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_file(&image, file.c_str()) == 0) return {};
    image.format = PNG_FORMAT_RGB;
    std::string pixels(PNG_IMAGE_SIZE(image), '\0');
    if (png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) == 0) return {};
    return pixels;
}

std::string BridgedServer::host() const {
    const std::string rest = viewerLink_.substr(viewerLink_.find("//") + 2);
    return rest.substr(0, rest.find('/'));
}

} // namespace test
