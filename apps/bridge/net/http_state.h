/// State that the connections of one HttpServer share. For its sources alone.
#pragma once

#include "bridge/net/http_server.h"

#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/io_context.hpp>

#include <memory>
#include <string>
#include <vector>

namespace bridge {

using StreamSocket = boost::asio::generic::stream_protocol::socket;

/// A connection that is no session yet.
class Pending {
  public:
    virtual ~Pending() = default;
    virtual void drop() = 0;
    virtual const std::string& address() const = 0;
};

/// Those there are, as they came; where there are too many one makes room for the next.
class Waiting {
  public:
    void add(std::weak_ptr<Pending> connection) {
        if (connections_.size() >= kMax) makeRoom();
        connections_.push_back(std::move(connection));
    }
    void remove(const Pending* connection) {
        std::erase_if(connections_,
                      [&](const auto& each) { return each.expired() || each.lock().get() == connection; });
    }

  private:
    static constexpr std::size_t kMax = 256;
    void makeRoom() {
        std::vector<std::string> addresses;
        std::erase_if(connections_, [](const auto& each) { return each.expired(); });
        for (const auto& each : connections_) addresses.push_back(each.lock()->address());
        if (addresses.empty()) return;
        const auto worst = connections_.begin() + static_cast<std::ptrdiff_t>(leastWelcome(addresses));
        const auto dropped = worst->lock();
        connections_.erase(worst);
        dropped->drop();
    }
    std::vector<std::weak_ptr<Pending>> connections_;
};

/// Lives as long as the HttpServer, whose io_context is destroyed first of all.
struct HttpShared {
    Names names;
    HttpHandlers handlers;
    Waiting waiting;
};

/// Serves one connection; in a source of its own for each kind of stream.
void servePlain(StreamSocket socket, const std::string& address, HttpShared& shared);

/// TLS: nothing without OpenSSL.
class TlsDoor {
  public:
    virtual ~TlsDoor() = default;
    virtual void serve(StreamSocket socket, const std::string& address, HttpShared& shared) = 0;
};
/// Throws rtcore::FileError.
std::unique_ptr<TlsDoor> openTlsDoor(const TlsFiles& files);

} // namespace bridge
