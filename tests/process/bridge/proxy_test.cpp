// Behind nginx, configured as docs/bridge.md says. RT_BRIDGE_IDLE asks for that many seconds of silence, by
// the proxy's and the bridge's own times.
#include "process/bridge/bridge_fixture.h"
#include "process/bridge/tls_tunnel.h"

#include <fmt/core.h>

#include <arpa/inet.h>
#include <netinet/in.h>

#include <regex>
#include <set>

namespace {

using namespace test;

const char* const kNginx = "/usr/sbin/nginx";
const std::string kOrigin = "https://viz.example", kPrefix = "/node7/";

/// The nginx configuration that the document tells the administrator to write.
std::string documentedLocation() {
    std::ostringstream page;
    page << std::ifstream(RT_DOCUMENTS "/bridge.md").rdbuf();
    const std::string text = page.str(), fence = "```nginx\n";
    const std::size_t start = text.find(fence);
    if (start == std::string::npos) return {};
    return text.substr(start + fence.size(), text.find("```", start + 3) - start - fence.size());
}

int freePort() {
    const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    ::bind(socket, reinterpret_cast<const sockaddr*>(&address), size);
    ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size);
    ::close(socket);
    return ntohs(address.sin_port);
}

class Nginx : public BridgeTest {
  protected:
    void SetUp() override {
        if (!std::filesystem::exists(kNginx)) GTEST_SKIP() << "there is no nginx";
        pair_ = makeCertificate(instance.folder().path());
        if (pair_.key.empty()) GTEST_SKIP() << "there is no openssl";
    }
    /// `readTimeout`: seconds after which the proxy cuts what is silent.
    void start(int readTimeout, const std::vector<std::string>& options = {}) {
        startServer();
        startBridgeBehind(kOrigin + kPrefix, options);
        std::string location = documentedLocation();
        const std::string target = "http://127.0.0.1:8931/";
        const std::size_t at = location.find(target);
        ASSERT_NE(at, std::string::npos) << location;
        location.replace(at, target.size(), fmt::format("http://127.0.0.1:{}/", port));
        for (int attempt = 0; attempt < 5 && !listens(); ++attempt) startProxy(location, readTimeout);
        ASSERT_TRUE(listens());
    }
    WebClient connect(const std::string& origin = kOrigin) {
        tunnels_.push_back(std::make_unique<TlsTunnel>(proxyPort_));
        return {tunnels_.back()->socket(), "viz.example", origin, kPrefix + "ws"};
    }
    std::string fetch(const std::string& path) const {
        TlsTunnel tunnel(proxyPort_);
        RawSocket socket = tunnel.socket();
        socket.write("GET " + path + " HTTP/1.1\r\nHost: viz.example\r\nConnection: close\r\n\r\n");
        return socket.readAll(10s);
    }

  private:
    bool listens() const { return proxyPort_ != 0 && !RawSocket(proxyPort_).closed(); }
    void startProxy(const std::string& location, int readTimeout) {
        proxyPort_ = freePort();
        const std::string folder = instance.folder().path().string(), file = folder + "/nginx.conf";
        std::string temporary;
        for (const char* kind : {"client_body", "proxy", "fastcgi", "uwsgi", "scgi"})
            temporary += fmt::format("{0}_temp_path {1}/{0};\n", kind, folder);
        std::ofstream(file) << fmt::format(
            "daemon off; master_process off; pid {0}/nginx.pid; error_log {0}/nginx.log;\n"
            "events {{}}\nhttp {{\naccess_log off;\n{1}"
            "server {{\nlisten 127.0.0.1:{2} ssl; server_name viz.example;\n"
            "ssl_certificate {3}; ssl_certificate_key {4};\nproxy_read_timeout {5}s;\n{6}}}\n}}\n",
            folder, temporary, proxyPort_, pair_.certificate, pair_.key, readTimeout, location);
        proxy_ = ChildProcess(kNginx, {"-p", folder, "-c", file, "-e", folder + "/nginx.log"},
                              {.outputFile = folder + "/nginx.out"});
        eventually([&] { return listens(); }, 5s);
    }

