// The only file that sees ImageMagick. It gets bytes, never a file's name, and the name of one of its own
// coders: no name means a script, a URL or a pipe to it, and a coder that is built in needs no other program.
#include "rtcore/io/images/codecs.h"
#include "rtcore/io/images/damage_forms.h"
#include "rtcore/io/images/image_format.h"
#include "rtcore/settings/library_text.h"

#ifdef RT_HAVE_MAGICK

#include <Magick++.h>

#include <array>
#include <exception>
#include <mutex>

namespace rtcore {
namespace {

constexpr auto kMagickTexts = std::to_array<LibraryText>({
    {"{0}: insufficient image data in file {1}", damage::kEndsEarly},
    {"{0}: unexpected end-of-file {1}", damage::kEndsEarly},
    {"{0}: corrupt image {1}", damage::kPixels},
    {"{0}: unable to decompress image {1}", damage::kPixels},
    {"{0}: invalid colormap index {1}", damage::kPixels},
    {"{0}: decoder suspended {1}", damage::kPixels},
    {"{0}: improper image header {1}", damage::kHeader},
    {"{0}: negative or zero image size {1}", damage::kHeader},
    {"{0}: width or height exceeds limit {1}", damage::kHeader},
    {"{0}: maximum channels exceeded {1}", damage::kHeader},
    {"{0}: missing image channel {1}", damage::kHeader},
    {"{0}: Invalid PSD resource block {1}", damage::kHeader},
    {"{0}: InvalidNumberOfLayers {1}", damage::kHeader},
    {"{0}: NoSuchImageChannel {1}", damage::kHeader},
    {"{0}: image type not supported {1}", damage::kUnread},
});

void start() {
    static std::once_flag done;
    std::call_once(done, [] { Magick::InitializeMagick(nullptr); });
}

bool hasCoder(const std::string& magickName, bool (Magick::CoderInfo::*ability)() const) {
    start();
    try {
        return (Magick::CoderInfo(magickName).*ability)();
    } catch (const std::exception&) {
        return false;
    }
}

} // namespace

bool rareReadable(const std::string& magickName) {
    return hasCoder(magickName, &Magick::CoderInfo::isReadable);
}

bool rareWritable(const std::string& magickName) {
    return hasCoder(magickName, &Magick::CoderInfo::isWritable);
}

DecodedImage decodeRare(ByteSpan bytes, const std::string& name) {
    const std::string coder = sniffRareFormat(bytes);
    if (!rareReadable(coder))
        badImage(name, say("ImageMagick cannot read {0} here; convert the file to PNG", coder));
    try {
        const Magick::Blob blob(bytes.data(), bytes.size());
        Magick::Image picture;
        picture.quiet(true); // warnings are no reason to refuse an image
        picture.magick(coder);
        picture.ping(blob);
        checkImageSize(name, static_cast<std::int64_t>(picture.columns()),
                       static_cast<std::int64_t>(picture.rows()));
        picture.magick(coder);
        picture.read(blob);
        checkImageSize(name, static_cast<std::int64_t>(picture.columns()),
                       static_cast<std::int64_t>(picture.rows()));
        picture.colorSpace(Magick::sRGBColorspace);
        LdrImage image(static_cast<int>(picture.columns()), static_cast<int>(picture.rows()));
        picture.write(0, 0, picture.columns(), picture.rows(), "RGBA", Magick::CharPixel,
                      image.pixels.data());
        return image;
    } catch (const Magick::Exception& error) {
        badImage(name, say("damaged {0}: {1}", coder, meaningOf(error.what(), kMagickTexts)));
    }
}

Bytes encodeRare(const LdrImage& image, const std::string& name, const std::string& magickName) {
    if (!rareWritable(magickName))
        cannotEncode(name, say("ImageMagick cannot write {0} here; use .png", magickName));
    try {
        Magick::Image picture(static_cast<std::size_t>(image.width), static_cast<std::size_t>(image.height),
                              "RGBA", Magick::CharPixel, image.pixels.data());
        picture.matte(hasAlpha(image));
        picture.magick(magickName);
        picture.quality(95);
        Magick::Blob blob;
        picture.write(&blob);
        const auto* data = static_cast<const std::byte*>(blob.data());
        if (data == nullptr || blob.length() == 0) cannotEncode(name, "ImageMagick wrote nothing");
        return {data, data + blob.length()};
    } catch (const Magick::Exception& error) {
        cannotEncode(name, meaningOf(error.what(), {}));
    }
}

} // namespace rtcore

#else

namespace rtcore {

bool rareReadable(const std::string& /*magickName*/) { return false; }

bool rareWritable(const std::string& /*magickName*/) { return false; }

DecodedImage decodeRare(ByteSpan bytes, const std::string& name) {
    badImage(name, say("this build cannot read {0}; convert the file to PNG", sniffRareFormat(bytes)));
}

Bytes encodeRare(const LdrImage& /*image*/, const std::string& name, const std::string& magickName) {
    cannotEncode(name, say("this build cannot write {0}; use .png", magickName));
}

} // namespace rtcore

#endif
