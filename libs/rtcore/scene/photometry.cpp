#include "rtcore/scene/photometry.h"

#include "rtcore/math/constants.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/model_photometry.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <mutex>
#include <numbers>

namespace rtcore {

namespace {

constexpr double kExactPi = std::numbers::pi, kRadians = kExactPi / 180;

/// Integral of sin x times what is linear from (a, atA) to (b, atB).
double underSine(double a, double atA, double b, double atB) {
    const double slope = (atB - atA) / (b - a);
    return atA * std::cos(a) - atB * std::cos(b) + slope * (std::sin(b) - std::sin(a));
}

std::vector<float> radiansOf(const std::vector<double>& degrees) {
    std::vector<float> radians;
    for (const double each : degrees) radians.push_back(static_cast<float>(each * kRadians));
    return radians;
}

/// Of each gamma the largest of all planes, as a fraction of the largest of all.
std::vector<double> envelope(const PhotometricWeb& web) {
    const double max = maxCandela(web);
    std::vector<double> largest(web.gammas.size());
    for (std::size_t i = 0; i < web.candela.size(); ++i) {
        double& one = largest[i % largest.size()];
        one = std::max(one, web.candela[i] / max);
    }
    return largest;
}

/// The smallest spread s with intensity <= cos(angle - s) at all angles above s, and the largest angle with
/// light. Between two gammas the larger intensity counts at the wider angle.
void bound(const PhotometricWeb& web, Photometry& to) {
    const std::vector<double> largest = envelope(web);
    double spread = 0, last = 0;
    for (std::size_t i = 0; i + 1 < largest.size(); ++i) {
        const double larger = std::max(largest[i], largest[i + 1]);
        if (!(larger > 0)) continue;
        last = web.gammas[i + 1] * kRadians;
        spread = std::max(spread, last - std::acos(std::min(larger, 1.0)));
    }
    constexpr double kRounding = 1e-4;
    to.cosSpread = static_cast<float>(std::max(std::cos(std::min(spread, kExactPi)) - kRounding, -1.0));
    to.cosReach = static_cast<float>(std::cos(last));
    to.cosEdge = static_cast<float>(std::max(std::cos(last - std::min(spread, last)) - kRounding, 0.0));
}

/// One that is kept, with its arrays.
struct Kept {
    PhotometricWeb web;
    std::vector<float> gammas, planes, relative;
    Photometry rows;

    explicit Kept(const PhotometricWeb& of)
        : web(of), gammas(radiansOf(of.gammas)), planes(radiansOf(of.planes)) {
        const double max = maxCandela(web);
        for (const double each : web.candela) relative.push_back(static_cast<float>(each / max));
        rows.gammas = gammas.data();
        rows.planes = planes.data();
        rows.relative = relative.data();
        rows.gammaCount = static_cast<std::uint32_t>(gammas.size());
        rows.planeCount = static_cast<std::uint32_t>(planes.size());
        rows.turned = false;
        for (std::size_t i = gammas.size(); i < relative.size(); ++i)
            rows.turned = rows.turned || relative[i] != relative[i - gammas.size()];
        rows.mean = static_cast<float>(lumensOf(web) / (4 * kExactPi * max));
        bound(web, rows);
    }
};

/// Of all sides alike.
struct Even {
    std::array<float, 2> gammas{0, kPi}, planes{0, 2 * kPi};
    std::array<float, 4> relative{1, 1, 1, 1};
    Photometry rows{gammas.data(), planes.data(), relative.data(), 2, 2, false};
};

/// Read without a lock: an entry is complete before it is stored.
struct Shelf {
    Even even;
    std::mutex writing;
    std::vector<std::unique_ptr<Kept>> kept;
    std::array<std::atomic<const Photometry*>, kMaxPhotometries + 1> rows{};
};
Shelf& shelf() {
    static Shelf one;
    return one;
}

} // namespace

double lumensOf(const PhotometricWeb& web) {
    const std::size_t count = web.gammas.size();
    std::vector<double> ofPlane;
    for (std::size_t plane = 0; plane < web.planes.size(); ++plane) {
        const double* const candela = web.candela.data() + plane * count;
        double sum = 0;
        for (std::size_t i = 0; i + 1 < count; ++i)
            sum +=
                underSine(web.gammas[i] * kRadians, candela[i], web.gammas[i + 1] * kRadians, candela[i + 1]);
        ofPlane.push_back(sum);
    }
    double all = 0;
    for (std::size_t plane = 0; plane + 1 < web.planes.size(); ++plane)
        all += (web.planes[plane + 1] - web.planes[plane]) * kRadians * 0.5 *
               (ofPlane[plane] + ofPlane[plane + 1]);
    return all;
}

double maxCandela(const PhotometricWeb& web) { return *std::ranges::max_element(web.candela); }

std::uint32_t keepPhotometry(const PhotometricWeb& web) {
    Shelf& all = shelf();
    const std::scoped_lock lock(all.writing);
    const auto same =
        std::ranges::find_if(all.kept, [&](const std::unique_ptr<Kept>& each) { return each->web == web; });
    if (same != all.kept.end()) return static_cast<std::uint32_t>(same - all.kept.begin()) + 1;
    if (all.kept.size() == kMaxPhotometries)
        throw Refusal(say("this program has read {0} luminaires, the most that it keeps; start it anew",
                          kMaxPhotometries));
    all.kept.push_back(std::make_unique<Kept>(web));
    all.rows.at(all.kept.size()).store(&all.kept.back()->rows, std::memory_order_release);
    return static_cast<std::uint32_t>(all.kept.size());
}

const PhotometricWeb* keptWeb(std::uint32_t number) {
    Shelf& all = shelf();
    const std::scoped_lock lock(all.writing);
    return number > 0 && number <= all.kept.size() ? &all.kept[number - 1]->web : nullptr;
}

const Photometry& photometry(std::uint32_t number) {
    const Shelf& all = shelf();
    const Photometry* const rows =
        number <= kMaxPhotometries ? all.rows[number].load(std::memory_order_acquire) : nullptr;
    return rows != nullptr ? *rows : all.even.rows;
}

} // namespace rtcore
