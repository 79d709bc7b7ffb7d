#include "renderer/aov_file.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/post/straight_alpha.h"

#include <vector>

namespace renderer {

namespace {

using Channels = std::vector<rtcore::ImageChannel>;

template <typename Pixel>
constexpr std::size_t stepOf() {
    static_assert(sizeof(Pixel) % sizeof(float) == 0);
    return sizeof(Pixel) / sizeof(float);
}

void addAovs(const rtcore::Aovs& aovs, Channels& channels) {
    const rtcore::AovPixel& first = aovs.pixels().front();
    constexpr std::size_t kStep = stepOf<rtcore::AovPixel>();
    channels.insert(channels.end(), {{"albedo.R", &first.albedo.r, kStep},
                                     {"albedo.G", &first.albedo.g, kStep},
                                     {"albedo.B", &first.albedo.b, kStep},
                                     {"depth.Z", &first.depth, kStep},
                                     {"direct.R", &first.direct.r, kStep},
                                     {"direct.G", &first.direct.g, kStep},
                                     {"direct.B", &first.direct.b, kStep},
                                     {"normal.X", &first.normal.x, kStep},
                                     {"normal.Y", &first.normal.y, kStep},
                                     {"normal.Z", &first.normal.z, kStep},
                                     {"occlusion.Y", &first.visible, kStep}});
}

void addGuides(const rtcore::Guides& guides, Channels& channels) {
    const rtcore::Colour& albedo = guides.albedo.pixels.front();
    const rtcore::Vec3& normal = guides.normals.front();
    channels.insert(channels.end(), {{"guideAlbedo.R", &albedo.r, stepOf<rtcore::Colour>()},
                                     {"guideAlbedo.G", &albedo.g, stepOf<rtcore::Colour>()},
                                     {"guideAlbedo.B", &albedo.b, stepOf<rtcore::Colour>()},
                                     {"guideNormal.X", &normal.x, stepOf<rtcore::Vec3>()},
                                     {"guideNormal.Y", &normal.y, stepOf<rtcore::Vec3>()},
                                     {"guideNormal.Z", &normal.z, stepOf<rtcore::Vec3>()}});
}

void addImage(const std::string& layer, const rtcore::HdrImage& image, Channels& channels) {
    const rtcore::Colour& first = image.pixels.front();
    channels.insert(channels.end(), {{layer + "R", &first.r, stepOf<rtcore::Colour>()},
                                     {layer + "G", &first.g, stepOf<rtcore::Colour>()},
                                     {layer + "B", &first.b, stepOf<rtcore::Colour>()}});
}

/// Channels, and what they need that is nowhere else.
struct Layers {
    Channels channels;
    std::vector<float> alphas;

    Layers(const rtcore::HdrImage& radiance, const rtcore::Frame& frame) {
        addImage("", radiance, channels);
        if (!frame.hidesBackground()) return;
        alphas = rtcore::alphasOf(frame.transmitted);
        channels.push_back({"A", alphas.data(), 1});
    }
};

} // namespace

void writeExr(const std::filesystem::path& path, const rtcore::HdrImage& radiance, const rtcore::Frame& frame,
              std::span<const rtcore::ImageText> texts) {
    const Layers layers(radiance, frame);
    rtcore::writeExrChannels(path, radiance.width, radiance.height, layers.channels, texts);
}

void writeAovs(const std::filesystem::path& path, const rtcore::HdrImage& radiance,
               const rtcore::Frame& frame, const std::vector<float>& errors,
               std::span<const rtcore::ImageText> texts) {
    Layers layers(radiance, frame);
    Channels& channels = layers.channels;
    addAovs(frame.aovs, channels);
    if (!frame.guides.empty()) addGuides(frame.guides, channels);
    if (&radiance != &frame.radiance) addImage("sampled.", frame.radiance, channels);
    if (!errors.empty()) channels.push_back({"error.Y", errors.data(), 1});
    rtcore::writeExrChannels(path, radiance.width, radiance.height, channels, texts);
}

} // namespace renderer
