// Commands that cut the model open: what they tell, what is seen then, that they are taken back, and that a
// scene that is written shows the same.
#include "command_room.h"

#include "rtserver/document/exports.h"

#include <gtest/gtest.h>

#include <string>

namespace rtserver {
namespace {

using rtcore::Vec3;

class SectionCommands : public test::CommandRoom {
  protected:
    const rtcore::SectionPlanes& sections() const { return document.scene()->sections; }
    /// Of what the camera sees in the middle.
    float distance() const {
        rtcore::RayWave ray;
        rtcore::HitWave hit;
        ray.push({document.camera().eye, 0, normalize(document.camera().forward), 1e6F});
        document.tracer()->intersect(rtcore::RayKind::Primary, ray, hit);
        return hit.isHit(0) ? hit.t[0] : -1;
    }
};

TEST_F(SectionCommands, AreToldAndEdited) {
    const std::string style = "\ncaps own\ncolour 0.1 0.1 0.1\nhatching off",
                      open = "\nopen ''"; // the room, which is not closed and has no name
    EXPECT_EQ(answer("sections"), "light whole" + style);
    answer("section add 0 1.5 0 0 2 0");
    answer("section add 1 0 0 1 0 0");
    EXPECT_EQ(answer("sections"), "1 0 1.5 0 0 2 0\n2 1 0 0 1 0 0\nlight whole" + style + open);
    answer("section move 1 -0.5");
    answer("section turn 2");
    answer("section light cut");
    EXPECT_EQ(answer("sections"), "1 0 1 0 0 2 0\n2 1 0 0 -1 0 0\nlight cut" + style + open);
    answer("section remove 1");
    EXPECT_EQ(answer("sections"), "1 1 0 0 -1 0 0\nlight cut" + style + open);
    answer("section box 1 2 3 -1 -2 -3");
    EXPECT_EQ(sections().planes.size(), 6U);
    EXPECT_EQ(sections().planes[0].point, (Vec3{1, 2, 3}));
    answer("section clear");
    EXPECT_EQ(answer("sections"), "light cut" + style);
    answer("section caps one");
    answer("section colour 1 0.5 0");
    answer("section hatching on");
    answer("section add 0 0 0 0 1 0");
    EXPECT_EQ(sections().caps, (rtcore::CapStyle{rtcore::CapColours::One, {1, 0.5F, 0}, true})) << "it stays";
    answer("section clear");
    EXPECT_EQ(answer("sections"), "light cut\ncaps one\ncolour 1 0.5 0\nhatching on");
    answer("undo");
    answer("undo");
    answer("undo");
    EXPECT_FALSE(sections().caps.hatched);
}

TEST_F(SectionCommands, LeavePartsWhole) {
    answer("section add 0 0.5 0 0 1 0");
    answer("section leave box");
    const std::string all = answer("sections");
    EXPECT_EQ(all.substr(all.find("hatching")), "hatching off\nuncut 'box'");
    EXPECT_EQ(document.scene()->sections.planes.size(), 1U);
    const rtcore::SceneFile file = sceneFileOf(document);
    ASSERT_EQ(file.parts.size(), 1U);
    EXPECT_EQ(file.parts[0], (rtcore::PartDescription{"*", {}, {}, true}));
    answer("undo");
    EXPECT_EQ(answer("sections").find("uncut"), std::string::npos);
    answer("redo");
    answer("section cut 1");
    EXPECT_EQ(document.scene()->uncutParts, nullptr);
    EXPECT_EQ(refusal("section leave roof").code, 2);
}

TEST_F(SectionCommands, GoThroughTheMiddleAndThroughAPoint) {
    answer("section through y");
    answer("section through -x");
    ASSERT_EQ(sections().planes.size(), 2U);
    EXPECT_EQ(sections().planes[0].normal, (Vec3{0, 1, 0}));
    EXPECT_FLOAT_EQ(sections().planes[0].point.y, 0.5F);
    EXPECT_EQ(sections().planes[1].normal, (Vec3{-1, 0, 0}));
    EXPECT_FLOAT_EQ(sections().planes[1].point.x, 0);
    EXPECT_EQ(document.history().last()->label, "section through");
    answer("section at 2 0.25 0 0");
    answer("also section at 2 0.5 0 0");
    EXPECT_EQ(sections().planes[1], (rtcore::SectionPlane{{0.5F, 0, 0}, {-1, 0, 0}}));
    EXPECT_EQ(document.history().last()->label, "section at 2");
    answer("undo");
    EXPECT_FLOAT_EQ(sections().planes[1].point.x, 0) << "one step";
}

TEST_F(SectionCommands, TurnAPlaneInOneStep) {
    answer("section through y");
    answer("section through x");
    answer("section plane 1 0 0.25 -1 0 1 1");
    answer("also section plane 1 0 0.25 -1 0 1 2");
    EXPECT_EQ(sections().planes[0], (rtcore::SectionPlane{{0, 0.25F, -1}, {0, 1, 2}}));
    EXPECT_EQ(sections().planes[1].normal, (Vec3{1, 0, 0})) << "the other stays";
    EXPECT_EQ(document.history().last()->label, "section plane 1");
    answer("undo");
    EXPECT_EQ(sections().planes[0].normal, (Vec3{0, 1, 0})) << "one step";
    EXPECT_EQ(refusal("section plane 1 0 0 0 0 0 0").code, 2);
    EXPECT_EQ(refusal("section plane 1 0 1e20 0 0 1 0").code, 2);
    EXPECT_EQ(refusal("section plane 1 0 0 0 0 1").code, 2);
    EXPECT_EQ(sections().planes[0].normal, (Vec3{0, 1, 0})) << "what is refused changes nothing";
}

TEST_F(SectionCommands, ThatCannotBeAreRefused) {
    EXPECT_EQ(refusal("section add 0 0 0 0 0 0").code, 2);
    EXPECT_EQ(refusal("section add 0 0 0 0 1").code, 2);
    EXPECT_EQ(refusal("section add 1e20 0 0 0 1 0").code, 2);
    EXPECT_EQ(refusal("section box 0 0 0 1 1 1e20").code, 2);
    EXPECT_EQ(refusal("section move 1 2").code, 1);
    EXPECT_EQ(refusal("section box 0 0 0 1 1 0").code, 2);
    EXPECT_EQ(refusal("section light some").code, 2);
    EXPECT_EQ(refusal("section caps some").code, 2);
    EXPECT_EQ(refusal("section colour 1 2 0").code, 2);
    answer("section box 0 0 0 1 1 1");
    EXPECT_EQ(refusal("section move 1 1e20").code, 2);
    EXPECT_EQ(refusal("section at 1 1e20 0 0").code, 2);
    EXPECT_EQ(refusal("section through y").code, refusal("section add 0 0 0 0 1 0").code);
    EXPECT_NE(refusal("section add 0 0 0 0 1 0").code, 0);
    EXPECT_EQ(sections().planes.size(), 6U);
}

TEST_F(SectionCommands, AreSeenAndTakenBack) {
    answer("camera look-at 0 2 3 0 0 0");
    const float before = distance();
    ASSERT_GT(before, 0);
    answer("section here 0.5 0.5");
    EXPECT_NEAR(distance(), before, 1e-3F) << "the face stays";
    EXPECT_EQ(document.history().last()->label, "section here");
    answer("section move 1 -0.01");
    EXPECT_TRUE(distance() < 0 || distance() > before + 0.005F) << distance();
    answer("undo");
    EXPECT_NEAR(distance(), before, 1e-3F);
    answer("undo");
    EXPECT_TRUE(sections().empty());
    EXPECT_EQ(distance(), before);
    answer("redo");
    EXPECT_EQ(sections().planes.size(), 1U);
}

TEST_F(SectionCommands, AreEditsOfTheirKind) {
    changes();
    answer("section add 0 1.5 0 0 1 0");
    EXPECT_EQ(changes(), rtcore::Changes{rtcore::Change::Section});
}

} // namespace
} // namespace rtserver
