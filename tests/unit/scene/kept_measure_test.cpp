#include "rtcore/scene/kept_measure.h"

#include <gtest/gtest.h>

namespace {

using rtcore::KeptMeasure;
using rtcore::KeptMeasures;
using rtcore::LengthUnit;
using rtcore::MeasureKind;

KeptMeasure chain() { return {.kind = MeasureKind::Chain, .points = {{0, 0, 0}, {3, 4, 0}, {3, 4, 2}}}; }

TEST(KeptMeasure, HasAValueInTheUnitOfTheLabels) {
    const KeptMeasures cm{.all = {}, .unit = LengthUnit::Centimetre, .decimals = 1};
    const KeptMeasure area{
        .kind = MeasureKind::Area, .points = {{0, 0, 0}}, .normal = {0, 1, 0}, .amount = 2};
    KeptMeasure volume = area;
    volume.kind = MeasureKind::Volume;
    EXPECT_EQ(textOf(valueOf(chain(), cm, 0.001), cm.unit), "0.7 cm");
    EXPECT_EQ(textOf(valueOf(area, cm, 1), cm.unit), "20000.0 cm2");
    EXPECT_EQ(textOf(valueOf(volume, cm, 0.1), cm.unit), "2000.0 cm3");
    const KeptMeasures inches{.all = {}, .unit = LengthUnit::Inch, .decimals = 2};
    EXPECT_EQ(textOf(valueOf(chain(), inches, 0.0254), inches.unit), "7.00 in");
    const KeptMeasure angle{.kind = MeasureKind::Angle, .points = {{1, 0, 0}, {0, 0, 0}, {1, 1, 0}}};
    EXPECT_EQ(textOf(valueOf(angle, inches, 7), inches.unit), "45.0 degrees");
}

TEST(KeptMeasure, HasLegsWhereItIsAChain) {
    const KeptMeasures metres;
    const auto legs = legsOf(chain(), metres, 2);
    ASSERT_EQ(legs.size(), 2U);
    EXPECT_EQ(legs[0].value, 10);
    EXPECT_EQ(legs[1].value, 4);
    EXPECT_TRUE(rtcore::legsOf(KeptMeasure{.points = {{0, 0, 0}, {1, 0, 0}}}, metres, 1).empty());
}

TEST(KeptMeasure, IsLabelledInItsMiddleOrAtItsEnd) {
    EXPECT_EQ(rtcore::labelPoint(KeptMeasure{.points = {{0, 0, 0}, {1, 2, 0}}}), (rtcore::Vec3d{0.5, 1, 0}));
    EXPECT_EQ(labelPoint(chain()), (rtcore::Vec3d{3, 4, 2}));
}

TEST(KeptMeasure, IsRefusedWithWhatItLacks) {
    EXPECT_FALSE(problemOf(chain()));
    KeptMeasure bad = chain();
    bad.points.resize(rtcore::kMaxChainPoints + 1);
    EXPECT_TRUE(problemOf(bad));
    bad = chain();
    bad.points[1].y = std::nan("");
    EXPECT_TRUE(problemOf(bad));
    bad = chain();
    bad.name = "\xFF";
    EXPECT_TRUE(problemOf(bad));
    bad.name = std::string(rtcore::kMaxMeasureName, 'n');
    EXPECT_FALSE(problemOf(bad));
    EXPECT_TRUE(
        rtcore::problemOf(KeptMeasure{.kind = MeasureKind::Volume, .points = {{0, 0, 0}}, .amount = 1}));
    EXPECT_TRUE(
        rtcore::problemOf(KeptMeasure{.kind = MeasureKind::Area, .points = {{0, 0, 0}}, .amount = 1}));
}

} // namespace
