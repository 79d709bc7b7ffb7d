#include "rtcore/io/images/image_file.h"

#include "rtcore/io/images/codecs.h"
#include "rtcore/io/images/image_format.h"
#include "rtcore/platform/files.h"

#include <array>
#include <new>
#include <string_view>

namespace rtcore {
namespace {

DecodedImage decode(ByteSpan bytes, const std::string& name) {
    if (bytes.empty()) badImage(name, "the file is empty");
    const ImageCodec* const codec = sniffCodec(bytes);
    if (codec == nullptr) badImage(name, "not an image of a known format; convert it to PNG, JPEG or EXR");
    try {
        return codec->decode(bytes, name);
    } catch (const std::bad_alloc&) {
        throw FileError(FailureKind::TryAgain, name, "not enough memory for this image");
    }
}

template <typename Pixel>
void checkEncodable(const Image<Pixel>& image, const std::string& name) {
    const bool sized = image.width > 0 && image.height > 0 && image.width <= kMaxImageSide &&
                       image.height <= kMaxImageSide && image.pixels.size() <= kMaxImagePixels;
    if (!sized || image.pixels.size() !=
                      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height)) {
        cannotEncode(name, say("an image of {0} x {1} pixels cannot be written", image.width, image.height));
    }
}

using Texts = std::span<const ImageText>;

Bytes encodeHdr(const HdrImage& image, const FormatName* target, Texts texts, const std::string& name) {
    checkEncodable(image, name);
    if (target == nullptr || !target->codec.isLinear())
        cannotEncode(name, "linear colour goes into .exr, .hdr or .pfm only");
    return target->codec.encodeLinear(image, texts, name);
}

Bytes encodeLdr(const LdrImage& image, const FormatName* target, const ImageNotes& notes,
                const std::string& name) {
    if (target == nullptr) cannotEncode(name, say("unknown image format; known are {0}", writableFormats()));
    checkEncodable(image, name);
    const ImageCodec& codec = target->codec;
    if (codec.encode != nullptr) return codec.encode(image, notes, *target, name);
    return encodeHdr(toHdr(image), target, notes.texts, name);
}

void replaceWith(const std::filesystem::path& path, const Bytes& bytes) {
    const std::array<std::span<const std::byte>, 1> pieces{bytes};
    writeFileAtomically(path, pieces);
}

} // namespace

LdrImage readLdrImage(const std::filesystem::path& path) {
    const FileBytes file = openFileBytes(path);
    return decodeLdrImage(file.bytes, path.string());
}

HdrImage readHdrImage(const std::filesystem::path& path) {
    const FileBytes file = openFileBytes(path);
    return decodeHdrImage(file.bytes, path.string());
}

LdrImage decodeLdrImage(std::span<const std::byte> bytes, const std::string& nameForErrors) {
    return toLdr(decode(bytes, nameForErrors));
}

HdrImage decodeHdrImage(std::span<const std::byte> bytes, const std::string& nameForErrors) {
    return toHdr(decode(bytes, nameForErrors));
}

void writeImage(const std::filesystem::path& path, const LdrImage& image, const ImageNotes& notes) {
    replaceWith(path, encodeLdr(image, findFormat(extensionOf(path)), notes, path.string()));
}

void writeHdrImage(const std::filesystem::path& path, const HdrImage& image, Texts texts) {
    replaceWith(path, encodeHdr(image, findFormat(extensionOf(path)), texts, path.string()));
}

void writeExrChannels(const std::filesystem::path& path, int width, int height,
                      std::span<const ImageChannel> channels, Texts texts) {
    replaceWith(path, encodeExr(width, height, channels, texts, path.string()));
}

bool isExr(const std::filesystem::path& path) {
    const FormatName* target = findFormat(extensionOf(path));
    return target != nullptr && target->extension == std::string_view("exr");
}

bool isHdrFormat(const std::filesystem::path& path) {
    const FormatName* target = findFormat(extensionOf(path));
    return target != nullptr && target->codec.isLinear();
}

bool keepsAlpha(const std::filesystem::path& path) {
    const FormatName* target = findFormat(extensionOf(path));
    return target != nullptr && target->alpha;
}

bool isWritableFormat(const std::filesystem::path& path) {
    const FormatName* target = findFormat(extensionOf(path));
    return target != nullptr && target->isWritable();
}

std::string writableFormats() {
    std::string list;
    for (const FormatName& name : formatNames()) {
        if (!name.isWritable()) continue;
        list += list.empty() ? "" : ", ";
        list += name.extension;
    }
    return list;
}

std::vector<std::byte> encodeImage(const LdrImage& image, const std::string& format,
                                   const ImageNotes& notes) {
    return encodeLdr(image, findFormat(format), notes, "output." + format);
}

} // namespace rtcore
