// --start, TLS and --origin, without a browser.
#include "process/bridge/bridge_fixture.h"
#include "support/run_program.h"

namespace {

using namespace test;

const std::string kBridge = std::string(RT_PROGRAM_FOLDER) + "/RTBridge";

TEST(StartedServer, EndsTheBridgeWithItsOwnCode) {
    const IpcInstance instance;
    const std::string program = (instance.folder() / "server.sh").string(),
                      scene = (instance.folder() / "a.scn").string();
    std::ofstream(scene) << "version = 2\n";
    std::ofstream(program) << "#!/bin/sh\necho \"$@\" >" << (instance.folder() / "words").string()
                           << "\nexit 65\n";
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    const ProgramResult result =
        runProgram(kBridge, {"--start", scene, "-i", instance.name(), "--listen=127.0.0.1:0"},
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
        const std::string key = (instance.folder() / "key.pem").string(),
                          certificate = (instance.folder() / "cert.pem").string();
        const ProgramResult made =
            runProgram("/usr/bin/openssl", {"req", "-x509", "-newkey", "rsa:2048", "-nodes", "-keyout", key,
                                            "-out", certificate, "-days", "2", "-subj", "/CN=localhost"});
        if (made.exitCode != 0) GTEST_SKIP() << "there is no openssl";
        if (runProgram(kBridge, {"--version"}).output.find("OpenSSL: yes") == std::string::npos)
            GTEST_SKIP() << "built without OpenSSL";
        startServer();
        startBridge({"--tls-cert=" + certificate, "--tls-key=" + key});
        const std::string text = links(), before = "https://127.0.0.1:";
        ASSERT_NE(text.find(before), std::string::npos) << text;
        port = std::atoi(text.c_str() + text.find(before) + before.size());
    }
};

TEST_F(Tls, ServesPagesAndHealth) {
    const std::string own = "127.0.0.1:" + std::to_string(port);
    std::string answer;
    const auto served = [&] {
        answer =
            runProgram("/bin/sh",
                       {"-c", "printf 'GET /health HTTP/1.1\\r\\nHost: " + own +
                                  "\\r\\nConnection: close\\r\\n\\r\\n' | openssl s_client -quiet -connect " +
                                  own + " 2>/dev/null"},
                       {.timeoutSeconds = 20})
                .output;
        return answer.starts_with("HTTP/1.1 200");
    };
    EXPECT_TRUE(eventually(served, 5s)) << answer;
    RawSocket plain(port);
    plain.write("GET / HTTP/1.1\r\nHost: " + own + "\r\n\r\n");
    EXPECT_EQ(plain.readAll(3s).find("200"), std::string::npos) << "nothing without TLS";
}

class Proxied : public BridgeTest {
    void SetUp() override {
        startServer();
        for (int candidate = 20'000 + static_cast<int>(ipc::randomTag() % 20'000); port == 0; ++candidate) {
            startBridge({"--origin=https://viz.example/node7/"}, "127.0.0.1:" + std::to_string(candidate));
            if (links().find("https://viz.example/node7/#t=") != std::string::npos) port = candidate;
        }
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
