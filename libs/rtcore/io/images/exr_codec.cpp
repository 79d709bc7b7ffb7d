// The only file that sees OpenEXR.
#include "rtcore/io/images/codecs.h"
#include "rtcore/io/images/damage_forms.h"
#include "rtcore/settings/library_text.h"

#ifdef RT_HAVE_OPENEXR

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <mutex>
#include <new>
#include <stdexcept>

namespace rtcore {
namespace {

constexpr auto kExrTexts = std::to_array<LibraryText>({
    {damage::kEndsEarly, damage::kEndsEarly},
    {"Error reading pixel data from image file \"\". {0}", damage::kPixels},
    {"Cannot read image file \"\". Cannot read version {0}", damage::kUnread},
    {"Cannot read image file \"\". The file format version number's flag field contains {0}",
     damage::kUnread},
    {"Cannot read image file \"\". {0}", damage::kHeader},
});

class MemoryInput : public Imf::IStream {
  public:
    explicit MemoryInput(ByteSpan bytes) : IStream(""), bytes_(bytes) {}

    bool read(char* target, int count) override {
        const auto n = static_cast<std::size_t>(std::max(count, 0));
        if (position_ > bytes_.size() || n > bytes_.size() - position_) {
            throw std::runtime_error(damage::kEndsEarly);
        }
        std::memcpy(target, bytes_.data() + position_, n);
        position_ += n;
        return position_ < bytes_.size();
    }
    std::uint64_t tellg() override { return position_; }
    void seekg(std::uint64_t position) override { position_ = position; }

  private:
    ByteSpan bytes_;
    std::size_t position_ = 0;
};

class MemoryOutput : public Imf::OStream {
  public:
    MemoryOutput() : OStream("") {}

