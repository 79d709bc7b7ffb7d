#include "bridge/net/doorkeeper.h"

#include "common/cli/command_line.h"
#include "common/process/secrets.h"

#include <array>
#include <map>

namespace bridge {

namespace {

std::string lower(std::string_view text) {
    std::string small(text);
    for (char& c : small)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return small;
}

bool isPort(std::string_view text) {
    constexpr std::size_t kDigits = 5;
    return !text.empty() && text.size() <= kDigits &&
           text.find_first_not_of("0123456789") == std::string_view::npos;
}

bool isLoopback(std::string_view host) {
    for (const std::string_view name : {"127.0.0.1", "localhost", "[::1]"}) {
        if (!host.starts_with(name)) continue;
        const std::string_view rest = host.substr(name.size());
        if (rest.empty() || (rest.front() == ':' && isPort(rest.substr(1)))) return true;
    }
    return false;
}

/// "192.168.1.7:8443" or "[fe80::1]:8443" as "*:8443", without a port as "*"; "" for names.
std::string anyNumericHost(std::string_view host) {
    const std::size_t end = host.ends_with(']') ? host.size() : std::min(host.rfind(':'), host.size());
    const std::string_view address = host.substr(0, end);
    const bool isSix = address.size() > 2 && address.starts_with('[') && address.ends_with(']') &&
                       address.substr(1, address.size() - 2).find_first_not_of("0123456789abcdef:.") ==
                           std::string_view::npos;
    const bool isFour =
        !address.empty() && address.find_first_not_of("0123456789.") == std::string_view::npos;
    return isFour || isSix ? "*" + std::string(host.substr(end)) : "";
}

} // namespace

bool isOurHost(const Names& names, std::string_view host) {
    const std::string small = lower(host);
    return isLoopback(small) || (!small.empty() && small == names.proxyHost) ||
           std::ranges::find(names.hosts, small) != names.hosts.end() ||
           std::ranges::find(names.hosts, anyNumericHost(small)) != names.hosts.end();
}

bool isOurOrigin(const Names& names, std::string_view host, std::optional<std::string_view> origin) {
    if (!origin) return names.allowNoOrigin;
    const std::string small = lower(*origin);
    if (std::ranges::find(names.origins, small) != names.origins.end()) return true;
    if (!names.proxyHost.empty() && lower(host) == names.proxyHost) return false;
    return small == (names.tls ? "https://" : "http://") + lower(host);
}

OriginOption parseOrigin(const std::string& text) {
    const auto fail = [&] {
        return app::UsageError(
            "option '--origin' takes an address such as https://viz.example/node7/, not '" + text + "'");
    };
    const std::size_t scheme = text.find("://");
    if (scheme == std::string::npos) throw fail();
    const std::string protocol = lower(text.substr(0, scheme));
    if (protocol != "http" && protocol != "https") throw fail();
    const std::size_t start = scheme + 3, slash = std::min(text.find('/', start), text.size());
    OriginOption option;
    option.host = lower(text.substr(start, slash - start));
    if (option.host.empty() || option.host.find_first_of("@?# \\") != std::string::npos) throw fail();
    // As browsers write it.
    const std::string_view usual = protocol == "https" ? ":443" : ":80";
    if (option.host.ends_with(usual)) option.host.resize(option.host.size() - usual.size());
    option.origin = protocol + "://" + option.host;
    option.prefix = text.substr(slash);
    if (option.prefix.find_first_of("?#") != std::string::npos) throw fail();
    while (option.prefix.ends_with('/')) option.prefix.pop_back();
    return option;
}

std::size_t leastWelcome(std::span<const std::string> addresses) {
    std::map<std::string_view, std::size_t> counts;
    for (const std::string& each : addresses) ++counts[each];
    const auto busiest = std::ranges::max_element(
        addresses, {}, [&](const std::string& address) { return counts.at(address); });
    return static_cast<std::size_t>(busiest - addresses.begin());
}

std::string newToken() {
    constexpr std::size_t kBytes = 32;
    std::array<unsigned char, kBytes> bytes{};
    app::fillWithRandomBytes(bytes);
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
    std::string token;
    unsigned value = 0;
    int bits = 0;
    for (const unsigned char byte : bytes) {
        value = value << 8 | byte;
        for (bits += 8; bits >= 6; bits -= 6) token += kDigits[value >> (bits - 6) & 63U];
    }
    if (bits > 0) token += kDigits[value << (6 - bits) & 63U];
    return token;
}

bool sameToken(std::string_view given, std::string_view token) {
    unsigned char difference = given.size() == token.size() && !token.empty() ? 0 : 1;
    for (std::size_t i = 0; i < token.size(); ++i) {
        const char c = i < given.size() ? given[i] : '\0';
        difference = static_cast<unsigned char>(
            difference | (static_cast<unsigned char>(c) ^ static_cast<unsigned char>(token[i])));
    }
    return difference == 0;
}

} // namespace bridge
