/// A network of this process's own, so that others have addresses that are not the loopback's.
#pragma once

#include <cstring>
#include <string>

#include <arpa/inet.h>
#include <fcntl.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

namespace test {

/// A network namespace of this thread, and of processes and threads that it starts; until the destructor.
class OwnNetwork {
  public:
    /// `address`: besides 127.0.0.1.
    explicit OwnNetwork(const std::string& address)
        : before_(::open("/proc/thread-self/ns/net", O_RDONLY | O_CLOEXEC)) {
        made_ = before_ >= 0 && ::unshare(CLONE_NEWNET) == 0;
        works_ = made_ && bring("lo", "127.0.0.1") && bring("lo:1", address);
    }
    ~OwnNetwork() {
        if (made_) ::setns(before_, CLONE_NEWNET);
        if (before_ >= 0) ::close(before_);
    }
    OwnNetwork(const OwnNetwork&) = delete;
    OwnNetwork& operator=(const OwnNetwork&) = delete;

    /// False: this process may not make one.
    bool works() const { return works_; }

  private:
    static bool bring(const char* name, const std::string& address) {
        const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
        ifreq request{};
        std::strncpy(request.ifr_name, name, IFNAMSIZ - 1);
        sockaddr_in where{};
        where.sin_family = AF_INET;
        ::inet_pton(AF_INET, address.c_str(), &where.sin_addr);
        std::memcpy(&request.ifr_addr, &where, sizeof where);
        bool done = ::ioctl(socket, SIOCSIFADDR, &request) == 0;
        request.ifr_flags = IFF_UP | IFF_RUNNING;
        done = done && ::ioctl(socket, SIOCSIFFLAGS, &request) == 0;
        ::close(socket);
        return done;
    }

    int before_;
    bool made_ = false, works_ = false;
};

/// A TCP connection to a numeric address; -1: there is none.
inline int connectTo(const std::string& address, int port) {
    const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in where{};
    where.sin_family = AF_INET;
    where.sin_port = htons(static_cast<std::uint16_t>(port));
    ::inet_pton(AF_INET, address.c_str(), &where.sin_addr);
    if (::connect(socket, reinterpret_cast<const sockaddr*>(&where), sizeof where) == 0) return socket;
    ::close(socket);
    return -1;
}

} // namespace test
