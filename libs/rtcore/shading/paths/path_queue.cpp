#include "rtcore/shading/paths/path_queue.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace rtcore {

void PathQueue::reserve(std::size_t count) {
    rays.reserve(count);
    if (sample.size() >= count + kWaveBlock) return;
    sample.resize(count + kWaveBlock);
    bounces.resize(count + kWaveBlock);
    for (auto& values : weight) values.resize(count + kWaveBlock);
    for (auto& values : extinction) values.resize(count + kWaveBlock);
    length.resize(count + kWaveBlock);
    if (hasMedia()) keepMedia();
}

void PathQueue::keepMedia() {
    for (auto& values : media) values.resize(sample.size());
}

void PathQueue::push(const Ray& ray, const Path& path) {
    const std::size_t i = size();
    if (sample.size() < i + 1 + kWaveBlock) reserve(2 * i + kWaveBlock);
    rays.push(ray);
    sample[i] = path.sample;
    bounces[i] = path.depth | std::uint32_t{path.passes} << 16 | (path.inside ? kInsideBit : 0) |
                 (path.lobeSeesDiscs ? kLobeBit : 0);
    const float weights[] = {path.weight.r, path.weight.g, path.weight.b};
    const float extinctions[] = {path.extinction.r, path.extinction.g, path.extinction.b};
    for (std::size_t c = 0; c < 3; ++c) {
        weight[c][i] = weights[c];
        extinction[c][i] = extinctions[c];
    }
    length[i] = path.length;
    if (!hasMedia() && path.media.empty()) return;
    if (!hasMedia()) keepMedia();
    media[0][i] = path.media.low();
    media[1][i] = path.media.high();
}

Path PathQueue::path(std::size_t i) const {
    Path path;
    path.sample = sample[i];
    path.weight = {weight[0][i], weight[1][i], weight[2][i]};
    path.extinction = {extinction[0][i], extinction[1][i], extinction[2][i]};
    path.depth = static_cast<std::uint16_t>(bounces[i]);
    path.passes = static_cast<std::uint16_t>(bounces[i] >> 16 & 0x3FFFU);
    path.inside = isInside(bounces[i]);
    path.lobeSeesDiscs = (bounces[i] & kLobeBit) != 0;
    path.length = length[i];
    if (hasMedia()) path.media = MediaList(media[0][i], media[1][i]);
    return path;
}

std::size_t PathQueue::grow(std::size_t count) {
    const std::size_t before = size();
    if (capacity() < before + count) reserve(std::max(before + count, 2 * before));
    rays.resize(before + count); // the new ones all zero
    std::fill(rays.tMax.begin() + static_cast<std::ptrdiff_t>(before), rays.tMax.end(),
              std::numeric_limits<float>::max());
    return before;
}

void PathQueue::takeLast(std::size_t count, PathQueue& taken) {
    if (count >= size()) {
        std::swap(*this, taken);
        clear();
        return;
    }
    const std::size_t keep = size() - count;
    taken.clear();
    taken.reserve(count);
    for (std::size_t i = keep; i < size(); ++i) taken.push(rays.ray(i), path(i));
    truncate(keep);
}

} // namespace rtcore
