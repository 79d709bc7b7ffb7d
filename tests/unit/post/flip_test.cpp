// The yardstick of bench_walk against closed values, and against the paper's formulas as they stand there:
// filters in two dimensions, one pixel after another.
#include "support/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

namespace {

using rtcore::LdrImage;
using rtcore::Rgba8;
using test::Flip;

constexpr Rgba8 kBlack{0, 0, 0}, kWhite{255, 255, 255}, kGreen{0, 255, 0}, kBlue{0, 0, 255};

LdrImage uniform(Rgba8 colour) { return LdrImage(24, 20, colour); }

LdrImage noise(int width, int height, unsigned seed) {
    std::mt19937 random(seed);
    LdrImage image(width, height);
    for (Rgba8& p : image.pixels) {
        const auto byte = [&] { return static_cast<std::uint8_t>(random() % 256); };
        p = {byte(), byte(), byte()};
    }
    return image;
}

// --- The paper's formulas in double precision ---

struct Vec {
    double x = 0, y = 0, z = 0;
};

Vec toXyz(Rgba8 p) {
    const auto linear = [](double code) {
        const double s = code / 255;
        return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    };
    const double r = linear(p.r), g = linear(p.g), b = linear(p.b);
    return {0.4123907993 * r + 0.3575843394 * g + 0.1804807884 * b,
            0.2126390059 * r + 0.7151686788 * g + 0.0721923154 * b,
            0.0193308187 * r + 0.1191947798 * g + 0.9505321522 * b};
}
constexpr Vec kWhiteXyz{0.9504559271, 1.0000000001, 1.0890577507};

Vec opponent(Rgba8 p) { // YCxCz
    const Vec c = toXyz(p);
    const double x = c.x / kWhiteXyz.x, y = c.y / kWhiteXyz.y, z = c.z / kWhiteXyz.z;
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Vec huntLab(Vec o) {
    const double y = (o.x + 16) / 116, x = y + o.y / 500, z = y - o.z / 200;
    const double X = x * kWhiteXyz.x, Y = y * kWhiteXyz.y, Z = z * kWhiteXyz.z;
    const auto clamp = [](double v) { return std::clamp(v, 0.0, 1.0); };
    const double r = clamp(3.2409699419 * X - 1.5373831776 * Y - 0.4986107603 * Z);
    const double g = clamp(-0.9692436363 * X + 1.8759675015 * Y + 0.0415550574 * Z);
    const double b = clamp(0.0556300797 * X - 0.2039769589 * Y + 1.0569715142 * Z);
    const auto f = [](double t) {
        const double d = 6.0 / 29;
        return t > d * d * d ? std::cbrt(t) : t / (3 * d * d) + 4.0 / 29;
    };
    const double fx = f((0.4123907993 * r + 0.3575843394 * g + 0.1804807884 * b) / kWhiteXyz.x);
    const double fy = f((0.2126390059 * r + 0.7151686788 * g + 0.0721923154 * b) / kWhiteXyz.y);
    const double fz = f((0.0193308187 * r + 0.1191947798 * g + 0.9505321522 * b) / kWhiteXyz.z);
    const double lightness = 116 * fy - 16;
    return {lightness, 0.01 * lightness * 500 * (fx - fy), 0.01 * lightness * 200 * (fy - fz)};
}

double hyab(Vec a, Vec b) { return std::pow(std::fabs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z), 0.7); }

template <typename Weight, typename Value>
double filteredAt(const LdrImage& image, int x, int y, int reach, Weight&& weight, Value&& value) {
    double sum = 0;
    for (int j = -reach; j <= reach; ++j) {
        for (int i = -reach; i <= reach; ++i) {
            const int u = std::clamp(x + i, 0, image.width - 1), v = std::clamp(y + j, 0, image.height - 1);
            sum += weight(i, j) * value(image.at(u, v));
        }
    }
    return sum;
}

/// Weights of a sum of Gaussians a * sqrt(pi / b) * exp(-pi^2 d^2 / b), with the sum 1.
class Contrast {
  public:
    Contrast(double a1, double b1, double a2, double b2, double density)
        : a1_(a1), b1_(b1), a2_(a2), b2_(b2), density_(density) {
        for (int j = -kReach; j <= kReach; ++j) {
            for (int i = -kReach; i <= kReach; ++i) sum_ += raw(i, j);
        }
    }
    double operator()(int i, int j) const { return raw(i, j) / sum_; }
    static constexpr int kReach = 10; // at 67 pixels a degree

