/// Where images show points, lines and areas, and where hands lead points.
#include "gui/models/scene_image.h"

#include <gtest/gtest.h>

#include <numbers>

namespace gui {
namespace {

using rtcore::Vec3d;

View perspective() {
    View view;
    view.fieldOfView = 90;
    return view;
}

View parallel() {
    View view;
    view.parallelWidth = 4;
    return view;
}

/// 200 x 100 pixels.
SceneImage imageOf(const View& view) {
    return {view, static_cast<double>(view.parallelWidth), QRectF(0, 0, 200, 100), 2};
}

TEST(SceneImageTest, ShowsPointsWithPerspectiveAndWithout) {
    const QRectF area(0, 0, 200, 100);
    const SceneImage image(perspective(), 0, area, 2);
    EXPECT_EQ(image.at({0, 0, -1}), QPointF(100, 50));
    const auto right = image.at({1, 0.5, -2});
    ASSERT_TRUE(right);
    EXPECT_NEAR(right->x(), 150, 1e-9);
    EXPECT_NEAR(right->y(), 25, 1e-9);
    EXPECT_FALSE(image.at({0, 0, 1})) << "behind the eye";
    View flat;
    flat.fieldOfView = 0;
    const SceneImage parallel(flat, 4, area, 2);
    const auto far = parallel.at({1, 0.5, -1000});
    ASSERT_TRUE(far);
    EXPECT_NEAR(far->x(), 150, 1e-9);
    EXPECT_NEAR(far->y(), 25, 1e-9);
}

TEST(SceneImageTest, GoesWithAStretchedImage) {
    const SceneImage image(perspective(), 0, QRectF(0, 0, 200, 400), 2);
    const auto at = image.at({1, 0.5, -2});
    ASSERT_TRUE(at);
    EXPECT_NEAR(at->x(), 150, 1e-9);
    EXPECT_NEAR(at->y(), 100, 1e-9);
}

TEST(SceneImageTest, ClipsLinesBeforeTheEyeAndAtTheEdges) {
    const QRectF area(0, 0, 200, 100);
    const SceneImage image(perspective(), 0, area, 2);
    const auto line = image.line({0.5, 0, -1}, {0.5, 0, 9});
    ASSERT_TRUE(line) << "it goes on behind the eye";
    EXPECT_NEAR(line->p1().x(), 150, 1e-9);
    EXPECT_LE(line->p2().x(), 220 + 1e-9);
    EXPECT_FALSE(image.line({0.5, 0, 1}, {0.5, 0, 9}));
    EXPECT_FALSE(image.line({5, 0, -1}, {5, 1, -1})) << "beside the image";
}

TEST(SceneImageTest, LeavesWhatSectionsLeave) {
    rtcore::SectionPlanes sections;
    sections.planes = {{{0, 1, 0}, {0, 2, 0}}};
    const auto part = leftOf(sections, {0, 0, 0}, {0, 4, 0}, 0);
    ASSERT_TRUE(part);
    EXPECT_EQ(part->second, (Vec3d{0, 1, 0}));
    EXPECT_FALSE(leftOf(sections, {0, 2, 0}, {1, 3, 0}, 0.1));
    EXPECT_TRUE(leftOf(sections, {0, 1, 0}, {1, 1, 0}, 0.1)) << "in the plane";
}

TEST(SceneImageTest, FindsWhatIsFarAwayAndRays) {
    const SceneImage in = imageOf(perspective());
    EXPECT_EQ(in.farAway({0, 0, -1}), QPointF(100, 50));
    EXPECT_NEAR(in.farAway({0.5, 0, -1})->x(), 150, 1e-9);
    EXPECT_FALSE(in.farAway({0, 1, 0.1}));
    EXPECT_LT(length(in.ray({200, 50}) - normalize(Vec3d{1, 0, -1})), 1e-12);
    EXPECT_LT(length(in.towardsEye({0, 0, -4}) - Vec3d{0, 0, 1}), 1e-12);
    EXPECT_NEAR(in.unitsPerPixel({0, 0, -9}), 0.09, 1e-12);
}

TEST(SceneImageTest, ShowsNothingFarAwayWithoutPerspective) {
    const SceneImage in = imageOf(parallel());
    EXPECT_NEAR(in.unitsPerPixel({0, 0, -9}), 0.02, 1e-12);
    EXPECT_FALSE(in.at({0, 0, 1}));
    EXPECT_FALSE(in.farAway({0.1, 0, -1})) << "only what lies straight ahead is seen, and everywhere";
    EXPECT_EQ(in.ray({200, 50}), (Vec3d{0, 0, -1}));
}

void movePoints(const SceneImage& in) {
    const Vec3d point{0.3, 0.2, -4};
    const QPointF from = *in.at(point), to = from + QPointF(20, -10);
    const Vec3d inPlane = in.movedInPlane(point, from, to);
    EXPECT_NEAR(inPlane.z, -4, 1e-12);
    EXPECT_NEAR(in.at(inPlane)->x(), to.x(), 1e-9);
    EXPECT_NEAR(in.at(inPlane)->y(), to.y(), 1e-9);
    for (const Vec3d& axis : {Vec3d{1, 0, 0}, normalize(Vec3d{1, 1, -2})})
        EXPECT_NEAR(in.distanceAlong(point, axis, from, *in.at(point + axis * 0.7)), 0.7, 1e-9);
    const QPointF middle = *in.at({0, 0, -4});
    EXPECT_EQ(in.distanceAlong({0, 0, -4}, {0, 0, 1}, middle, middle + QPointF(20, 0)), 0)
        << "it points at the eye";
}

TEST(SceneImageTest, MovesPointsAsAHandGoes) {
    movePoints(imageOf(perspective()));
    movePoints(imageOf(parallel()));
    movePoints({perspective(), 0, QRectF(10, 20, 200, 300), 2}); // stretched
}

TEST(SceneImageTest, ClipsAreasToWhatIsSeen) {
    for (const View& view : {perspective(), parallel()}) {
        const SceneImage in = imageOf(view);
        const SpacePolygon floor = squareAround({0, -0.5, 0}, {0, 1, 0}, 100);
        const SpacePolygon seen = in.seen(floor, 0.9);
        ASSERT_GE(seen.size(), 3U);
        for (const Vec3d& corner : seen) {
            const auto at = in.at(corner);
            ASSERT_TRUE(at) << "before the eye";
            EXPECT_TRUE(QRectF(9.9, 4.9, 180.2, 90.2).contains(*at)) << at->x() << " " << at->y();
        }
        EXPECT_TRUE(in.seen(squareAround({0, 0, 5}, {0, 1, 0}, 2), 1).empty()) << "behind the eye";
        EXPECT_TRUE(in.seen(squareAround({500, 0, -5}, {0, 1, 0}, 2), 1).empty()) << "beside the image";
    }
}

TEST(SpacePolygonTest, IsClippedAndHasAMiddle) {
    const SpacePolygon square = squareAround({1, 2, 3}, {0, 0, 1}, 2);
    EXPECT_LT(length(centroidOf(square) - Vec3d{1, 2, 3}), 1e-12);
    const SpacePolygon half = clipped(square, {2, 0, 0}, 2);
    ASSERT_EQ(half.size(), 4U);
    EXPECT_LT(length(centroidOf(half) - Vec3d{0, 2, 3}), 1e-12);
    EXPECT_EQ(clipped(square, {0, 0, 1}, 3), square) << "in the plane";
    EXPECT_TRUE(clipped(square, {0, 0, 1}, 2.9).empty());
    EXPECT_EQ(centroidOf({{4, 0, 0}, {4, 0, 2}}), (Vec3d{4, 0, 1}));
    const double side = std::numbers::sqrt2;
    for (const Vec3d& corner : squareAround({0, 0, 0}, normalize(Vec3d{1, 1, 0}), 1)) {
        EXPECT_NEAR(corner.x + corner.y, 0, 1e-12);
        EXPECT_NEAR(length(corner), side, 1e-12);
    }
}

} // namespace
} // namespace gui
