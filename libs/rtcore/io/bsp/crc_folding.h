/// CRC-32 of long lists of bytes by multiplication without carries.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace rtcore {

/// The CRC-32 of a multiple of 64 bytes, at least 64, that follow others whose CRC is `before`:
/// faster than by zlib where the processor has the instruction, which x86 has since 2010; elsewhere by
/// zlib. Source: Gopal et al., Fast CRC computation for generic polynomials using PCLMULQDQ, Intel 2009.
std::uint32_t foldedCrc(std::span<const std::byte> bytes, std::uint32_t before);

} // namespace rtcore
