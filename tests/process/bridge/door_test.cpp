// Who is let in.
#include "process/bridge/bridge_fixture.h"

#include <fmt/core.h>

#include <sys/stat.h>

namespace {

using namespace test;

class Door : public BridgeTest {
  protected:
    /// The status of a raw request; `%` stands for the port.
    int statusOf(std::string request) {
        for (std::size_t at = 0; (at = request.find('%', at)) != std::string::npos;)
            if (request.compare(at, 2, "%p") == 0)
                request.replace(at, 2, std::to_string(port));
            else
                ++at;
        RawSocket socket(port);
        socket.write(request);
        std::string answer;
        for (int i = 0; i < 30 && answer.find("\r\n") == std::string::npos && !socket.closed(); ++i)
            answer += socket.read(100ms);
        return answer.starts_with("HTTP/1.1 ") ? std::stoi(answer.substr(9, 3)) : 0;
    }
};

TEST_F(Door, OpensForPagesOfThisVeryBridgeOnly) {
    const std::string own = std::to_string(port);
    EXPECT_EQ(WebClient(port).status(), 101);
    for (const std::string& origin :
         {std::string("-"), std::string("null"), std::string("http://evil.example"),
          "http://localhost:" + own, "https://127.0.0.1:" + own,
          "http://127.0.0.1:" + std::to_string(port + 1), "http://127.0.0.1:" + own + "0",
          "http://127.0.0.1:" + own + ".evil.example"})
        EXPECT_EQ(WebClient(port, origin).status(), 403) << origin;
}

TEST_F(Door, AnswersOnlyToItsOwnNames) {
    for (const char* host :
         {"evil.example", "evil.example:%p", "127.0.0.1.evil.example:%p", "169.254.169.254", "0.0.0.0:%p"})
        for (const char* path : {"/", "/ws", "/health", "/nothing"})
            EXPECT_EQ(statusOf(fmt::format("GET {} HTTP/1.1\r\nHost: {}\r\n\r\n", path, host)), 421) << host;
    EXPECT_EQ(statusOf("GET / HTTP/1.1\r\nHost: localhost:%p\r\n\r\n"), 200);
}

TEST_F(Door, RefusesRequestsThatAreNone) {
    const std::string host = "Host: 127.0.0.1:%p\r\n";
    const struct {
        std::string request;
        int status;
    } rows[] = {
        {"GET /ws HTTP/1.1\r\n" + host + "Origin: http://127.0.0.1:%p\r\n\r\n", 426},
        {"GET /ws HTTP/1.1\r\n" + host +
             "Origin: http://127.0.0.1:%p\r\nUpgrade: websocket\r\nConnection: "
             "Upgrade\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n",
         400},
        {"GET / HTTP/1.1\r\n\r\n", 400},
        {"GET / HTTP/1.1\r\n" + host + host + "\r\n", 400},
        {"GET http://127.0.0.1:%p/ HTTP/1.1\r\n" + host + "\r\n", 400},
        {"GET / HTTP/1.1\r\n" + host + "Transfer-Encoding: chunked\r\n\r\n0\r\n\r\n", 400},
        {"GET / HTTP/1.1\r\n" + host + "Transfer-Encoding: xchunked\r\n\r\n", 400},
        {"GET / HTTP/1.1\r\n" + host + "Transfer-Encoding: identity\r\n\r\n", 400},
        {"GET / HTTP/1.1\r\n" + host + "Transfer-Encoding:\r\n\r\n", 400},
        {"GET / HTTP/1.1\r\n" + host + "transfer-encoding:\r\n chunked\r\n\r\n0\r\n\r\n", 400},
        {"GET / HTTP/1.1\r\n" + host + "Transfer-Encoding: x\r\nTransfer-Encoding: chunked\r\n\r\n", 400},
        {"GET / HTTP/1.1\r\n" + host + "Transfer-Encoding: gzip, chunked\r\nContent-Length: 0\r\n\r\n", 400},
        {"GET / HTTP/1.1\r\n" + host + "Content-Length: 0\r\n\r\n", 400},
        {"HEAD / HTTP/1.1\r\n" + host + "Transfer-Encoding: xchunked\r\n\r\n", 400},
        {"GET /ws HTTP/1.1\r\n" + host + "Transfer-Encoding: xchunked\r\n\r\n", 400},
        {"GET / HTTP/1.1\r\n" + host + "Content-Length: 3\r\n\r\nabc", 0},
        {"POST / HTTP/1.1\r\n" + host + "Content-Length: 0\r\n\r\n", 405},
        {"DELETE / HTTP/1.1\r\n" + host + "\r\n", 405},
        {"GET /../etc/passwd HTTP/1.1\r\n" + host + "\r\n", 404},
        {"GET /%2e%2e/etc/passwd HTTP/1.1\r\n" + host + "\r\n", 404},
        {"GET //etc/passwd HTTP/1.1\r\n" + host + "\r\n", 404},
        {"GET /index.html/ HTTP/1.1\r\n" + host + "\r\n", 404},
        {"GET / HTTP/1.0\r\n" + host + "\r\n", 505},
        {"GET / HTTP/1.1\r\n" + host + "X: " + std::string(20'000, 'x') + "\r\n\r\n", 0},
    };
    for (const auto& row : rows) {
        const int status = statusOf(row.request);
        if (row.status == 0)
            EXPECT_NE(status, 200) << row.request.substr(0, 200);
        else
            EXPECT_EQ(status, row.status) << row.request.substr(0, 200);
    }
    EXPECT_EQ(WebClient(port).status(), 101) << "served on";
}

TEST_F(Door, GivesPagesThatTrustNothingElse) {
    const std::string answer = page("/");
    EXPECT_TRUE(answer.starts_with("HTTP/1.1 200"));
    for (const char* header :
         {"Content-Security-Policy: default-src 'none'; script-src 'self'", "X-Content-Type-Options: nosniff",
          "Referrer-Policy: no-referrer", "Cross-Origin-Opener-Policy: same-origin", "text/html"})
        EXPECT_NE(answer.find(header), std::string::npos) << header;
    EXPECT_EQ(answer.find("Set-Cookie"), std::string::npos);
    EXPECT_EQ(answer.find(kDriver), std::string::npos);
    const std::size_t tag = answer.find("ETag: ");
    ASSERT_NE(tag, std::string::npos);
    const std::string value = answer.substr(tag + 6, answer.find('\r', tag) - tag - 6);
    EXPECT_TRUE(page("/", "If-None-Match: " + value + "\r\n").starts_with("HTTP/1.1 304"));
}

TEST_F(Door, TellsFiguresOnlyWithAToken) {
    EXPECT_TRUE(eventually([&] { return page("/health").starts_with("HTTP/1.1 200"); }));
    EXPECT_TRUE(page("/status").starts_with("HTTP/1.1 401"));
    EXPECT_TRUE(page("/metrics", "Authorization: Bearer wrong\r\n").starts_with("HTTP/1.1 401"));
    const auto client = join();
    const std::string status = page("/status", std::string("Authorization: Bearer ") + kViewer + "\r\n");
    const auto content = nlohmann::json::parse(status.substr(status.find("\r\n\r\n") + 4));
    EXPECT_EQ(content["instances"][0]["sessions"].size(), 1U);
    EXPECT_EQ(status.find(kDriver), std::string::npos);
    EXPECT_NE(page("/metrics", std::string("Authorization: Bearer ") + kViewer + "\r\n")
                  .find("\nrtbridge_sessions{"),
              std::string::npos);
}

TEST_F(Door, TakesTheRightTokenOfTheRightVersion) {
    const struct {
        std::string token;
        nlohmann::json more;
        int code;
    } rows[] = {{"", {}, 4003},
                {"wrong", {}, 4003},
                {std::string(kDriver) + "x", {}, 4003},
                {kDriver, {{"v", 1}}, 4010},
                {kDriver, {{"v", "2"}}, 4010},
                {kDriver, {{"instance", "no"}}, 4004}};
    for (const auto& row : rows) {
        WebClient client(port);
        client.hello(row.token, "", row.more.is_null() ? nlohmann::json::object() : row.more);
        EXPECT_EQ(client.closeCode(), row.code) << row.token << row.more;
    }
    WebClient binary(port);
    binary.sendBinary({5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    EXPECT_EQ(binary.closeCode(), 4002);
    EXPECT_EQ(server->clients(), 0);
}

TEST_F(Door, ClosesOnWhoeverSaysNothing) {
    WebClient client(port);
    EXPECT_FALSE(client.next(1s)) << "nothing is told before hello";
    EXPECT_EQ(client.closeCode(10s), 4001);
}

TEST_F(Door, LocksOldLinksOutWhenTheFileOfTokensIsReadAgain) {
    auto client = join();
    const std::filesystem::path tokens = instance.folder() / "tokens";
    std::ofstream(tokens) << "too short\n";
    bridge.send(SIGUSR1);
    EXPECT_EQ(client->request({{"do", "walk"}})["ok"], true) << "a wrong file changes nothing";
    std::ofstream(tokens) << "other-driver-other-driver\n" << kViewer << "\n";
    bridge.send(SIGUSR1);
    EXPECT_EQ(client->closeCode(), 4003);
    client.reset(); // the connection, too
    WebClient old(port);
    old.hello(kDriver);
    EXPECT_EQ(old.closeCode(), 4003);
    EXPECT_TRUE(eventually( // once the first one's session is gone
        [&] {
            return join("other-driver-other-driver")->request({{"do", "walk"}})["ok"] == true;
        }));
}

/// With links that are in no file.
class OnceDoor : public BridgeTest {
    void SetUp() override {
        startServer();
        const std::string output = (instance.folder() / "links").string();
        bridge = ChildProcess(std::string(RT_PROGRAM_FOLDER) + "/RTBridge",
                              {"--instance=" + instance.name(), "--listen=127.0.0.1:0", "--rest=live"},
                              {.outputFile = output});
        ASSERT_TRUE(eventually([&] { return links().find("Viewer: ") != std::string::npos; }, 10s));
        port = std::atoi(links().c_str() + links().find("127.0.0.1:") + 10);
    }

  protected:
    /// The token behind the last line of that name.
    std::string last(const std::string& name) const {
        const std::string text = links();
        const std::size_t start = text.find("#t=", text.rfind(name)) + 3;
        return text.substr(start, text.find('\n', start) - start);
    }
    /// The close code; 0: it was let in.
    int codeFor(const std::string& token, const nlohmann::json& more = nlohmann::json::object()) {
        WebClient client(port);
        client.hello(token, "", more);
        return std::max(client.closeCode(700ms), 0);
    }
};

TEST_F(OnceDoor, LetsOnePageInByEachDriversLink) {
    const std::string link = last("Driver: ");
    EXPECT_EQ(codeFor(link, {{"instance", "no"}}), 4004);
    EXPECT_EQ(codeFor(link, {{"v", 1}}), 4010);
    WebClient first(port);
    first.hello(link);
    const nlohmann::json welcome = first.event("welcome");
    ASSERT_EQ(welcome["role"], "driver") << "those that were refused have not used it";
    const std::string own = welcome.value("token", "");
    EXPECT_EQ(own.size(), 43U);
    EXPECT_EQ(codeFor(link), 4005);
    EXPECT_TRUE(page("/status", "Authorization: Bearer " + link + "\r\n").starts_with("HTTP/1.1 401"));
    EXPECT_TRUE(page("/status", "Authorization: Bearer " + own + "\r\n").starts_with("HTTP/1.1 200"));
    ASSERT_TRUE(eventually([&] { return last("Driver: ") != link; })) << "the next one is printed";
    EXPECT_EQ(links().find(own), std::string::npos);
    const auto second = join(last("Driver: ").c_str());
    EXPECT_EQ(second->request({{"do", "ask"}})["ok"], true);
    WebClient again(port);
    again.hello(own);
    EXPECT_EQ(again.event("welcome")["token"], own) << "it was loaded again";
    for (int i = 0; i < 2; ++i) EXPECT_EQ(codeFor(last("Viewer: ")), 0) << "good for any number";
}

class UnixDoor : public BridgeTest {
    void SetUp() override {
        startServer();
        startBridge({}, "unix");
    }
};

TEST_F(UnixDoor, IsASocketOfThisUserAlone) {
    const std::string text = links();
    const std::size_t at = text.find("ssh -L 8931:");
    ASSERT_NE(at, std::string::npos) << text;
    const std::string path = text.substr(at + 12, text.find(' ', at + 12) - at - 12);
    struct stat facts {};
    ASSERT_EQ(::lstat(path.c_str(), &facts), 0) << path;
    EXPECT_TRUE(S_ISSOCK(facts.st_mode));
    EXPECT_EQ(facts.st_mode & 0777U, 0600U);
    WebClient client(RawSocket(path), "127.0.0.1:9000", "http://127.0.0.1:9000");
    ASSERT_EQ(client.status(), 101);
    client.hello(kDriver);
    EXPECT_EQ(client.event("welcome")["role"], "driver");
    EXPECT_EQ(WebClient(RawSocket(path), "evil.example", "http://evil.example").status(), 421);
    bridge.send(SIGTERM);
    bridge.wait();
    EXPECT_NE(::lstat(path.c_str(), &facts), 0) << "removed at the end";
}

} // namespace
