#include "rtcore/scene/image_summary.h"

#include <cstdint>

namespace rtcore {

ImageSummary summarise(std::span<const Rgba8> texels) {
    // Histograms: the transfer curve is evaluated 256 times, whatever the size.
    std::array<std::array<std::uint64_t, 256>, 4> count{};
    for (const Rgba8 p : texels) {
        ++count[0][p.r];
        ++count[1][p.g];
        ++count[2][p.b];
        ++count[3][p.a];
    }
    const auto total = static_cast<double>(texels.size());
    std::array<double, 4> linear{}, code{};
    for (std::size_t v = 0; v < 256; ++v) {
        const float encoded = static_cast<float>(v) / 255;
        for (std::size_t c = 0; c < 4; ++c) {
            const double fraction = static_cast<double>(count[c][v]) / total;
            linear[c] += fraction * srgbDecode(encoded);
            code[c] += fraction * encoded;
        }
    }
    ImageSummary s;
    s.meanColour = {static_cast<float>(linear[0]), static_cast<float>(linear[1]),
                    static_cast<float>(linear[2])};
    for (std::size_t c = 0; c < 4; ++c) s.meanChannel[c] = static_cast<float>(code[c]);
    s.transparent = count[3][255] != texels.size();
    s.dark = count[0][255] != texels.size();
    return s;
}

} // namespace rtcore
