/// SHA-256 (FIPS 180-4), by which a file is known to be the expected one.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace rtcore {

/// 64 digits, in lower case. Nothing where this build has no OpenSSL, which computes it. Safe from many
/// threads.
std::optional<std::string> sha256(std::span<const std::byte> bytes);

} // namespace rtcore
