/// Formats of drawings, by the extensions of their files.
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace rtcore {

enum class DrawingFormat { Svg, Pdf, Dxf, Image };

/// Whatever the case of the extension; nothing for others.
inline std::optional<DrawingFormat> drawingFormatOf(const std::filesystem::path& path) {
    using enum DrawingFormat;
    static constexpr std::array<std::pair<std::string_view, DrawingFormat>, 6> kExtensions{
        {{".svg", Svg}, {".pdf", Pdf}, {".dxf", Dxf}, {".png", Image}, {".tif", Image}, {".tiff", Image}}};
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const auto& [known, format] : kExtensions)
        if (known == extension) return format;
    return std::nullopt;
}

} // namespace rtcore
