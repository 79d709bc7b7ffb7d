/// FLIP: how much of a difference people see who flip between two images. (Andersson, Nilsson,
/// Akenine-Möller, Oskarsson, Åström and Fairchild 2020, "FLIP: A Difference Evaluator for Alternating
/// Images"; equations are that paper's, with its erratum: luminance is (Y + 16) / 116.)
#pragma once

#include "rtcore/scene/image.h"

#include <vector>

namespace test {

/// Compares images with one reference. The same reference may be asked by several threads at once.
class Flip {
  public:
    /// The paper's viewing conditions: a screen of 0.7 m and 3840 pixels, 0.7 m away.
    static constexpr float kPixelsPerDegree = 67.0206F;

    explicit Flip(const rtcore::LdrImage& reference, float pixelsPerDegree = kPixelsPerDegree);

    /// For each pixel, 0 = no difference is seen to 1. `image` has the size of the reference.
    std::vector<float> errors(const rtcore::LdrImage& image) const;
    /// Their mean.
    double mean(const rtcore::LdrImage& image) const;

    /// The largest difference of colour that there is, that of green and blue.
    static float largestColourDifference();

  private:
    using Plane = std::vector<float>; ///< one value for each pixel, row by row

    /// One dimension of a filter that is the product of two; its middle is that of the list.
    using Weights = std::vector<float>;

    struct Filters {
        Weights achromatic, redGreen, blueYellow, blueYellowWide;
        float narrowPart = 1, widePart = 0; ///< of the last two
        Weights smooth, slope, curvature;   ///< Gaussian and its derivatives
    };
    /// The features of an image that are compared.
    struct Seen {
        Plane lightness, redGreen, blueYellow; ///< CIELAB after the eye's filter, Hunt-adjusted
        Plane edges, points;                   ///< how strong
    };

    static Filters filtersFor(float pixelsPerDegree);
    Plane filtered(const Plane& plane, const Weights& across, const Weights& down) const;
    Seen see(const rtcore::LdrImage& image) const;
    void seeFeatures(const Plane& luminance, Seen& seen) const;

    int width_, height_;
    Filters filters_;
    Seen reference_;
};

} // namespace test
