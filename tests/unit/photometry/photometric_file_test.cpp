// IES and EULUMDAT files as they are read.
#include "rtcore/io/photometry/photometric_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace {

using rtcore::PhotometricFile;
using rtcore::PhotometricWeb;

PhotometricFile fileOf(const std::string& name) {
    return rtcore::readPhotometricFile(std::string(RT_PHOTOMETRIC_FILES "/") + name);
}

/// At the n-th plane and gamma.
double at(const PhotometricWeb& web, std::size_t plane, std::size_t gamma) {
    return web.candela.at(plane * web.gammas.size() + gamma);
}

TEST(PhotometricFile, OfOnePlaneIsTheSameAllAround) {
    const PhotometricFile file = fileOf("narrow.ies");
    EXPECT_TRUE(file.warnings.empty());
    EXPECT_EQ(file.web.planes, (std::vector<double>{0, 360}));
    EXPECT_EQ(file.web.gammas.size(), 17U);
    EXPECT_EQ(at(file.web, 0, 0), 4020);
    EXPECT_EQ(at(file.web, 1, 3), at(file.web, 0, 3));
}

/// With its multiplier, its factors, and what it includes of tilts.
TEST(PhotometricFile, OfAQuarterIsMirroredTwice) {
    const PhotometricWeb web = fileOf("batwing.ies").web;
    ASSERT_EQ(web.planes.size(), 17U);
    EXPECT_EQ(web.planes.back(), 360);
    const auto expected = [](double gamma, double plane) {
        const double cosine = std::cos(gamma * std::numbers::pi / 180),
                     across = std::cos(plane * std::numbers::pi / 180);
        return 300 * cosine + across * across * 1200 * std::exp(-std::pow((gamma - 35) / 14, 2)) *
                                  std::sin(gamma * std::numbers::pi / 90);
    };
    for (std::size_t plane = 0; plane < web.planes.size(); ++plane)
        for (std::size_t i = 0; i < web.gammas.size(); ++i)
            EXPECT_NEAR(at(web, plane, i), expected(web.gammas[i], web.planes[plane]), 0.01);
}

/// Of light sources of 2400 lm; numbers with a comma, lines with two ends.
TEST(PhotometricFile, OfEulumdatCountsTheLightSourcesAndMirrorsThePlaneOf90) {
    const PhotometricWeb web = fileOf("asymmetric.ldt").web;
    EXPECT_EQ(web.planes.front(), -90);
    EXPECT_EQ(web.planes.back(), 270);
    ASSERT_EQ(web.planes.size(), 13U);
    const std::size_t of90 = 6, of40 = 4;
    EXPECT_EQ(web.planes[of90], 90);
    EXPECT_NEAR(at(web, of90, of40), 400 * 2.4, 0.02);
    for (std::size_t k = 1; k < 6; ++k) EXPECT_EQ(at(web, of90 - k, of40), at(web, of90 + k, of40)) << k;
}

/// Two angles of the axis, and planes that a head of 1991 lists.
std::string iesOf(const std::string& planes, int count, const std::string& candela,
                  const std::string& tilt = "TILT=NONE") {
    return "IESNA91\n" + tilt + "\n1 -1 1 2 " + std::to_string(count) + " 1 1 0 0 0\n1,1,10\n0 90\n" +
           planes + '\n' + candela + '\n';
}
PhotometricWeb webOf(const std::string& text) { return rtcore::parsePhotometricFile(text, "x.ies").web; }

TEST(PhotometricFile, HasItsPlanesWhereverItsAnglesBegin) {
    const PhotometricWeb half = webOf(iesOf("0 90 180", 3, "1 2  3 4  5 6"));
    EXPECT_EQ(half.planes, (std::vector<double>{0, 90, 180, 270, 360}));
    EXPECT_EQ(half.candela, (std::vector<double>{1, 2, 3, 4, 5, 6, 3, 4, 1, 2}));
    const PhotometricWeb back = webOf(iesOf("90 180 270", 3, "1 2  3 4  5 6"));
    EXPECT_EQ(back.planes, (std::vector<double>{90, 180, 270, 360, 450}));
    EXPECT_EQ(back.candela, (std::vector<double>{1, 2, 3, 4, 5, 6, 3, 4, 1, 2}));
    const PhotometricWeb all = webOf(iesOf("0 120 240 360", 4, "1 2 3 4 5 6 1 2"));
    EXPECT_EQ(all.planes, (std::vector<double>{0, 120, 240, 360}));
    const PhotometricWeb open = webOf(iesOf("0 120 240", 3, "1 2 3 4 5 6"));
    EXPECT_EQ(open, all);
}

/// The oldest kind has no line of its own in front; from 2002 on the eleventh number is no factor.
TEST(PhotometricFile, IsOfEachYear) {
    const std::string numbers = "1 1000 2 2 1 1 1 0 0 0\n0.5 0.25 10\n0 180\n0\n100 40\n";
    for (const auto& [labels, factor] :
         {std::pair("Luminaire of a table\n", 0.25), std::pair("IESNA91\n", 0.25), std::pair("", 0.25),
          std::pair("IESNA:LM-63-1995\n", 0.25), std::pair("IESNA:LM-63-2002\n", 1.0),
          std::pair("IES:LM-63-2019\n", 1.0)})
        EXPECT_EQ(webOf(std::string(labels) + "TILT=NONE\n" + numbers).candela.front(), 100 * factor)
            << labels;
}

TEST(PhotometricFile, WarnsOfATiltInAFileOfItsOwn) {
    const PhotometricFile file =
        rtcore::parsePhotometricFile(iesOf("0", 1, "100 50", "TILT=other.tlt"), "x.ies");
    ASSERT_EQ(file.warnings.size(), 1U);
    EXPECT_EQ(file.warnings[0].english(),
              "its tilt is in a file of its own, other.tlt, which does not count");
    EXPECT_EQ(file.web.candela[0], 100);
}

/// Each number of symmetry, with four planes of two angles.
TEST(PhotometricFile, OfEulumdatHasEachSymmetry) {
    const auto planesOf = [](int symmetry, int count) {
        std::string text = "maker\n1\n" + std::to_string(symmetry) + "\n4\n90\n2\n90\n";
        for (int i = 0; i < 5; ++i) text += "name\n";
        for (int i = 0; i < 9; ++i) text += "0\n";
        text += "100\n100\n1\n0\n1\n1\nlamp\n1000\nwhite\ngood\n10\n";
        for (int i = 0; i < 10; ++i) text += "0.5\n";
        text += "0\n90\n180\n270\n0\n90\n";
        for (int i = 0; i < count; ++i) text += std::to_string(10 + i) + "\n1\n";
        const PhotometricWeb web = rtcore::parsePhotometricFile(text, "x.ldt").web;
        std::vector<double> of;
        for (std::size_t i = 0; i < web.planes.size(); ++i) of.push_back(at(web, i, 0));
        return of;
    };
    EXPECT_EQ(planesOf(0, 4), (std::vector<double>{10, 11, 12, 13, 10}));
    EXPECT_EQ(planesOf(1, 1), (std::vector<double>{10, 10}));
    EXPECT_EQ(planesOf(2, 3), (std::vector<double>{10, 11, 12, 11, 10}));
    EXPECT_EQ(planesOf(3, 3), (std::vector<double>{10, 11, 12, 11, 10})); // from 270 on
    EXPECT_EQ(planesOf(4, 2), (std::vector<double>{10, 11, 10, 11, 10}));
}

} // namespace
