#include "bridge/net/http_server.h"

#include "bridge/net/http_connection-inl.h"

#include "common/cli/command_line.h"

#include "rtcore/platform/error.h"

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <fmt/core.h>

#include <filesystem>
#include <list>

namespace bridge {

namespace {

using Tcp = asio::ip::tcp;
using Local = asio::local::stream_protocol;

[[noreturn]] void refuseAddress(const std::string& where, const ErrorCode& error) {
    throw rtcore::FileError(rtcore::FailureKind::TryAgain, where, "cannot listen there: " + error.message());
}

Tcp::acceptor listenTcp(asio::io_context& context, const ListenAddress& address) {
    ErrorCode error;
    const auto host = asio::ip::make_address(address.host, error);
    if (error)
        throw app::UsageError(
            "option '--listen' takes an address such as 192.168.1.7, 0.0.0.0 or ::1, not '" + address.host +
            "'");
    for (int i = 0; i < address.ports; ++i) {
        Tcp::acceptor acceptor(context);
        const Tcp::endpoint endpoint(host, static_cast<std::uint16_t>(address.port + i));
        acceptor.open(endpoint.protocol(), error);
        if (!error) acceptor.set_option(Tcp::acceptor::reuse_address(true), error);
        if (!error) acceptor.bind(endpoint, error);
        if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
        if (!error) return acceptor;
        if (error != asio::error::address_in_use) break;
    }
    refuseAddress(fmt::format("{}:{}", address.host, address.port), error);
}

/// In a folder of this user alone; one that a dead bridge left is replaced.
Local::acceptor listenLocal(asio::io_context& context, const std::string& path) {
    ErrorCode error;
    Local::socket probe(context, Local());
    probe.native_non_blocking(true,
                              error); // one that is stopped, with all its places taken, would not answer
    probe.connect(Local::endpoint(path), error);
    if (!error) refuseAddress(path, asio::error::make_error_code(asio::error::address_in_use));
    namespace fs = std::filesystem;
    std::error_code ignored;
    if (fs::is_socket(fs::symlink_status(path, ignored))) fs::remove(path, ignored);
    Local::acceptor acceptor(context);
    acceptor.open(Local(), error);
    if (!error) acceptor.bind(Local::endpoint(path), error);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    if (error) refuseAddress(path, error);
    fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
    return acceptor;
}

/// Frames that wait in the kernel are old when they arrive.
void tune(Tcp::socket& socket) {
    ErrorCode ignored;
    socket.set_option(Tcp::no_delay(true), ignored);
    socket.set_option(asio::detail::socket_option::integer<IPPROTO_TCP, TCP_NOTSENT_LOWAT>(65536), ignored);
}
void tune(Local::socket&) {}

std::string nameOf(const Tcp::socket& socket) {
    ErrorCode error;
    const auto endpoint = socket.remote_endpoint(error);
    if (error) return "unknown";
    const asio::ip::address address = endpoint.address();
    return address.is_v6() && address.to_v6().is_v4_mapped()
               ? asio::ip::make_address_v4(asio::ip::v4_mapped, address.to_v6()).to_string()
               : address.to_string();
}
std::string nameOf(const Local::socket&) { return "unix"; }

} // namespace

const char* typeOfPath(std::string_view path) {
    struct Row {
        std::string_view ending;
        const char* type;
    };
    constexpr Row kTypes[] = {{".html", "text/html; charset=utf-8"},
                              {".css", "text/css; charset=utf-8"},
                              {".js", "text/javascript; charset=utf-8"},
                              {".mjs", "text/javascript; charset=utf-8"},
                              {".svg", "image/svg+xml"},
                              {".png", "image/png"},
                              {".ico", "image/x-icon"},
                              {".json", "application/json"},
                              {".webmanifest", "application/manifest+json"}};
    for (const Row& row : kTypes)
        if (path.ends_with(row.ending)) return row.type;
    return "application/octet-stream";
}

void servePlain(StreamSocket socket, const std::string& address, HttpShared& shared) {
    std::make_shared<HttpConnection<CountedSocket>>(counted(std::move(socket)), address, shared)->start();
}

struct HttpServer::State {
    State(const ListenAddress& address, Names names, const TlsFiles& files, HttpHandlers handlers)
        : shared{std::move(names), std::move(handlers), {}}, socketPath(address.socketPath) {
        if (!files.certificate.empty()) tls = openTlsDoor(files);
        if (!socketPath.empty()) {
            local.emplace(listenLocal(context, socketPath));
            accept(*local);
        } else {
            tcp.emplace(listenTcp(context, address));
            port = tcp->local_endpoint().port();
            accept(*tcp);
        }
    }
    ~State() {
        std::error_code ignored;
        if (!socketPath.empty()) std::filesystem::remove(socketPath, ignored);
    }

    template <typename Acceptor>
    void accept(Acceptor& acceptor) {
        acceptor.async_accept([this, &acceptor](ErrorCode error, auto socket) {
            if (error == asio::error::operation_aborted) return;
            if (error) { // short of descriptors: some are free again soon
                pauseTimer.expires_after(100ms);
                return pauseTimer.async_wait([this, &acceptor](ErrorCode stopped) {
                    if (!stopped) accept(acceptor);
                });
            }
            const std::string address = nameOf(socket);
            tune(socket);
            try {
                tls ? tls->serve(std::move(socket), address, shared)
                    : servePlain(std::move(socket), address, shared);
            } catch (const std::exception&) { // that connection alone is lost
            }
            accept(acceptor);
        });
    }

    struct Repeated {
        asio::steady_timer timer;
        std::chrono::steady_clock::duration period;
        std::function<void()> work;
    };
    void repeat(Repeated& each) {
        each.timer.expires_after(each.period);
        each.timer.async_wait([this, &each](ErrorCode error) {
            if (error) return;
            each.work();
            repeat(each);
        });
    }

    HttpShared shared;
    std::unique_ptr<TlsDoor> tls;
    std::string socketPath;
    std::uint16_t port = 0;
    asio::io_context context{1}; // after what its handlers use
    std::optional<Tcp::acceptor> tcp;
    std::optional<Local::acceptor> local;
    asio::steady_timer pauseTimer{context};
    std::list<Repeated> repeated;
};

HttpServer::HttpServer(const ListenAddress& address, Names names, const TlsFiles& tls, HttpHandlers handlers)
    : state_(std::make_unique<State>(address, std::move(names), tls, std::move(handlers))) {}

HttpServer::~HttpServer() = default;

std::uint16_t HttpServer::port() const { return state_->port; }
void HttpServer::addHosts(const std::vector<std::string>& hosts) {
    std::vector<std::string>& all = state_->shared.names.hosts;
    for (std::string host : hosts) {
        for (char& c : host)
            if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
        all.push_back(std::move(host));
    }
}
void HttpServer::run() { state_->context.run(); }
void HttpServer::stop() { state_->context.stop(); }
void HttpServer::post(std::function<void()> work) { asio::post(state_->context, std::move(work)); }

void HttpServer::every(double seconds, std::function<void()> work) {
    const auto period = std::chrono::duration_cast<std::chrono::steady_clock::duration>(
        std::chrono::duration<double>(seconds));
    state_->repeated.push_back({asio::steady_timer(state_->context), period, std::move(work)});
    state_->repeat(state_->repeated.back());
}

} // namespace bridge
