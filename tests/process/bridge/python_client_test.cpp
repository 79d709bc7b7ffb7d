// docs/bridge_client.py: another client, in another language, by the document alone, with a real server.
#include "process/bridge/png_pixels.h"
#include "process/bridge/tls_tunnel.h"
#include "process/server/live_server.h"

#include <cstdio>

namespace {

using namespace test;

const char* const kPython = "/usr/bin/python3";

class PythonClient : public LiveServer {
  protected:
    void SetUp() override {
        if (runProgram(kPython, {"-c", "import websockets"}).exitCode != 0)
            GTEST_SKIP() << "there is no python3-websockets";
        LiveServer::SetUp();
        start();
    }
    void startBridge(const std::vector<std::string>& options = {}) {
        std::vector<std::string> words{"--instance=" + instance.name(), "--listen=127.0.0.1:0"};
        words.insert(words.end(), options.begin(), options.end());
        const std::string output = (folder() / "links").string();
        const auto isRest = [](const std::string& word) { return word.starts_with("--rest="); };
        if (std::ranges::none_of(words, isRest)) words.emplace_back("--rest=live");
        bridge_ = ChildProcess(programPath("RTBridge").string(), words, {.outputFile = output});
        EXPECT_TRUE(eventually([&] { return bytes("links").find("Viewer: ") != std::string::npos; }, 20s));
    }
    std::string link(const std::string& label) const {
        const std::string text = bytes("links");
        const std::size_t start = text.find(label) + label.size();
        return text.substr(start, text.find('\n', start) - start);
    }
    ProgramResult runClient(const std::string& address, const std::vector<std::string>& options = {}) const {
        std::vector<std::string> words{RT_DOCUMENTS "/bridge_client.py", address};
        words.insert(words.end(), options.begin(), options.end());
        return runProgram(kPython, words, {.folder = folder().path()});
    }
    void expectFlight(const ProgramResult& result) const {
        double along = 0, beside = 1, after = 1;
        int frames = 0;
        EXPECT_EQ(result.exitCode, 0) << result.error;
        EXPECT_EQ(std::sscanf(result.output.c_str(), "along %lf beside %lf after %lf frames %d", &along,
                              &beside, &after, &frames),
                  4)
            << result.output;
        EXPECT_GT(along, 0.05);
        EXPECT_LT(beside, 0.02 * along + 0.001);
        EXPECT_EQ(after, 0) << "keys that are let go";
        EXPECT_GE(frames, 1);
    }

  private:
    ChildProcess bridge_;
};

TEST_F(PythonClient, FliesStopsAndHasTheServersPixels) {
    startBridge();
    expectFlight(runClient(link("Driver: ")));
    ask({"wait-idle"});
    ask({"screenshot", "server.png"});
    const auto shown = rgbOf(bytes("still.png")), drawn = rgbOf(bytes("server.png"));
    EXPECT_EQ(shown.size(), 64U * 48 * 3);
    EXPECT_TRUE(shown == drawn);
}

TEST_F(PythonClient, IsToldWhatItMayNot) {
    startBridge();
    const ProgramResult viewer = runClient(link("Viewer: ")), wrong = runClient(link("Viewer: ") + "x");
    EXPECT_EQ(viewer.exitCode, 1) << viewer.error;
    EXPECT_EQ(wrong.exitCode, 75) << wrong.error;
    EXPECT_NE(wrong.error.find("the token is wrong"), std::string::npos) << wrong.error;
}

TEST_F(PythonClient, FliesOverTls) {
    const TlsPair files = makeCertificate(folder().path(), "IP:127.0.0.1");
    if (files.key.empty()) GTEST_SKIP() << "there is no openssl";
    if (runProgram(programPath("RTBridge"), {"--version"}).output.find("OpenSSL: yes") == std::string::npos)
        GTEST_SKIP() << "built without OpenSSL";
    ask({"set", "path.samples", "4"}); // what it saves is the finished image by paths
    startBridge({"--tls-cert=" + files.certificate, "--tls-key=" + files.key, "--rest=paths"});
    ASSERT_TRUE(link("Driver: ").starts_with("https://"));
    expectFlight(runClient(link("Driver: "), {"--trust=" + files.certificate}));
}

} // namespace
