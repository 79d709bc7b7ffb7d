/// Which format a file has: by its first bytes when it is read, by its extension when it is written.
#pragma once

#include "rtcore/io/images/decoded_image.h"

#include <filesystem>

namespace rtcore {

enum class ImageFormat { Unknown, Png, Jpeg, Bmp, Pnm, Tga, Tiff, Radiance, Exr, Pfm, Rare };

/// TGA has no mark at its start: it is what has a sensible TGA header and is nothing else.
ImageFormat sniffImageFormat(ByteSpan bytes);
/// ImageMagick's name of the coder for what sniffs as Rare, e.g. "WEBP"; "" for anything else.
std::string sniffRareFormat(ByteSpan bytes);

struct FormatName {
    const char* extension; ///< without dot, lower case
    ImageFormat format;
    const char* magickName; ///< for Rare
};
/// All extensions that can name an output, the usual one of each format first.
std::span<const FormatName> formatNames();
/// The entry for an extension without its dot, whatever its case; null when there is none.
const FormatName* findFormat(const std::string& extension);
/// The extension of a path, without its dot.
std::string extensionOf(const std::filesystem::path& path);
bool isLinear(ImageFormat format);

} // namespace rtcore
