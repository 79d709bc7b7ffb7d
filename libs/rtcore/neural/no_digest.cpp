// In place of digest.cpp in a build without OpenSSL.
#include "rtcore/neural/digest.h"

namespace rtcore {

std::optional<std::string> sha256(std::span<const std::byte>) { return std::nullopt; }

} // namespace rtcore