  private:
    double raw(int i, int j) const {
        const double pi = std::numbers::pi, d2 = (i * i + j * j) / (density_ * density_);
        return a1_ * std::sqrt(pi / b1_) * std::exp(-pi * pi * d2 / b1_) +
               a2_ * std::sqrt(pi / b2_) * std::exp(-pi * pi * d2 / b2_);
    }
    double a1_, b1_, a2_, b2_, density_, sum_ = 0;
};

struct Features {
    double edge = 0, point = 0;
};
Features featuresAt(const LdrImage& image, int x, int y, double density) {
    const double s = 0.5 * 0.082 * density;
    const int reach = static_cast<int>(std::ceil(3 * s));
    const auto strength = [&](auto&& derivative) {
        double above = 0;
        for (int j = -reach; j <= reach; ++j) {
            for (int i = -reach; i <= reach; ++i) above += std::max(0.0, derivative(i, j));
        }
        double below = 0;
        for (int j = -reach; j <= reach; ++j) {
            for (int i = -reach; i <= reach; ++i) below -= std::min(0.0, derivative(i, j));
        }
        const auto weight = [&](double w) { return w > 0 ? w / above : w / below; };
        const auto luminance = [](Rgba8 p) { return (opponent(p).x + 16) / 116; };
        const double across = filteredAt(
            image, x, y, reach, [&](int i, int j) { return weight(derivative(i, j)); }, luminance);
        const double down = filteredAt(
            image, x, y, reach, [&](int i, int j) { return weight(derivative(j, i)); }, luminance);
        return std::hypot(across, down);
    };
    const auto bell = [&](int i, int j) { return std::exp(-(i * i + j * j) / (2 * s * s)); };
    return {strength([&](int i, int j) { return -i * bell(i, j); }),
            strength([&](int i, int j) { return (i * i / (s * s) - 1) * bell(i, j); })};
}

double flipAt(const LdrImage& reference, const LdrImage& image, int x, int y) {
    const double density = static_cast<double>(Flip::kPixelsPerDegree);
    const Contrast achromatic(1, 0.0047, 0, 1e-5, density), redGreen(1, 0.0053, 0, 1e-5, density),
        blueYellow(34.1, 0.04, 13.5, 0.025, density);
    const auto seen = [&](const LdrImage& from) {
        const auto channel = [&](const Contrast& contrast, double Vec::*part) {
            return filteredAt(from, x, y, Contrast::kReach, contrast,
                              [&](Rgba8 p) { return opponent(p).*part; });
        };
        return huntLab(
            {channel(achromatic, &Vec::x), channel(redGreen, &Vec::y), channel(blueYellow, &Vec::z)});
    };
    const double largest = hyab(huntLab(opponent(kGreen)), huntLab(opponent(kBlue)));
    const double difference = hyab(seen(reference), seen(image)), bend = 0.4 * largest;
    const double colour =
        difference < bend ? 0.95 * difference / bend : 0.95 + 0.05 * (difference - bend) / (largest - bend);
    const Features a = featuresAt(reference, x, y, density), b = featuresAt(image, x, y, density);
    const double feature = std::max(std::fabs(a.edge - b.edge), std::fabs(a.point - b.point));
    return std::pow(colour, 1 - std::sqrt(feature / std::numbers::sqrt2));
}

// --- Tests ---

TEST(Flip, OfAnImageWithItselfIsZero) {
    const LdrImage image = noise(40, 30, 1);
    EXPECT_EQ(Flip(image).mean(image), 0);
}

TEST(Flip, TheLargestDifferenceOfColourIsTheAuthors) {
    EXPECT_NEAR(static_cast<double>(Flip::largestColourDifference()), 41.2760963, 1e-3);
}

TEST(Flip, OfUniformImagesIsThatOfTheirColours) {
    EXPECT_NEAR(Flip(uniform(kGreen)).mean(uniform(kBlue)), 1, 1e-4);
    const double bend = 0.4 * 41.2760963, difference = std::pow(100, 0.7);
    EXPECT_NEAR(Flip(uniform(kBlack)).mean(uniform(kWhite)),
                0.95 + 0.05 * (difference - bend) / (41.2760963 - bend), 1e-4);
    EXPECT_NEAR(Flip(uniform(kWhite)).mean(uniform(kBlack)), Flip(uniform(kBlack)).mean(uniform(kWhite)),
                1e-6);
}

TEST(Flip, OfAnyImagesIsWhatThePapersFormulasGive) {
    const LdrImage reference = noise(33, 29, 2);
    LdrImage image = noise(33, 29, 3);
    for (int y = 0; y < image.height; ++y) { // one half is nearly the same
        for (int x = 0; x < 16; ++x) {
            image.at(x, y) = reference.at(x, y);
            image.at(x, y).r = static_cast<std::uint8_t>(image.at(x, y).r / 2);
        }
    }
    const std::vector<float> errors = Flip(reference).errors(image);
    for (int y = 0; y < image.height; y += 4) {
        for (int x = 0; x < image.width; x += 4) {
            const float error = errors[static_cast<std::size_t>(y * image.width + x)];
            EXPECT_NEAR(static_cast<double>(error), flipAt(reference, image, x, y), 1e-3) << x << ' ' << y;
        }
    }
}

} // namespace
