#include "bridge/bridge_run.h"

#include "bridge/bridge_options.h"
#include "bridge/hub.h"
#include "bridge/net/own_certificate.h"
#include "bridge/report/journal.h"
#include "bridge/server_start.h"

#include "common/process/message.h"
#include "common/process/parent.h"
#include "common/process/private_files.h"
#include "common/process/secrets.h"
#include "common/process/stop.h"
#include "common/process/terminal.h"
#include "common/process/threads.h"

#include "rtcore/platform/error.h"

#include <fmt/core.h>

#include <cstdlib>
#include <utility>

namespace bridge {

namespace {

std::string socketPathFor(const std::string& instance) {
    constexpr std::size_t kMaxPath = 107;
    std::string path = app::privateRuntimeFolder("rts") + "/" + instance + ".web";
    if (path.size() > kMaxPath)
        throw rtcore::FileError(rtcore::FailureKind::CannotWrite, path,
                                "the path of the socket is too long; set XDG_RUNTIME_DIR to a shorter one");
    return path;
}

bool isEverywhere(const std::string& host) { return host == "0.0.0.0" || host == "::"; }

std::string hostWithPort(const std::string& host, std::uint16_t port) {
    return host.find(':') == std::string::npos ? fmt::format("{}:{}", host, port)
                                               : fmt::format("[{}]:{}", host, port);
}

std::string stateFolder() {
    const char* const state = std::getenv("XDG_STATE_HOME"); // NOLINT(concurrency-mt-unsafe)
    if (state != nullptr && *state == '/') return std::string(state) + "/rts";
    const char* const home = std::getenv("HOME"); // NOLINT(concurrency-mt-unsafe)
    if (home != nullptr && *home == '/') return std::string(home) + "/.local/state/rts";
    throw rtcore::FileError(rtcore::FailureKind::CannotWrite, "HOME",
                            "is not set; set it, or XDG_STATE_HOME, for the certificate of --tls-own");
}

/// The names that a certificate for that address has to list.
std::vector<std::string> namesOf(const ListenAddress& address) {
    if (isEverywhere(address.host)) return {app::hostName()};
    return {address.host};
}

constexpr std::uint16_t kHttpPort = 80, kHttpsPort = 443; // which browsers leave out

/// Names by which other machines may call this one.
std::vector<std::string> hostsOf(const ListenAddress& address, std::uint16_t port, bool tls) {
    if (!address.socketPath.empty()) return {};
    std::vector<std::string> names{address.host};
    if (isEverywhere(address.host)) names = {app::hostName(), "*"};
    std::vector<std::string> hosts;
    for (const std::string& name : names) {
        const std::string whole = hostWithPort(name, port);
        hosts.push_back(whole);
        if (port == (tls ? kHttpsPort : kHttpPort)) hosts.push_back(whole.substr(0, whole.rfind(':')));
    }
    return hosts;
}

std::string pageAddress(const BridgeOptions& options, std::uint16_t port) {
    if (options.origin) return options.origin->origin + options.origin->prefix + "/";
    const ListenAddress& listen = options.listen;
    if (!listen.socketPath.empty()) return "http://127.0.0.1:8931/";
    const std::string host = isEverywhere(listen.host) ? app::hostName() : listen.host;
    return std::string(options.names.tls ? "https://" : "http://") + hostWithPort(host, port) + "/";
}

std::string driverLine(const BridgeOptions& options, const std::string& token, std::uint16_t port) {
    return fmt::format("Driver: {}#t={}\n", pageAddress(options, port), token);
}

std::string linkLines(const BridgeOptions& options, const Tokens& tokens, std::uint16_t port) {
    std::string text;
    if (!options.listen.socketPath.empty())
        text += fmt::format("Tunnel: ssh -L 8931:{} {}\n", options.listen.socketPath, app::hostName());
    if (!tokens.driver.empty()) text += driverLine(options, tokens.driver, port);
    text += fmt::format("Viewer: {}#t={}\n", pageAddress(options, port), tokens.viewer);
    if (!tokens.driver.empty() && !tokens.lasting)
        text += "The driver's link is good once; the next one follows here.\n";
    return text;
}

/// One run, with all that lives as long.
class Serving {
  public:
    explicit Serving(const app::Arguments& arguments)
        : options_(readBridgeOptions(arguments)), tokens_(openTokens(options_.tokenFile, options_.viewOnly)) {
        if (!options_.listen.socketPath.empty())
            options_.listen.socketPath = socketPathFor(options_.instances.front());
        if (options_.origin) {
            options_.names.origins = {options_.origin->origin};
            options_.names.proxyHost = options_.origin->host;
            options_.names.prefix = options_.origin->prefix;
        }
        if (options_.parent) app::stopWithParent(*options_.parent);
        if (options_.ownCertificate) {
            own_ = ownCertificate(stateFolder(), namesOf(options_.listen));
            options_.tls = {own_.file, own_.file};
        }
        if (options_.start) started_ = startServer(*options_.start, options_.instances.front());
        server_ = std::make_unique<HttpServer>(options_.listen, options_.names, options_.tls, handlers());
        server_->addHosts(hostsOf(options_.listen, server_->port(), options_.names.tls));
        hub_ = std::make_unique<Hub>(
            options_, tokens_,
            realServices([this](std::function<void()> work) { server_->post(std::move(work)); },
                         [this](const std::string& line) { journal_.note(line); }, options_.byPaths),
            [this](const std::string& driver) { untold_ += driverLine(options_, driver, server_->port()); });
    }
    ~Serving() {
        // The rooms' threads post to the server, whose sockets tell the rooms.
        hub_.reset();
        server_.reset();
    }
    Serving(const Serving&) = delete;
    Serving& operator=(const Serving&) = delete;

