#include "renderer/aov_file.h"

#include "rtcore/io/images/image_file.h"

#include <vector>

namespace renderer {

void writeAovs(const std::filesystem::path& path, const rtcore::HdrImage& radiance, const rtcore::Aovs& aovs,
               std::span<const rtcore::ImageText> texts) {
    const rtcore::Colour& seen = radiance.pixels.front();
    const rtcore::AovPixel& first = aovs.pixels().front();
    constexpr std::size_t kStep = sizeof(rtcore::AovPixel) / sizeof(float);
    static_assert(sizeof(rtcore::AovPixel) % sizeof(float) == 0);
    const std::vector<rtcore::ImageChannel> channels{
        {"R", &seen.r, 3},
        {"G", &seen.g, 3},
        {"B", &seen.b, 3},
        {"albedo.R", &first.albedo.r, kStep},
        {"albedo.G", &first.albedo.g, kStep},
        {"albedo.B", &first.albedo.b, kStep},
        {"depth.Z", &first.depth, kStep},
        {"direct.R", &first.direct.r, kStep},
        {"direct.G", &first.direct.g, kStep},
        {"direct.B", &first.direct.b, kStep},
        {"normal.X", &first.normal.x, kStep},
        {"normal.Y", &first.normal.y, kStep},
        {"normal.Z", &first.normal.z, kStep},
        {"occlusion.Y", &first.visible, kStep},
    };
    rtcore::writeExrChannels(path, radiance.width, radiance.height, channels, texts);
}

} // namespace renderer
