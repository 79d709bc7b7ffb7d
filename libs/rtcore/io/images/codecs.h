/// One decoder and one encoder a format; image_file.cpp chooses. Decoders throw FileError BadData, encoders
/// CannotWrite, both with `name` as the file; `name` is used for nothing else. No state, safe from many
/// threads.
#pragma once

#include "rtcore/io/images/decoded_image.h"
#include "rtcore/io/images/image_file.h"

namespace rtcore {

DecodedImage decodePng(ByteSpan bytes, const std::string& name);  // libpng
DecodedImage decodeJpeg(ByteSpan bytes, const std::string& name); // libjpeg; damaged data is an error
DecodedImage decodeTiff(ByteSpan bytes, const std::string& name); // libtiff; first image of the file
DecodedImage decodeBmp(ByteSpan bytes, const std::string& name);  // all but embedded PNG and JPEG
DecodedImage decodePnm(ByteSpan bytes, const std::string& name);  // P1 to P6
DecodedImage decodeTga(ByteSpan bytes, const std::string& name);  // all types, with and without run lengths
DecodedImage decodeRadiance(ByteSpan bytes, const std::string& name); // RGBE, flat or either run-length form
DecodedImage decodePfm(ByteSpan bytes, const std::string& name);      // PF and Pf, either byte order
DecodedImage decodeExr(ByteSpan bytes, const std::string& name);  // OpenEXR: R, G, B or Y of the first part
DecodedImage decodeRare(ByteSpan bytes, const std::string& name); // ImageMagick: image_format.h's list

Bytes encodePng(const LdrImage& image, const std::string& name); // CImg
Bytes encodeBmp(const LdrImage& image, const std::string& name); // CImg
Bytes encodePpm(const LdrImage& image, const std::string& name); // CImg
Bytes encodeJpeg(const LdrImage& image, bool panorama, const std::string& name);
Bytes encodeTiff(const LdrImage& image, double dpi, const std::string& name); // LZW
Bytes encodeTga(const LdrImage& image, const std::string& name);
Bytes encodeRare(const LdrImage& image, const std::string& name, const std::string& magickName);
Bytes encodeRadiance(const HdrImage& image, const std::string& name);
Bytes encodePfm(const HdrImage& image, const std::string& name);
Bytes encodeExr(const HdrImage& image, std::span<const ImageText> texts,
                const std::string& name); // float, ZIP
Bytes encodeExr(int width, int height, std::span<const ImageChannel> channels,
                std::span<const ImageText> texts, const std::string& name);

/// A whole PNG file of the image, with these notes as well.
Bytes withPngNotes(Bytes png, const LdrImage& image, const ImageNotes& notes);

/// Was this build made with them, and does ImageMagick have the coder?
bool exrAvailable();
bool rareReadable(const std::string& magickName);
bool rareWritable(const std::string& magickName);

} // namespace rtcore
