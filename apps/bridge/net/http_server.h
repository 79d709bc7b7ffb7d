/// HTTP and WebSockets, on one thread. Functions connect it to the rest; it knows no server and no frames.
#pragma once

#include "bridge/net/doorkeeper.h"
#include "bridge/net/outlet.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace bridge {

/// Where it listens.
struct ListenAddress {
    std::string host; ///< a numeric address; "" with a socket
    std::uint16_t port = 0;
    std::string socketPath; ///< of a Unix socket; "" = none
    int ports = 1;          ///< tries so many, from `port` on
};

struct TlsFiles {
    std::string certificate, key; ///< PEM; both empty: no TLS
};

struct HttpAnswer {
    int status = 404;
    std::string type = "text/plain; charset=utf-8", body = "not found\n";
};

struct HttpHandlers {
    /// A WebSocket is open. The receiver lives until it is told closed().
    std::function<std::shared_ptr<Receiver>(const std::shared_ptr<Outlet>&)> opened;
    /// For paths that are no files of the page. `bearer`: of `Authorization`, or "".
    std::function<HttpAnswer(std::string_view path, std::string_view bearer, const std::string& address)>
        answer;
    std::function<bool()> enters; ///< whether there is a place for another WebSocket; else 503
    std::function<void(const char* reason, const std::string& address)> refused; ///< counted, noted
};

/// Throws rtcore::FileError (TryAgain when the address is taken; NoInput and BadData for the files of TLS).
class HttpServer {
  public:
    HttpServer(const ListenAddress& address, Names names, const TlsFiles& tls, HttpHandlers handlers);
    ~HttpServer();
    HttpServer(const HttpServer&) = delete;
    HttpServer& operator=(const HttpServer&) = delete;

    std::uint16_t port() const;
    /// More names to answer to; before run().
    void addHosts(const std::vector<std::string>& hosts);
    /// Until stop().
    void run();
    /// The rest from any thread.
    void stop();
    void post(std::function<void()> work);
    /// Calls `work` again and again; before run().
    void every(double seconds, std::function<void()> work);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace bridge
