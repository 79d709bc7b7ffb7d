/// Squares and products of colours, by which errors of images are estimated.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/render/sample_halves.h"

namespace rtcore {

/// A mean over the channels.
inline double meanProduct(Colour a, Colour b) {
    return (static_cast<double>(a.r) * static_cast<double>(b.r) +
            static_cast<double>(a.g) * static_cast<double>(b.g) +
            static_cast<double>(a.b) * static_cast<double>(b.b)) /
           3;
}
inline double squared(Colour a) { return meanProduct(a, a); }
inline double squared(double a) { return a * a; }

/// f (1 - f): the variance of the mean of all samples, as a fraction of the expected (A - B)^2.
inline double noiseOfMean(const SampleHalves& halves) {
    const auto fraction = static_cast<double>(halves.firstFraction);
    return fraction * (1 - fraction);
}

} // namespace rtcore
