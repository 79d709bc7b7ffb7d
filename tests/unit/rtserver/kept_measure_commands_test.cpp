// Measures that are kept: undone, saved, listed, exported. The room: a floor of 20 x 20, and a box from
// (-0.5, 0, -3) to (0.5, 1, -2).
#include "command_room.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace rtserver {
namespace {

class KeptMeasureCommands : public test::CommandRoom {
  protected:
    void SetUp() override {
        CommandRoom::SetUp();
        answer("units m");
    }
    std::string exported() {
        answer("measure export DIR/m.csv");
        std::ifstream file(folder / "m.csv", std::ios::binary);
        return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    }
};

TEST_F(KeptMeasureCommands, AreListedInTheirUnit) {
    answer("measure keep distance 0 0 0 3 4 0");
    answer("measure keep chain 0 0 0 1 0 0 1 2 0");
    answer("measure name 2 \"by the door\"");
    EXPECT_EQ(answer("measure list"),
              "1 distance 5.000 m 0 0 0, 3 4 0\n2 chain 3.000 m 0 0 0, 1 0 0, 1 2 0 by the door");
    answer("measure unit cm 0");
    EXPECT_EQ(answer("measure list 2"), "2 chain 300 cm 0 0 0, 1 0 0, 1 2 0 by the door");
    EXPECT_EQ(answer("measure list 3"), "");
    answer("units auto");
    EXPECT_NE(answer("measure list").find("\nthe unit is a guess"), std::string::npos);
}

TEST_F(KeptMeasureCommands, AreStepsOfUndo) {
    const std::uint64_t before = document.history().state();
    answer("measure keep distance 0 0 0 3 4 0");
    answer("measure keep distance 0 0 0 1 0 0");
    answer("measure remove 1");
    EXPECT_EQ(answer("measure list"), "1 distance 1.000 m 0 0 0, 1 0 0");
    answer("undo");
    EXPECT_EQ(document.measures().all.size(), 2U);
    answer("undo");
    answer("undo");
    EXPECT_TRUE(document.measures().all.empty());
    EXPECT_EQ(document.history().state(), before);
    answer("redo");
    EXPECT_EQ(answer("measure list"), "1 distance 5.000 m 0 0 0, 3 4 0");
}

TEST_F(KeptMeasureCommands, AreSavedAndSurviveOtherEdits) {
    answer("measure keep angle 1 0 0 0 0 0 0 1 0");
    answer("measure keep volume box");
    answer("measure unit mm 1");
    answer("part hide box");
    answer("material set 1 diffuse 1 0 0");
    answer("save as DIR/m.scn");
    const rtcore::KeptMeasures saved = rtcore::readSceneFile(folder / "m.scn").measures;
    EXPECT_EQ(saved, document.measures());
    ASSERT_EQ(saved.all.size(), 2U);
    EXPECT_EQ(saved.all[1].part, 1);
    EXPECT_NEAR(saved.all[1].amount, 1, 1e-6);
    EXPECT_EQ(saved.decimals, 1);
}

// The box stands between z = -3 and -2, 1 high; the eye is before it.
TEST_F(KeptMeasureCommands, TellWhichPointsAreHidden) {
    answer("camera look-at 0 0.5 3 0 0.5 0");
    EXPECT_EQ(answer("measure hidden"), "");
    answer("measure keep distance 0 0.5 -2 2 0 -2");
    answer("measure keep distance -0.4 0.2 -4 2 0 -4");
    answer("measure keep chain 0 0.5 -3 0 1 -2 0 0 -4");
    answer("measure keep volume box");
    answer("measure keep distance 0 1 9 0 1 8");
    EXPECT_EQ(answer("measure hidden"), "2 1\n3 1 3") << "the face before does not hide its own points";
    answer("camera orthographic 0 0.5 3 0 0 -1 4");
    EXPECT_EQ(answer("measure hidden"), "2 1\n3 1 3");
    answer("camera orthographic 0 9 -2.5 0 -1 0 4");
    EXPECT_EQ(answer("measure hidden"), "1 1\n3 1") << "along the sides of the box";
    answer("camera look-at 0 0.5 -9 0 0.5 0");
    EXPECT_EQ(answer("measure hidden"), "1 1\n3 2\n5 1 2") << "from behind";
}

TEST_F(KeptMeasureCommands, ArePointsThatHiddenPartsAndSectionsLeaveFree) {
    answer("camera look-at 0 0.5 3 0 0.5 0");
    answer("measure keep distance 0 0.5 -4 0.1 0.5 -4");
    EXPECT_EQ(answer("measure hidden"), "1 1 2");
    answer("part hide box");
    EXPECT_EQ(answer("measure hidden"), "");
    answer("part show box");
    EXPECT_EQ(answer("measure hidden"), "1 1 2");
    answer("section add 0 0 -3.5 0 0 1");
    EXPECT_EQ(answer("measure hidden"), "");
}

TEST_F(KeptMeasureCommands, TellTheFaceAndItsArea) {
    answer("camera orthographic 0 0.5 3 0 0 -1 4");
    answer("resolution 400 300");
    answer("measure keep face 0.55 0.53");
    const rtcore::KeptMeasure& face = document.measures().all.at(0);
    EXPECT_EQ(face.kind, rtcore::MeasureKind::Area);
    EXPECT_NEAR(face.amount, 1, 1e-6);
    EXPECT_EQ(face.normal, (rtcore::Vec3{0, 0, 1}));
    EXPECT_NEAR(face.points[0].z, -2, 1e-5);
}

TEST_F(KeptMeasureCommands, AreExportedAsTablesHaveThem) {
    EXPECT_EQ(exported(), "number,kind,name,value,unit,points\r\n");
    answer("measure keep distance 0 0 0 3 4 0");
    answer("measure keep angle 1 0 0 0 0 0 0 1 0");
    answer("measure keep distance 0 0 0 0.1 0 0");
    answer("measure name 1 \"a \\\"b\\\", c\"");
    answer("measure name 3 =1+2");
    answer("measure unit cm 1");
    EXPECT_EQ(exported(), "number,kind,name,value,unit,points\r\n"
                          "1,distance,\"a \"\"b\"\", c\",500,cm,0 0 0; 3 4 0\r\n"
                          "2,angle,,90,degrees,1 0 0; 0 0 0; 0 1 0\r\n"
                          "3,distance,'=1+2,10,cm,0 0 0; 0.1 0 0\r\n");
    for (const char* const name : {"+a", "-a", "@a"}) {
        answer(std::string("measure name 3 ") + name);
        EXPECT_NE(exported().find(std::string(",'") + name + ","), std::string::npos) << name;
    }
}

TEST_F(KeptMeasureCommands, AreAThousandAtMost) {
    rtcore::KeptMeasures many = document.measures();
    many.all.assign(rtcore::kMaxMeasures, {.points = {{0, 0, 0}, {1, 0, 0}}});
    document.setMeasures(many);
    EXPECT_EQ(refusal("measure keep distance 0 0 0 3 4 0").code, 1);
    answer("measure remove 1000");
    answer("measure keep distance 0 0 0 3 4 0");
    EXPECT_EQ(document.measures().all.size(), rtcore::kMaxMeasures);
}

} // namespace
} // namespace rtserver