    TlsPair pair_;
    ChildProcess proxy_;
    int proxyPort_ = 0;
    std::vector<std::unique_ptr<TlsTunnel>> tunnels_;
};

/// The files that a page or a module names, relative to it.
std::vector<std::string> namedIn(const std::string& text) {
    static const std::regex named(
        R"re((?:(?:src|href)="|(?:from|import) ?"|import\(")(\.{0,2}/?[\w./-]+\.(?:js|css|svg))")re");
    std::vector<std::string> names;
    for (std::sregex_iterator each(text.begin(), text.end(), named), end; each != end; ++each)
        names.push_back((*each)[1].str());
    return names;
}

TEST_F(Nginx, ServesThePageAndItsModulesBelowItsPath) {
    start(60);
    std::vector<std::string> waiting{kPrefix};
    std::set<std::string> seen;
    while (!waiting.empty()) {
        const std::string path = waiting.back();
        waiting.pop_back();
        if (!seen.insert(path).second) continue;
        const std::string answer = fetch(path);
        EXPECT_TRUE(answer.starts_with("HTTP/1.1 200")) << path << answer.substr(0, 200);
        EXPECT_NE(answer.find("Content-Security-Policy"), std::string::npos) << path;
        const std::filesystem::path folder = std::filesystem::path(path).parent_path();
        for (const std::string& name : namedIn(answer)) {
            EXPECT_FALSE(name.starts_with('/')) << path << " names " << name;
            waiting.push_back((folder / name).lexically_normal().string());
        }
    }
    for (const char* file : {"page.css", "icon.svg", "js/main.js"})
        EXPECT_TRUE(seen.contains(kPrefix + file)) << file << testing::PrintToString(seen);
    EXPECT_TRUE(fetch(kPrefix + "health").starts_with("HTTP/1.1 200"));
}

TEST_F(Nginx, LetsOneWalk) {
    start(60);
    WebClient client = connect();
    ASSERT_EQ(client.status(), 101);
    client.hello(kDriver);
    EXPECT_EQ(client.event("welcome")["role"], "driver");
    server->move(30);
    for (int i = 0; i < 10; ++i) {
        client.input({'W'});
        const auto frame = client.binary(1);
        ASSERT_TRUE(frame) << i;
        client.acknowledge(*frame);
    }
    EXPECT_TRUE(eventually([&] { return server->isHeld('W'); }));
    client.input({});
    EXPECT_TRUE(eventually([&] { return !server->anyHeld(); }));
    EXPECT_EQ(client.request({{"do", "walk"}})["ok"], true);
    EXPECT_EQ(connect("https://evil.example").status(), 403);
    EXPECT_EQ(connect("http://viz.example").status(), 403);
}

TEST_F(Nginx, KeepsSilentPagesByTheirPings) {
    const int idle = asked("RT_BRIDGE_IDLE", 0);
    idle > 0 ? start(60) : start(2, {"--ping=1"});
    WebClient client = connect();
    client.hello(kDriver);
    const auto end = Clock::now() + std::chrono::seconds(idle > 0 ? idle : 5);
    while (Clock::now() < end)
        if (const auto frame = client.next(100ms); frame && frame->opcode == 2) client.acknowledge(*frame);
    EXPECT_FALSE(client.socket().closed());
    EXPECT_EQ(client.request({{"do", "walk"}})["ok"], true);
}

TEST_F(Nginx, CutsThemWithout) {
    start(2);
    WebClient client = connect();
    client.hello(kDriver);
    EXPECT_FALSE(client.event("welcome").is_null());
    EXPECT_EQ(client.closeCode(10s), 0) << "or the test before tells nothing";
}

} // namespace
