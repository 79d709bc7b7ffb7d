#include "bridge/bridge_run.h"

#include "bridge/bridge_options.h"
#include "bridge/hub.h"
#include "bridge/server_start.h"

#include "common/process/message.h"
#include "common/process/stop.h"
#include "common/process/terminal.h"
#include "common/process/threads.h"

#include "rtcore/platform/error.h"

#include <fmt/core.h>

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>

namespace bridge {

namespace {

volatile std::sig_atomic_t renewRequested = 0;

/// Frames and tokens are in memory: no core files, and nothing is run with more rights.
void protectProcess() {
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    std::signal(SIGUSR1, [](int) { renewRequested = 1; });
}

/// A folder of this user alone.
std::string socketFolder() {
    const char* const runtime = std::getenv("XDG_RUNTIME_DIR"); // NOLINT(concurrency-mt-unsafe)
    const std::string folder = runtime != nullptr && *runtime == '/' ? std::string(runtime) + "/rts" : fmt::format("/tmp/rts-{}", ::getuid());
    ::mkdir(folder.c_str(), 0700);
    struct stat facts {};
    if (::lstat(folder.c_str(), &facts) != 0 || !S_ISDIR(facts.st_mode) || facts.st_uid != ::getuid() || (facts.st_mode & 077U) != 0)
        throw rtcore::FileError(rtcore::FailureKind::CannotWrite, folder, "this is no folder that only its owner can open; remove it");
    return folder;
}

std::string socketPathFor(const std::string& instance) {
    constexpr std::size_t kMostPath = 107;
    std::string path = socketFolder() + "/" + instance + ".web";
    if (path.size() > kMostPath)
        throw rtcore::FileError(rtcore::FailureKind::CannotWrite, path, "the path of the socket is too long; set XDG_RUNTIME_DIR to a shorter one");
    return path;
}

std::string hostName() {
    constexpr std::size_t kMost = 256;
    std::array<char, kMost> name{};
    ::gethostname(name.data(), name.size() - 1);
    return name.data();
}

bool isEverywhere(const std::string& host) { return host == "0.0.0.0" || host == "::"; }

std::string hostWithPort(const std::string& host, std::uint16_t port) {
    return host.find(':') == std::string::npos ? fmt::format("{}:{}", host, port) : fmt::format("[{}]:{}", host, port);
}

/// Names by which other machines may call this one.
std::vector<std::string> hostsOf(const ListenAddress& address, std::uint16_t port) {
    if (!address.socketPath.empty()) return {};
    std::vector<std::string> hosts{hostWithPort(address.host, port)};
    if (isEverywhere(address.host)) hosts = {hostWithPort(hostName(), port)};
    return hosts;
}

std::string pageAddress(const BridgeOptions& options, std::uint16_t port) {
    if (options.origin) return options.origin->origin + options.origin->prefix + "/";
    const ListenAddress& listen = options.listen;
    if (!listen.socketPath.empty()) return "http://127.0.0.1:8931/";
    const std::string host = isEverywhere(listen.host) ? hostName() : listen.host;
    return std::string(options.names.tls ? "https://" : "http://") + hostWithPort(host, port) + "/";
}

void printLinks(const BridgeOptions& options, const Tokens& tokens, std::uint16_t port) {
    const std::string page = pageAddress(options, port);
    std::string text;
    if (!options.listen.socketPath.empty())
        text += fmt::format("Tunnel: ssh -L 8931:{} {}\n", options.listen.socketPath, hostName());
    if (!tokens.driver.empty()) text += fmt::format("Driver: {}#t={}\n", page, tokens.driver);
    text += fmt::format("Viewer: {}#t={}\n", page, tokens.viewer);
    app::writeOutput(text);
}

/// One run, with all that lives as long.
class Serving {
  public:
    explicit Serving(const app::Arguments& arguments)
        : options_(readBridgeOptions(arguments)), tokens_(openTokens(options_.tokenFile, options_.viewOnly)) {
        if (!options_.listen.socketPath.empty()) options_.listen.socketPath = socketPathFor(options_.instances.front());
        if (options_.origin) {
            options_.names.origins = {options_.origin->origin};
            options_.names.prefix = options_.origin->prefix;
        }
        if (options_.start) started_.emplace(*options_.start, options_.instances.front());
        server_ = std::make_unique<HttpServer>(options_.listen, options_.names, options_.tls, handlers());
        server_->addHosts(hostsOf(options_.listen, server_->port()));
        if (options_.origin) server_->addHosts({options_.origin->host});
        hub_ = std::make_unique<Hub>(options_, tokens_, [this](std::function<void()> work) { server_->post(std::move(work)); });
    }
    ~Serving() {
        // The rooms' threads post to the server, whose sockets tell the rooms.
        hub_.reset();
        server_.reset();
    }
    Serving(const Serving&) = delete;
    Serving& operator=(const Serving&) = delete;

    app::ExitCode run() {
        printLinks(options_, tokens_, server_->port());
        server_->every(0.05, [this] { tick(); });
        server_->run();
        return code_;
    }

  private:
    HttpHandlers handlers() {
        return {.opened = [this](const std::shared_ptr<Outlet>& outlet) { return hub_->opened(outlet); },
                .answer = [this](std::string_view path, std::string_view bearer) { return hub_->answer(path, bearer); },
                .shutOut = [this](const std::string& address) { return hub_->shutOut(address); },
                .full = [this] { return hub_->full(); },
                .refused = [this](const char* reason) { hub_->refused(reason); }};
    }

    void tick() {
        if (renewRequested != 0) renew();
        hub_->tick();
        if (started_ && started_->ended() && !app::stopRequested()) {
            app::printMessage("RTBridge", "the server has ended");
            code_ = *started_->ended() == 0 ? app::ExitCode::Done : static_cast<app::ExitCode>(*started_->ended());
            return end();
        }
        if (app::stopRequested()) {
            code_ = app::stopExitCode();
            end();
        }
    }
    void renew() {
        renewRequested = 0;
        if (options_.tokenFile) return app::printMessage("RTBridge", "the tokens are those of --token-file; change them there");
        tokens_ = openTokens({}, options_.viewOnly);
        hub_->renew(tokens_);
        printLinks(options_, tokens_, server_->port());
    }
    /// Pages are told; a moment later it is over.
    void end() {
        constexpr int kTicks = 2;
        if (ending_ == 0) hub_->end();
        if (++ending_ > kTicks) server_->stop();
    }

    BridgeOptions options_;
    Tokens tokens_;
    std::optional<StartedServer> started_;
    std::unique_ptr<HttpServer> server_;
    std::unique_ptr<Hub> hub_;
    app::ExitCode code_ = app::ExitCode::Done;
    int ending_ = 0;
};

} // namespace

app::ExitCode runBridge(const app::Arguments& arguments) {
    protectProcess();
    app::shareMemoryAmongThreads();
    return Serving(arguments).run();
}

} // namespace bridge
