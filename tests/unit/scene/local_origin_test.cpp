#include "rtcore/scene/local_origin.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace rtcore;

constexpr double kFine = 1e-6;

FileBounds boundsOf(FilePoint lo, FilePoint hi) {
    FileBounds bounds;
    bounds.extend(lo);
    bounds.extend(hi);
    return bounds;
}

TEST(LocalOrigin, NearZeroThereIsNone) {
    EXPECT_TRUE(originOf(FileBounds(), kFine).isZero());
    EXPECT_TRUE(originOf(boundsOf({-5, -5, -5}, {5, 5, 5}), kFine).isZero());
    // Spacing at 80 is 7.6e-6, below a millionth of 10; at 100 the same; at 130 it is above.
    EXPECT_TRUE(originOf(boundsOf({90, 0, 0}, {100, 5, 5}), kFine).isZero());
    EXPECT_EQ(originOf(boundsOf({120, 0, 0}, {130, 5, 5}), kFine).at, (FilePoint{125, 3, 3}));
}

TEST(LocalOrigin, IsTheMiddleInWholeUnits) {
    const FileBounds house = boundsOf({458208.25, 5428760.5, 311.5}, {458218.25, 5428769.5, 318});
    EXPECT_EQ(originOf(house, kFine).at, (FilePoint{458213, 5428765, 315}));
    const FileBounds part = boundsOf({0.70213, 0, 0}, {0.70233, 0.0001, 0.0001});
    const LocalOrigin origin = originOf(part, kFine);
    EXPECT_NEAR(origin.at[0], 0.7022, 1e-12);
    EXPECT_NEAR(origin.at[1], 0.0001, 1e-12);
}

TEST(LocalOrigin, NothingThatIsNoPositionHasOne) {
    const double infinite = std::numeric_limits<double>::infinity(), none = std::nan("");
    EXPECT_TRUE(originOf(boundsOf({none, 0, 0}, {infinite, 0, 0}), kFine).isZero());
    EXPECT_TRUE(originOf(boundsOf({9e12, 0, 0}, {9e12 + 10, 1, 1}), kFine).isZero());
    EXPECT_TRUE(originOf(boundsOf({500, 500, 500}, {500, 500, 500}), kFine).isZero());
}

TEST(LocalOrigin, GoesThereAndBack) {
    const LocalOrigin origin{{458213, 5428765, 315}};
    for (const float x : {0.0F, 1.25F, -3.7F, 0.031F, 9.999999F}) {
        const Vec3 p{x, -x, 2 * x};
        EXPECT_EQ(origin.local(origin.inFile(p)), p);
    }
    EXPECT_EQ(origin.local({458213.1, 5428764.9, 315}), (Vec3{0.1F, -0.1F, 0}));
    EXPECT_EQ(LocalOrigin().local({0.1, 0.2, 0.3}), (Vec3{0.1F, 0.2F, 0.3F}));
    EXPECT_EQ(LocalOrigin().local({1e300, -1e300, 0}).x, std::numeric_limits<float>::infinity());
}

TEST(LocalOrigin, FloatsAreCoarseFarAway) {
    EXPECT_EQ(coarsenessAt(0.75), 0x1p-24);
    EXPECT_EQ(coarsenessAt(5428765), 0.5);
    EXPECT_EQ(coarsenessAt(-5428765), 0.5);
}

} // namespace