    app::ExitCode run() {
        if (options_.ownCertificate)
            app::writeOutput("Certificate: SHA-256 " + own_.fingerprint +
                             "\nBrowsers do not know it: compare this with what they show, then go on.\n");
        app::writeOutput(linkLines(options_, tokens_, server_->port())); // programs read on from here
        server_->every(0.05, [this] { tick(); });
        if (options_.watch) server_->every(1, [this] { printWatch(); });
        server_->run();
        return code_;
    }

  private:
    HttpHandlers handlers() {
        return {.opened = [this](const std::shared_ptr<Outlet>& outlet) { return hub_->opened(outlet); },
                .answer = [this](std::string_view path, std::string_view bearer,
                                 const std::string& address) { return hub_->answer(path, bearer, address); },
                .enters = [this] { return hub_->enters(); },
                .refused = [this](const char* reason,
                                  const std::string& address) { hub_->refused(reason, address); }};
    }

    void tick() {
        if (app::takeRenewalRequest()) renew();
        hub_->tick();
        tellLinks();
        if (started_ && started_->ended() && !app::stopRequested()) {
            if (ending_ == 0) app::printMessage("RTBridge", "the server has ended");
            code_ = *started_->ended() == 0 ? app::ExitCode::Done
                                            : static_cast<app::ExitCode>(*started_->ended());
            return end();
        }
        if (app::stopRequested()) {
            code_ = app::stopExitCode();
            end();
        }
    }
    /// A terminal that is stopped loses lines; it must not stop the pages.
    void printWatch() {
        const std::string lines = hub_->watchLines();
        if (app::errorTakesMore()) app::writeError(lines);
    }
    void renew() {
        try {
            tokens_ = openTokens(options_.tokenFile, options_.viewOnly);
        } catch (const rtcore::FileError& error) {
            return app::printMessage("RTBridge", std::string(error.what()) + "; the links stay");
        }
        hub_->renew(tokens_);
        untold_ = linkLines(options_, tokens_, server_->port());
    }
    /// They wait for a reader that takes none just now; one that is gone ends nothing.
    void tellLinks() {
        if (untold_.empty() || !app::outputTakesMore()) return;
        try {
            app::writeOutput(std::exchange(untold_, {}));
        } catch (const rtcore::FileError& error) {
            app::printMessage("RTBridge", std::string(error.what()) + "; SIGUSR1 makes new links");
        }
    }
    /// Pages are told; a moment later it is over.
    void end() {
        constexpr int kTicks = 2;
        if (ending_ == 0) hub_->end();
        if (++ending_ > kTicks) server_->stop();
    }

    BridgeOptions options_;
    OwnCertificate own_; ///< of --tls-own
    Tokens tokens_;
    std::unique_ptr<app::StartedProcess> started_;
    Journal journal_;
    std::unique_ptr<HttpServer> server_;
    std::unique_ptr<Hub> hub_;
    app::ExitCode code_ = app::ExitCode::Done;
    std::string untold_; ///< links that are still to be printed
    int ending_ = 0;
};

} // namespace

app::ExitCode runBridge(const app::Arguments& arguments) {
    app::protectSecrets();
    app::installRenewalHandler();
    app::shareMemoryAmongThreads();
    return Serving(arguments).run();
}

} // namespace bridge
