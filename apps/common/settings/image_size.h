/// Sizes of images by their names.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace app {

struct ImageSize {
    int width = 0, height = 0; ///< pixels
    friend bool operator==(const ImageSize&, const ImageSize&) = default;
};

struct NamedSize {
    std::string_view name, title;
    ImageSize size;
};
/// Of screens.
inline constexpr std::array<NamedSize, 5> kScreenSizes{{{"hd", "HD", {1280, 720}},
                                                        {"fullhd", "Full HD", {1920, 1080}},
                                                        {"qhd", "QHD", {2560, 1440}},
                                                        {"4k", "4K", {3840, 2160}},
                                                        {"8k", "8K", {7680, 4320}}}};

/// Dots per inch of paper for which no others are said.
inline constexpr int kUsualDpi = 300;
inline constexpr int kMaxDpi = 2400;

/// "4k", "1200x800", or paper: "a4", lying, at kUsualDpi, "a4@150", "a3-upright@200". Capital letters do not
/// matter. Nothing: it is none of these, or has no pixel; that it may be too large is not looked at.
std::optional<ImageSize> imageSizeOf(std::string_view text);

/// "hd, fullhd, ... , a4, ..., 1920x1080", for messages.
std::string imageSizeNames();

} // namespace app
