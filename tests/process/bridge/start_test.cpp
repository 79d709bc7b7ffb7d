// --start, TLS and --origin, without a browser.
#include "process/bridge/bridge_fixture.h"
#include "process/bridge/tls_tunnel.h"
#include "support/run_program.h"

namespace {

using namespace test;

const std::string kRTBridge = std::string(RT_PROGRAM_FOLDER) + "/RTBridge";

TEST(StartedServer, EndsTheBridgeWithItsOwnCode) {
    const IpcInstance instance;
    const std::string program = (instance.folder() / "server.sh").string(),
                      scene = (instance.folder() / "a.scn").string();
    std::ofstream(scene) << "version = 2\n";
    std::ofstream(program) << "#!/bin/sh\necho \"$@\" >" << (instance.folder() / "words").string()
                           << "\nexit 65\n";
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    const ProgramResult result =
        runProgram(kRTBridge, {"--start", scene, "-i", instance.name(), "--listen=127.0.0.1:0"},
                   {.environment = {{"RT_SERVER", program}}, .timeoutSeconds = 30});
    EXPECT_EQ(result.exitCode, 65) << result.error;
    std::string words;
    std::getline(std::ifstream(instance.folder() / "words") >> std::ws, words);
    EXPECT_NE(words.find("--instance=" + instance.name()), std::string::npos) << words;
    EXPECT_NE(words.find("--parent="), std::string::npos) << words;
    EXPECT_TRUE(words.ends_with("-- " + scene)) << words;
}

class Tls : public BridgeTest {
    void SetUp() override {
        const TlsPair files = makeCertificate(instance.folder().path());
        if (files.key.empty()) GTEST_SKIP() << "there is no openssl";
        if (runProgram(kRTBridge, {"--version"}).output.find("OpenSSL: yes") == std::string::npos)
            GTEST_SKIP() << "built without OpenSSL";
        startServer();
        startBridge({"--tls-cert=" + files.certificate, "--tls-key=" + files.key});
        const std::string text = links(), before = "https://127.0.0.1:";
        ASSERT_NE(text.find(before), std::string::npos) << text;
        port = std::atoi(text.c_str() + text.find(before) + before.size());
    }
};

TEST_F(Tls, ServesPagesAndWalks) {
    const std::string own = "127.0.0.1:" + std::to_string(port);
    TlsTunnel page(port), ws(port), foreign(port);
    RawSocket socket = page.socket();
    socket.write("GET / HTTP/1.1\r\nHost: " + own + "\r\nConnection: close\r\n\r\n");
    EXPECT_TRUE(socket.readAll(10s).starts_with("HTTP/1.1 200"));
    WebClient client(ws.socket(), own, "https://" + own);
    ASSERT_EQ(client.status(), 101);
    client.hello(kDriver);
    EXPECT_TRUE(client.binary(1));
    client.input({'W'});
    EXPECT_TRUE(eventually([&] { return server->isHeld('W'); }));
    EXPECT_EQ(WebClient(foreign.socket(), own, "http://" + own).status(), 403);
}

TEST_F(Tls, ServesNothingWithoutIt) {
    RawSocket plain(port);
    plain.write("GET / HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) + "\r\n\r\n");
    EXPECT_EQ(plain.readAll(3s).find("200"), std::string::npos);
}

class Proxied : public BridgeTest {
    void SetUp() override {
        startServer();
        startBridgeBehind("https://viz.example/node7/");
    }

  protected:
    WebClient connect(const std::string& host, const std::string& origin) {
        return {RawSocket(port), host, origin};
    }
};

TEST_F(Proxied, ServesThePageOfTheProxyBelowItsPath) {
    EXPECT_EQ(connect("viz.example", "https://viz.example").status(), 101);
    EXPECT_EQ(connect("viz.example", "http://viz.example").status(), 403);
    EXPECT_EQ(connect("viz.example", "https://evil.example").status(), 403);
    EXPECT_EQ(connect("evil.example", "https://viz.example").status(), 421);
    for (const char* path : {"/", "/node7/"})
        EXPECT_TRUE(
            get(std::string("GET ") + path + " HTTP/1.1\r\nHost: viz.example\r\nConnection: close\r\n\r\n")
                .starts_with("HTTP/1.1 200"))
            << path;
    WebClient below(port, "https://viz.example", "/node7/ws");
    EXPECT_EQ(below.status(), 101);
}

} // namespace
