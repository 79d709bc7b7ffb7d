/// The errors of a preview's frame in its bytes (docs/protocol.md, "A preview").
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace app {

/// Steps for a doubling of the error, and the error in codes of 255 below which they get smaller: 3 % of the
/// error at most, up to 98 codes.
inline constexpr float kErrorSteps = 24, kSmallError = 1.0F / 16;

/// `error`: not below 0.
inline std::uint8_t errorByte(float error) {
    const float steps = kErrorSteps * std::log2(1 + error / kSmallError);
    return static_cast<std::uint8_t>(std::lround(std::min(steps, 255.0F)));
}

/// The error of that byte.
inline float errorOfByte(std::uint8_t byte) {
    return kSmallError * (std::exp2(static_cast<float>(byte) / kErrorSteps) - 1);
}

/// Errors of a whole image in ipc::FrameInfo, which has no fractions.
inline std::uint32_t thousandths(float error) {
    constexpr float kMaxError = 1e6F;
    return static_cast<std::uint32_t>(std::lround(1000 * std::min(error, kMaxError)));
}
inline float errorOfThousandths(std::uint32_t number) { return static_cast<float>(number) / 1000; }

} // namespace app
