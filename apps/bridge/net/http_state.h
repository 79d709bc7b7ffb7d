/// What the connections of one HttpServer share. For its sources alone.
#pragma once

#include "bridge/net/http_server.h"

#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/io_context.hpp>

#include <list>
#include <memory>

namespace bridge {

using StreamSocket = boost::asio::generic::stream_protocol::socket;

/// A connection that is no session yet: the oldest ones make room for new ones.
class Pending {
  public:
    virtual ~Pending() = default;
    virtual void drop() = 0;
};

class Waiting {
  public:
    void add(std::weak_ptr<Pending> connection) {
        std::erase_if(connections_, [](const auto& each) { return each.expired(); });
        connections_.push_back(std::move(connection));
        while (connections_.size() > kMost) {
            if (const auto oldest = connections_.front().lock()) oldest->drop();
            connections_.pop_front();
        }
    }
    void remove(const Pending* connection) {
        std::erase_if(connections_,
                      [&](const auto& each) { return each.expired() || each.lock().get() == connection; });
    }

  private:
    static constexpr std::size_t kMost = 256;
    std::list<std::weak_ptr<Pending>> connections_;
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
