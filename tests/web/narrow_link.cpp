#include "web/narrow_link.h"

#include <array>
#include <chrono>
#include <deque>
#include <list>
#include <stdexcept>
#include <string>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace test {

namespace {

constexpr std::size_t kMemory = 64'000; ///< bytes that wait in a router, beside those that travel
constexpr std::size_t kPacket = 1400;
constexpr int kSocketMemory = 16'384; ///< the system's own must not be a second, larger router

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

sockaddr_in loopback(int port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    return address;
}

int makeSocket() {
    const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    ::setsockopt(socket, SOL_SOCKET, SO_RCVBUF, &kSocketMemory, sizeof kSocketMemory);
    ::setsockopt(socket, SOL_SOCKET, SO_SNDBUF, &kSocketMemory, sizeof kSocketMemory);
    return socket;
}

/// The port that the system chose.
int bindAnywhere(int socket) {
    sockaddr_in address = loopback(0);
    socklen_t size = sizeof address;
    auto* const any = reinterpret_cast<sockaddr*>(&address);
    if (::bind(socket, any, size) != 0 || ::getsockname(socket, any, &size) != 0)
        throw std::runtime_error("no port for a narrow link");
    return ntohs(address.sin_port);
}

/// One way of all connections together.
struct Way {
    double freeAt = 0;
    std::size_t held = 0;
};

/// One way of one connection.
struct Stream {
    int from, to;
    struct Packet {
        double due;
        std::string bytes;
    };
    std::deque<Packet> packets = {};
    bool ended = false, shut = false;

    void take(Way& way, double rate, double delay) {
        std::array<char, kPacket> bytes{};
        const ssize_t count = ::recv(from, bytes.data(), bytes.size(), MSG_DONTWAIT);
        if (count == 0 || (count < 0 && errno != EAGAIN)) ended = true;
        if (count <= 0) return;
        way.freeAt = std::max(way.freeAt, now()) + static_cast<double>(count) / rate;
        way.held += static_cast<std::size_t>(count);
        packets.push_back({way.freeAt + delay, std::string(bytes.data(), static_cast<std::size_t>(count))});
    }
    void give(Way& way) {
        while (!packets.empty() && packets.front().due <= now()) {
            std::string& bytes = packets.front().bytes;
            const ssize_t count = ::send(to, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
            if (count < 0 && errno == EAGAIN) return;
            const std::size_t gone = count < 0 ? bytes.size() : static_cast<std::size_t>(count);
            way.held -= gone;
            bytes.erase(0, gone);
            if (bytes.empty()) packets.pop_front();
        }
        if (ended && packets.empty() && !shut) {
            ::shutdown(to, SHUT_WR);
            shut = true;
        }
    }
};

struct Connection {
    Connection(int client, int server) : there{client, server}, back{server, client} {}
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;
    Stream there, back;
    bool over() const { return there.shut && back.shut; }
    ~Connection() {
        ::close(there.from);
        ::close(there.to);
    }
};

} // namespace

NarrowLink::NarrowLink(double bytesPerSecond, double roundTripSeconds)
    : rate_(bytesPerSecond), delay_(roundTripSeconds / 2), listener_(makeSocket()) {
    const int other = makeSocket();
    port_ = bindAnywhere(listener_);
    target_ = bindAnywhere(other);
    ::close(other);
    ::listen(listener_, 32);
    thread_ = std::thread([this] { run(); });
}

NarrowLink::~NarrowLink() {
    stopping_ = true;
    thread_.join();
    ::close(listener_);
}

void NarrowLink::run() {
    std::list<Connection> connections;
    Way there, back;
    const std::size_t max = kMemory + static_cast<std::size_t>(rate_ * delay_);
    while (!stopping_) {
        pollfd waiting{listener_, POLLIN, 0};
        if (::poll(&waiting, 1, 1) > 0) {
            const int client = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC), server = makeSocket();
            const sockaddr_in address = loopback(target_);
            ::connect(server, reinterpret_cast<const sockaddr*>(&address), sizeof address);
            connections.emplace_back(client, server);
        }
        if (cut_) {
            connections.clear();
            there = back = {};
        }
        for (Connection& one : connections)
            for (const auto& [stream, way] : {std::pair(&one.there, &there), std::pair(&one.back, &back)}) {
                stream->give(*way);
                for (std::size_t before = 1; before != way->held && way->held < max && !stream->ended;) {
                    before = way->held;
                    stream->take(*way, rate_, delay_);
                }
            }
        connections.remove_if([](const Connection& one) { return one.over(); });
    }
}

} // namespace test
