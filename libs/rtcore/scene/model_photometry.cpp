#include "rtcore/scene/model_photometry.h"

#include <algorithm>
#include <cmath>

namespace rtcore {

namespace {

constexpr double kMaxCandela = 1e18, kMinBrightest = 1e-30;
constexpr double kAngleRounding = 2e-3, kApart = 0.9e-3; ///< degrees; readers of files round to 1e-3

bool isWithin(std::span<const double> numbers, double min, double max) {
    return std::ranges::all_of(numbers, [&](double each) { return each >= min && each <= max; });
}

bool ascends(std::span<const double> angles) {
    return std::ranges::adjacent_find(angles, [](double a, double b) { return !(b - a >= kApart); }) ==
           angles.end();
}

/// A count at the front of a list that goes on with more than that.
std::optional<std::size_t> countIn(double number, std::size_t left) {
    if (!(number >= 2) || !(number <= static_cast<double>(left)) || number != std::floor(number))
        return std::nullopt;
    return static_cast<std::size_t>(number);
}

std::vector<double> take(std::span<const double>& numbers, std::size_t count) {
    const std::span<const double> taken = numbers.first(count);
    numbers = numbers.subspan(count);
    return {taken.begin(), taken.end()};
}

} // namespace

std::vector<std::uint32_t> photometriesOf(std::span<const Light> lights) {
    std::vector<std::uint32_t> numbers;
    for (const Light& light : lights)
        if (light.photometry != 0 && std::ranges::find(numbers, light.photometry) == numbers.end())
            numbers.push_back(light.photometry);
    return numbers;
}

std::vector<double> numbersOf(const PhotometricWeb& web) {
    std::vector<double> numbers{static_cast<double>(web.gammas.size()),
                                static_cast<double>(web.planes.size())};
    for (const std::vector<double>* const list : {&web.gammas, &web.planes, &web.candela})
        numbers.insert(numbers.end(), list->begin(), list->end());
    return numbers;
}

bool isSoundWeb(const PhotometricWeb& web) {
    const double around = web.planes.back() - web.planes.front();
    return isWithin(web.gammas, 0, 180) && ascends(web.gammas) && isWithin(web.planes, -360, 720) &&
           ascends(web.planes) && std::fabs(around - 360) < kAngleRounding &&
           isWithin(web.candela, 0, kMaxCandela) && maxCandela(web) >= kMinBrightest;
}

std::optional<PhotometricWeb> takeWeb(std::span<const double>& numbers) {
    if (numbers.size() < 2) return std::nullopt;
    std::span<const double> rest = numbers.subspan(2);
    const auto gammas = countIn(numbers[0], rest.size()), planes = countIn(numbers[1], rest.size());
    if (!gammas || !planes || *gammas + *planes > rest.size() ||
        *gammas > (rest.size() - *gammas - *planes) / *planes)
        return std::nullopt;
    PhotometricWeb web;
    web.gammas = take(rest, *gammas);
    web.planes = take(rest, *planes);
    web.candela = take(rest, *gammas * *planes);
    if (!isSoundWeb(web)) return std::nullopt;
    numbers = rest;
    return web;
}

} // namespace rtcore
