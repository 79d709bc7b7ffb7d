#include "rtcore/io/photometry/web_symmetry.h"

#include <cmath>
#include <cstddef>

namespace rtcore {

namespace {

constexpr double kSame = 1e-3; ///< degrees

bool isAbout(double a, double b) { return std::fabs(a - b) < kSame; }

void addPlane(PhotometricWeb& web, double angle, std::size_t like) {
    const std::size_t count = web.gammas.size();
    web.planes.push_back(angle);
    for (std::size_t i = 0; i < count; ++i) web.candela.push_back(web.candela[like * count + i]);
}

/// Adds the mirrored planes behind the last one.
void mirrorAtLast(PhotometricWeb& web) {
    const double last = web.planes.back();
    for (std::size_t i = web.planes.size() - 1; i-- > 0;) addPlane(web, 2 * last - web.planes[i], i);
}

} // namespace

bool completeWeb(PhotometricWeb& web) {
    const double first = web.planes.front();
    if (web.planes.size() == 1) {
        addPlane(web, first + 360, 0);
        return true;
    }
    const auto span = [&] { return web.planes.back() - first; };
    if (isAbout(first, 0) && isAbout(span(), 90)) mirrorAtLast(web);
    if (isAbout(span(), 180)) mirrorAtLast(web);
    if (span() > 180 && span() < 360 - kSame) addPlane(web, first + 360, 0);
    return isAbout(span(), 360);
}

PhotometricWeb mirroredWeb(const PhotometricWeb& web) {
    PhotometricWeb mirrored{web.gammas, {}, {}};
    const std::size_t count = web.gammas.size();
    for (std::size_t i = web.planes.size(); i-- > 0;) {
        const auto first = web.candela.begin() + static_cast<std::ptrdiff_t>(i * count);
        mirrored.planes.push_back(360 - web.planes[i]);
        mirrored.candela.insert(mirrored.candela.end(), first, first + static_cast<std::ptrdiff_t>(count));
    }
    return mirrored;
}

} // namespace rtcore
