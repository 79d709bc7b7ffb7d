/// Which format a file has: by its first bytes when it is read, by its extension when it is written; and how
/// it is read and written.
#pragma once

#include "rtcore/io/images/decoded_image.h"
#include "rtcore/io/images/image_file.h"

#include <filesystem>

namespace rtcore {

struct FormatName;

/// The functions that read and write a format; null where there is none. They throw as codecs.h says.
struct ImageCodec {
    using Texts = std::span<const ImageText>;

    DecodedImage (*decode)(ByteSpan bytes, const std::string& name) = nullptr;
    Bytes (*encode)(const LdrImage& image, const ImageNotes& notes, const FormatName& target,
                    const std::string& name) = nullptr;
    Bytes (*encodeLinear)(const HdrImage& image, Texts texts, const std::string& name) = nullptr;
    bool (*writable)(const FormatName& target) = nullptr; ///< by this build; null: always

    bool isLinear() const { return encodeLinear != nullptr; }
};
/// The codec that reads a file that begins with `bytes`; null: none. TGA has no mark at its start: a file
/// with a sensible TGA header that is nothing else is taken for one.
const ImageCodec* sniffCodec(ByteSpan bytes);
/// ImageMagick's name of the coder for a format that only ImageMagick reads, e.g. "WEBP"; "" for any other.
std::string sniffRareFormat(ByteSpan bytes);

struct FormatName {
    const char* extension; ///< without dot, lower case
    const ImageCodec& codec;
    const char* magickName = ""; ///< of ImageMagick's coder, where that is what writes it
    bool alpha = false;          ///< files that this build writes keep it, in all 256 steps or more

    bool isWritable() const { return codec.writable == nullptr || codec.writable(*this); }
};
/// All extensions that can name an output, the usual one of each format first.
std::span<const FormatName> formatNames();
/// The entry for an extension without its dot, whatever its case; null when there is none.
const FormatName* findFormat(const std::string& extension);
/// The extension of a path, without its dot.
std::string extensionOf(const std::filesystem::path& path);

} // namespace rtcore
