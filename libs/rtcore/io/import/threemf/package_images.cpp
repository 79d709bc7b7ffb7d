#include "rtcore/io/import/threemf/package_images.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/io/import/threemf/paints.h"
#include "rtcore/platform/error.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace rtcore::threemf {

namespace {

Paint linear(Rgba8 pixel) {
    const auto decode = [](std::uint8_t code) { return srgbDecode(static_cast<float>(code) / 255); };
    return {{decode(pixel.r), decode(pixel.g), decode(pixel.b)}, static_cast<float>(pixel.a) / 255};
}

Rgba8 encoded(const Paint& paint) {
    const auto code = [](float v) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(v, 0.0F, 1.0F) * 255));
    };
    return {code(srgbEncode(paint.colour.r)), code(srgbEncode(paint.colour.g)),
            code(srgbEncode(paint.colour.b)), code(paint.alpha)};
}

/// The pixel of `image` that lies where (x, y) of one of another size does.
Rgba8 nearest(const LdrImage& image, const LdrImage& like, int x, int y) {
    const auto at = [](int i, int size, int of) {
        return static_cast<int>((std::int64_t{i} * 2 + 1) * size / (std::int64_t{of} * 2));
    };
    return image.at(at(x, image.width, like.width), at(y, image.height, like.height));
}

} // namespace

LdrImage PackageImages::single(const std::string& path) const {
    constexpr std::size_t kMaxBytes = std::size_t{1} << 28;
    if (!package_.has(path)) throw FileError(FailureKind::BadData, path, "it is missing in the package");
    const std::string bytes = package_.bytes(path, kMaxBytes);
    return decodeLdrImage(std::as_bytes(std::span(bytes)), path);
}

LdrImage PackageImages::decode(const std::string& name) const {
    const auto composed = composed_.find(name);
    if (composed == composed_.end()) return single(name);
    const std::vector<ImageLayer>& layers = composed->second;
    std::vector<LdrImage> images(layers.size());
    int width = 1, height = 1;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        if (layers[i].path.empty()) continue;
        images[i] = single(layers[i].path);
        width = std::max(width, images[i].width);
        height = std::max(height, images[i].height);
    }
    if (static_cast<std::size_t>(width) * static_cast<std::size_t>(height) > kMaxImagePixels)
        throw FileError(FailureKind::BadData, name, "its layers together are too large");
    LdrImage image(width, height);
#pragma omp parallel for schedule(static)
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            Paint paint = layers[0].paint;
            for (std::size_t i = 0; i < layers.size(); ++i) {
                const Paint upper =
                    images[i].empty() ? layers[i].paint : linear(nearest(images[i], image, x, y));
                paint = i == 0 ? upper : blended(paint, upper, layers[i].multiplies);
            }
            image.at(x, y) = encoded(paint);
        }
    }
    return image;
}

} // namespace rtcore::threemf
