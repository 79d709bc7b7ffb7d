/// TLS for tests, by openssl(1): a certificate, and a connection.
#pragma once

#include "process/bridge/web_client.h"
#include "support/child_process.h"
#include "support/run_program.h"

#include <sys/socket.h>

#include <array>
#include <filesystem>
#include <string>

namespace test {

inline constexpr const char* kOpenssl = "/usr/bin/openssl";

struct TlsPair {
    std::string certificate, key; ///< files; empty: there is no openssl
};

/// A self-signed certificate in this folder, for a name such as "DNS:localhost".
inline TlsPair makeCertificate(const std::filesystem::path& folder,
                               const std::string& name = "DNS:localhost") {
    const TlsPair made{(folder / "cert.pem").string(), (folder / "key.pem").string()};
    if (!std::filesystem::exists(kOpenssl)) return {};
    const ProgramResult result =
        runProgram(kOpenssl, {"req", "-x509", "-newkey", "rsa:2048", "-nodes", "-keyout", made.key, "-out",
                              made.certificate, "-days", "2", "-subj", "/CN=localhost", "-addext",
                              "subjectAltName=" + name});
    return result.exitCode == 0 ? made : TlsPair{};
}

/// A connection to a port of 127.0.0.1; what goes through the socket is plain.
class TlsTunnel {
  public:
    explicit TlsTunnel(int port) {
        std::array<int, 2> ends{};
        if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return;
        mine_ = ends[0];
        process_ = ChildProcess([port, theirs = ends[1]] {
            ::dup2(theirs, 0);
            ::dup2(theirs, 1);
            ::dup2(::open("/dev/null", O_WRONLY | O_CLOEXEC), 2);
            const std::string address = "127.0.0.1:" + std::to_string(port);
            ::execl(kOpenssl, kOpenssl, "s_client", "-quiet", "-connect", address.c_str(),
                    static_cast<char*>(nullptr));
        });
        ::close(ends[1]);
    }
    /// Once. The tunnel must outlive it.
    RawSocket socket() { return RawSocket::ofDescriptor(std::exchange(mine_, -1)); }

  private:
    int mine_ = -1;
    ChildProcess process_;
};

} // namespace test
