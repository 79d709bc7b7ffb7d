#include "rtcore/io/import/materials/image_storage.h"

#include "rtcore/io/import/materials/relief.h"
#include "rtcore/scene/block_encoder.h"

#include <algorithm>
#include <cstdint>

namespace rtcore {

namespace {

constexpr double kMaxError = 1, kMaxErrorOfNormals = 1.0 / 12;

bool isOpaque(const LdrImage& image) {
    return std::ranges::all_of(image.pixels, [](Rgba8 p) { return p.a == 255; });
}

/// Whether the blocks are good enough; if not, they are taken off again.
bool storeBlocks(const LdrImage& image, std::vector<TexelBlock>& blocks) {
    if (image.pixels.size() < kWorthBlocks || !isOpaque(image)) return false;
    const std::size_t before = blocks.size();
    const double error = appendBlocks(image, blocks);
    const bool good = error <= kMaxErrorOfNormals || (error <= kMaxError && !holdsNormals(image));
    if (!good) blocks.resize(before);
    return good;
}

} // namespace

Texture storeImage(const LdrImage& image, ModelBuffers& model) {
    Texture stored{model.blocks.size(), static_cast<std::uint32_t>(image.width),
                   static_cast<std::uint32_t>(image.height)};
    if (storeBlocks(image, model.blocks)) {
        stored.storage = TextureStorage::Blocks;
        return stored;
    }
    stored.firstTexel = model.texels.size();
    model.texels.insert(model.texels.end(), image.pixels.begin(), image.pixels.end());
    return stored;
}

} // namespace rtcore
