/// The description of a frame beside its pixels.
#pragma once

#include <cstdint>
#include <type_traits>

namespace ipc {

enum class PixelFormat : std::uint32_t {
    Rgba8 = 1, ///< four bytes a pixel, sRGB, rows from top to bottom without gaps
    Rgb8Error8 =
        2, ///< the same, but the fourth byte is the error of the pixel; docs/protocol.md, "A preview"
};

struct FrameInfo {
    std::uint64_t number = 0; ///< counts up from 1 while the server lives; the library sets it
    std::uint64_t run = 0;    ///< which run of a program drew it; a viewer may ignore other runs
    std::uint32_t width = 0;  ///< pixels
    std::uint32_t height = 0;
    PixelFormat format = PixelFormat::Rgba8;
    std::uint32_t samples = 1;      ///< per pixel; 0: several pixels share one
    std::int64_t nanoseconds = 0;   ///< of the steady clock when it was published; the library sets it
    std::uint64_t tag = 0;          ///< a number of the server's own; a preview's: see kPreviewDone
    std::uint32_t error = 0;        ///< of Rgb8Error8: of the whole image, in thousandths of a code of 255
    std::uint32_t largestError = 0; ///< the same where it is largest
    friend bool operator==(const FrameInfo&, const FrameInfo&) = default;
};
static_assert(std::is_trivially_copyable_v<FrameInfo> && sizeof(FrameInfo) == 56 && alignof(FrameInfo) == 8);

/// The tag of a preview's last frame. Those before it have a smaller one, which tells how far the work is.
inline constexpr std::uint64_t kPreviewDone = 1'000'000;

} // namespace ipc
