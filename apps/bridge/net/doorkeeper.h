/// Who is let in: names of hosts and pages, tokens, and limits against floods. Pure.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace bridge {

/// The hosts and origins that a bridge answers to.
struct Names {
    /// "192.168.1.7:8443", in small letters, besides the loopback's; "*:8443": any numeric address, as DNS
    /// leads to none of them.
    std::vector<std::string> hosts;
    std::vector<std::string> origins; ///< "https://viz.example": of --origin, exactly
    std::string proxyHost;            ///< "viz.example", that of --origin: its pages have its `origins` only
    std::string prefix;               ///< "/node7/8931" of --origin; "" without one
    bool tls = false;
    bool allowNoOrigin = false;
};

/// Whether the `Host` of a request is ours: one of `hosts`, or a name of the loopback with any port, as a
/// tunnel chooses one. Other names lead to us only by DNS rebinding.
bool isOurHost(const Names& names, std::string_view host);
/// Whether the `Origin` of a WebSocket is a page of ours: of the very host that the request names, or of
/// --origin.
bool isOurOrigin(const Names& names, std::string_view host, std::optional<std::string_view> origin);

/// "https://viz.example/node7" taken apart. Throws app::UsageError.
struct OriginOption {
    std::string origin, host, prefix;
};
OriginOption parseOrigin(const std::string& text);

/// Refills by `rate` a second up to `burst`. Seconds of any clock.
class TokenBucket {
  public:
    TokenBucket(double rate, double burst) : rate_(rate), burst_(burst), level_(burst) {}
    bool take(double now, double amount = 1) {
        if (!has(now, amount)) return false;
        level_ -= amount;
        return true;
    }
    /// Whether take() would take it.
    bool has(double now, double amount = 1) {
        if (last_ >= 0) level_ = std::min(burst_, level_ + rate_ * (now - last_));
        last_ = now;
        return level_ >= amount;
    }
    /// It was taken for nothing.
    void giveBack(double amount = 1) { level_ = std::min(burst_, level_ + amount); }

  private:
    double rate_, burst_, level_, last_ = -1;
};

/// Whose place is given to the next one, where all are taken: the first of the address that has most of them.
/// `addresses`: of those that have shown no token, as they came; at least one. So an address that opens
/// connections without end, be it a proxy's or a NAT's, pushes out its own ones only.
std::size_t leastWelcome(std::span<const std::string> addresses);

/// 32 bytes of the system's, as base64url: 43 characters.
std::string newToken();
/// In a time that does not tell how much of it is right.
bool sameToken(std::string_view given, std::string_view token);

} // namespace bridge