    void write(const char* source, int count) override {
        const std::size_t end = position_ + static_cast<std::size_t>(count);
        if (end > bytes.size()) bytes.resize(end);
        std::memcpy(bytes.data() + position_, source, static_cast<std::size_t>(count));
        position_ = end;
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

    Bytes bytes;

  private:
    std::size_t position_ = 0;
};

/// The library's own checks, made before it allocates anything that depends on the size.
void limitSizes() {
    static std::once_flag done;
    std::call_once(done, [] {
        Imf::Header::setMaxImageSize(kMaxImageSide, kMaxImageSide);
        Imf::Header::setMaxTileSize(kMaxImageSide, kMaxImageSide);
    });
}

/// A grey image has only Y; files of luminance and two chroma channels of lower resolution are not read.
bool isGrey(const Imf::ChannelList& channels, const std::string& name) {
    const bool colour = channels.findChannel("R") != nullptr && channels.findChannel("G") != nullptr &&
                        channels.findChannel("B") != nullptr;
    const bool chroma = channels.findChannel("RY") != nullptr || channels.findChannel("BY") != nullptr;
    if (!colour && (channels.findChannel("Y") == nullptr || chroma)) {
        std::string list;
        for (auto c = channels.begin(); c != channels.end() && list.size() < 200; ++c) {
            list += list.empty() ? c.name() : std::string(", ") + c.name();
        }
        if (list.empty()) badImage(name, "EXR needs the channels R, G and B, or Y alone; it has none");
        badImage(name, say("EXR needs the channels R, G and B, or Y alone; it has {0}", list));
    }
    for (auto c = channels.begin(); c != channels.end(); ++c) {
        const bool used = colour ? std::strlen(c.name()) == 1 && std::strchr("RGB", c.name()[0]) != nullptr
                                 : std::strcmp(c.name(), "Y") == 0;
        if (used && (c.channel().xSampling != 1 || c.channel().ySampling != 1)) {
            badImage(name, "EXR with channels of a lower resolution cannot be read");
        }
    }
    return !colour;
}

/// Slices that put the channels into `image`, whose first pixel is the window's (x0, y0).
Imf::FrameBuffer frameOver(HdrImage& image, bool grey, int x0, int y0) {
    const auto xStride = static_cast<std::ptrdiff_t>(sizeof(Colour));
    const std::ptrdiff_t yStride = xStride * image.width;
    Imf::FrameBuffer frame;
    const auto insert = [&](const char* channel, float Colour::*member) {
        char* first = reinterpret_cast<char*>(&(image.pixels[0].*member));
        const auto origin = reinterpret_cast<std::intptr_t>(first) - x0 * xStride - y0 * yStride;
        frame.insert(channel,
                     Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(origin),
                                static_cast<std::size_t>(xStride), static_cast<std::size_t>(yStride)));
    };
    if (grey) {
        insert("Y", &Colour::r);
        return frame;
    }
    insert("R", &Colour::r);
    insert("G", &Colour::g);
    insert("B", &Colour::b);
    return frame;
}

HdrImage readExr(ByteSpan bytes, const std::string& name) {
    MemoryInput input(bytes);
    Imf::InputFile file(input, 0);
    const Imath::Box2i window = file.header().dataWindow();
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    checkImageSize(name, width, height);
    // Deflate packs at most 516 half-precision grey pixels into a byte.
    checkPlausible(name, static_cast<std::size_t>(width * height), bytes.size(), 2048);
    const bool grey = isGrey(file.header().channels(), name);
    HdrImage image(static_cast<int>(width), static_cast<int>(height));
    file.setFrameBuffer(frameOver(image, grey, window.min.x, window.min.y));
    file.readPixels(window.min.y, window.max.y);
    if (grey) {
        for (Colour& c : image.pixels) c = {c.r, c.r, c.r};
    }
    return image;
}

} // namespace

DecodedImage decodeExr(ByteSpan bytes, const std::string& name) {
    limitSizes();
    try {
        return readExr(bytes, name);
    } catch (const FileError&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        badImage(name, say("damaged EXR: {0}", meaningOf(error.what(), kExrTexts)));
    }
}

Bytes encodeExr(const HdrImage& image, std::span<const ImageText> texts, const std::string& name) {
    const Colour* const first = image.pixels.data();
    const ImageChannel channels[] = {{"R", &first->r, 3}, {"G", &first->g, 3}, {"B", &first->b, 3}};
    static_assert(sizeof(Colour) == 3 * sizeof(float));
    return encodeExr(image.width, image.height, channels, texts, name);
}

Bytes encodeExr(int width, int height, std::span<const ImageChannel> channels,
                std::span<const ImageText> texts, const std::string& name) {
    try {
        Imf::Header header(width, height);
        header.compression() = Imf::ZIP_COMPRESSION;
        for (const ImageText& text : texts) header.insert(text.name, Imf::StringAttribute(text.text));
        Imf::FrameBuffer frame;
        for (const ImageChannel& channel : channels) {
            header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
            // The library only reads through the slices of an output, which are not const all the same.
            char* const first = reinterpret_cast<char*>(const_cast<float*>(channel.first));
            const std::size_t step = channel.step * sizeof(float);
            frame.insert(channel.name,
                         Imf::Slice(Imf::FLOAT, first, step, step * static_cast<std::size_t>(width)));
        }
        MemoryOutput output;
        {
            Imf::OutputFile file(output, header, 0);
            file.setFrameBuffer(frame);
            file.writePixels(height);
        }
        return std::move(output.bytes);
    } catch (const std::exception& error) {
        cannotEncode(name, say("{0}: {1}", std::string("EXR"), meaningOf(error.what(), {})));
    }
}

bool exrAvailable() { return true; }

} // namespace rtcore

#else

namespace rtcore {

DecodedImage decodeExr(ByteSpan /*bytes*/, const std::string& name) {
    badImage(name, "this build reads no EXR; convert it to .hdr");
}

Bytes encodeExr(const HdrImage& /*image*/, std::span<const ImageText> /*texts*/, const std::string& name) {
    cannotEncode(name, "this build writes no EXR; use .hdr or .pfm");
}

Bytes encodeExr(int /*width*/, int /*height*/, std::span<const ImageChannel> /*channels*/,
                std::span<const ImageText> /*texts*/, const std::string& name) {
    cannotEncode(name, "this build writes no EXR");
}

bool exrAvailable() { return false; }

} // namespace rtcore

#endif
