/// Images in files. What a file is follows from its first bytes, never from its name; what is written
/// follows from the extension. Sizes are checked against kMaxImageSide and kMaxImagePixels before pixels are
/// allocated. No other program is ever started. Every function may be called from many threads at once.
#pragma once

#include "rtcore/io/images/image_notes.h"
#include "rtcore/scene/image.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace rtcore {

/// Eight bits a channel as sRGB: 16-bit files are rounded, linear ones (.hdr, .exr, .pfm, float TIFF) clamped
/// to [0, 1] and encoded. Throws FileError: NoInput when the file cannot be read, BadData when its content is
/// wrong.
LdrImage readLdrImage(const std::filesystem::path& path);

/// Linear colour: 8- and 16-bit files are decoded from sRGB to [0, 1], linear ones taken as they are, except
/// that NaN becomes 0 and infinity 65504 (the largest half). Alpha is dropped. Throws as readLdrImage does.
HdrImage readHdrImage(const std::filesystem::path& path);

/// The same from memory, for textures inside a model's file. Throws FileError BadData that names
/// `nameForErrors`.
LdrImage decodeLdrImage(std::span<const std::byte> bytes, const std::string& nameForErrors);
HdrImage decodeHdrImage(std::span<const std::byte> bytes, const std::string& nameForErrors);

/// Replaces `path` (platform/files.h: all or nothing). Formats without alpha (JPEG, BMP, PPM) drop it; JPEG
/// has quality 95. A linear format gets decoded sRGB. Formats that cannot keep a note drop it. Throws
/// FileError CannotWrite.
void writeImage(const std::filesystem::path& path, const LdrImage& image, const ImageNotes& notes = {});

/// Unclamped linear colour into .exr (32-bit float), .hdr (Radiance RGBE, negative parts become 0) or .pfm.
/// Throws FileError CannotWrite, also for any other extension.
void writeHdrImage(const std::filesystem::path& path, const HdrImage& image,
                   std::span<const ImageText> texts = {});

/// One float of each pixel, somewhere in memory.
struct ImageChannel {
    std::string name;             ///< "R"; of a layer "normal.X"
    const float* first = nullptr; ///< of the upper left pixel
    std::size_t step = 1;         ///< floats from one pixel to the next; rows follow each other
};

/// Any channels into one .exr, as 32-bit float. Throws FileError CannotWrite.
void writeExrChannels(const std::filesystem::path& path, int width, int height,
                      std::span<const ImageChannel> channels, std::span<const ImageText> texts = {});

/// By extension, whatever its case: is it .exr?
bool isExr(const std::filesystem::path& path);
/// By extension, whatever its case: does the format keep linear colour; can this build write it?
bool isHdrFormat(const std::filesystem::path& path);
/// The same: does it keep alpha?
bool keepsAlpha(const std::filesystem::path& path);
bool isWritableFormat(const std::filesystem::path& path);
/// The extensions that this build can write, for help texts: "png, jpg, bmp, ...".
std::string writableFormats();

/// The bytes of a file of that format, an extension without its dot ("png", "ppm"), for writing to a pipe.
/// Throws FileError CannotWrite.
std::vector<std::byte> encodeImage(const LdrImage& image, const std::string& format,
                                   const ImageNotes& notes = {});

} // namespace rtcore
