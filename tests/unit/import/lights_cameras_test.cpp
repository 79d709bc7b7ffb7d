#include "gltf_text.h"
#include "import_support.h"

#include <gtest/gtest.h>

namespace {

using namespace rtcore;
using test::near;

constexpr float kPi = 3.14159265F;

ImportedModel gltf(const std::string& nodes, const std::string& roots, const std::string& more) {
    test::GltfScene scene;
    scene.nodes = R"({"mesh":0},)" + nodes;
    scene.roots = "0," + roots;
    scene.more = more;
    return test::importText("m.gltf", scene.text());
}

TEST(GltfLights, AreInCandelaAndLuxWhereTheirNodesAre) {
    const ImportedModel m = gltf(
        R"({"translation":[1,2,3],"scale":[2,2,2],"children":[2]},)"
        R"({"name":"lamp","translation":[1,0,0],"extensions":{"KHR_lights_punctual":{"light":0}}},)"
        R"({"name":"spot","rotation":[0,0.70710678,0,0.70710678],"extensions":{"KHR_lights_punctual":{"light":1}}},)"
        R"({"name":"sun","extensions":{"KHR_lights_punctual":{"light":2}}})",
        "1,3,4",
        R"(,"extensionsUsed":["KHR_lights_punctual"],"extensions":{"KHR_lights_punctual":{"lights":[)"
        R"({"type":"point","color":[1,0.5,0.25],"intensity":40},)"
        R"({"type":"spot","intensity":10,"spot":{"innerConeAngle":0.2,"outerConeAngle":0.5}},)"
        R"({"type":"directional","intensity":3}]}})");
    ASSERT_EQ(m.model.lights.size(), 3U);
    const Light point = m.model.lights[0], spot = m.model.lights[1], sun = m.model.lights[2];
    EXPECT_EQ(point.kind, LightKind::Point);
    EXPECT_EQ(m.model.name(point.nameOffset), "lamp");
    EXPECT_TRUE(near(point.position, {3, 2, 3}));
    EXPECT_TRUE(near(point.intensity, {40, 20, 10}));
    EXPECT_EQ(spot.kind, LightKind::Spot);
    EXPECT_TRUE(near(spot.direction, {-1, 0, 0}));
    EXPECT_NEAR(spot.cosInner, std::cos(0.2F), 1e-5F);
    EXPECT_NEAR(spot.cosOuter, std::cos(0.5F), 1e-5F);
    EXPECT_TRUE(near(spot.intensity, {10, 10, 10}));
    EXPECT_EQ(sun.kind, LightKind::Directional);
    EXPECT_TRUE(near(sun.direction, {0, 0, -1}));
    EXPECT_TRUE(near(sun.intensity, {3, 3, 3}));
}

TEST(GltfCameras, LookAlongMinusZOfTheirNodes) {
    const ImportedModel m = gltf(
        R"({"name":"a","camera":0,"translation":[0,0,5]},{"name":"b","camera":1,"rotation":[0,0.70710678,0,0.70710678]})",
        "1,2",
        R"(,"cameras":[{"type":"perspective","perspective":{"yfov":0.7,"aspectRatio":1.5,"znear":0.1}},)"
        R"({"type":"perspective","perspective":{"yfov":0.7,"znear":0.1}}])");
    ASSERT_EQ(m.model.cameras.size(), 2U);
    const Camera a = m.model.cameras[0], b = m.model.cameras[1];
    EXPECT_EQ(m.model.name(a.nameOffset), "a");
    EXPECT_TRUE(near(a.eye, {0, 0, 5}));
    EXPECT_TRUE(near(a.forward, {0, 0, -1}));
    EXPECT_TRUE(near(a.up, {0, 1, 0}));
    EXPECT_NEAR(a.horizontalFov, 2 * std::atan(1.5F * std::tan(0.35F)) * 180 / kPi, 1e-3F);
    EXPECT_TRUE(near(b.forward, {-1, 0, 0}));
    EXPECT_NEAR(b.horizontalFov, 2 * std::atan(b.aspect * std::tan(0.35F)) * 180 / kPi, 1e-3F);
    EXPECT_LT(b.aspect, 0.2F) << "the angle is that of all wider images";
}

std::string collada(const std::string& libraries, const std::string& nodes) {
    return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>Y_UP</up_axis></asset>)" +
           libraries +
           R"(<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="pa" count="9">-1 0 -1 1 0 -1 0 0 1</float_array><technique_common>
<accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="a"><instance_geometry url="#g"/></node>)" +
           nodes +
           R"(</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

TEST(ColladaLights, GiveTheirColourInTheMiddleOfTheModel) {
    const ImportedModel m = test::importText(
        "m.dae",
        collada(R"(<library_lights><light id="l" name="l"><technique_common><point><color>0.5 1 1</color>
<constant_attenuation>1</constant_attenuation></point></technique_common></light>
<light id="q" name="q"><technique_common><point><color>1 1 1</color><constant_attenuation>0</constant_attenuation>
<quadratic_attenuation>0.25</quadratic_attenuation></point></technique_common></light>
<light id="s" name="s"><technique_common><spot><color>1 1 1</color><falloff_angle>60</falloff_angle></spot></technique_common></light>
<light id="d" name="d"><technique_common><directional><color>1 1 1</color></directional></technique_common></light></library_lights>)",
                R"(<node id="n1" name="n1"><translate>0 3 0</translate><instance_light url="#l"/></node>
<node id="n2" name="n2"><translate>0 3 0</translate><instance_light url="#q"/></node>
<node id="n3" name="n3"><rotate>1 0 0 -90</rotate><instance_light url="#s"/></node>
<node id="n4" name="n4"><rotate>1 0 0 -90</rotate><instance_light url="#d"/></node>)"));
    ASSERT_EQ(m.model.lights.size(), 4U);
    const Light constant = m.model.lights[0];
    EXPECT_TRUE(near(constant.position, {0, 3, 0}));
    // Irradiance at distance 3 is pi times the colour: a white Lambert surface there looks as the colour
    // says.
    EXPECT_TRUE(near(constant.intensity, {0.5F * kPi * 9, kPi * 9, kPi * 9}, 1e-3F));
    EXPECT_NEAR(m.model.lights[1].intensity.r, kPi / 0.25F, 1e-3F) << "quadratic: pi / q at any distance";
    EXPECT_EQ(m.model.lights[2].kind, LightKind::Spot);
    EXPECT_NEAR(m.model.lights[2].cosOuter, std::cos(kPi / 6), 1e-4F) << "60 degrees is the whole cone";
    EXPECT_TRUE(near(m.model.lights[2].direction, {0, -1, 0}));
    EXPECT_TRUE(near(m.model.lights[3].direction, {0, -1, 0}));
    EXPECT_TRUE(near(m.model.lights[3].intensity, {kPi, kPi, kPi}));
}

TEST(ColladaCameras, HaveTheHorizontalAngleOfTheFile) {
    const ImportedModel m = test::importText(
        "m.dae",
        collada(
            R"(<library_cameras><camera id="c" name="c"><optics><technique_common><perspective><xfov>49</xfov>
<aspect_ratio>1.5</aspect_ratio><znear>0.1</znear><zfar>100</zfar></perspective></technique_common></optics></camera></library_cameras>)",
            R"(<node id="n" name="n"><translate>1 2 3</translate><rotate>0 1 0 90</rotate><instance_camera url="#c"/></node>)"));
    ASSERT_EQ(m.model.cameras.size(), 1U);
    const Camera c = m.model.cameras[0];
    EXPECT_NEAR(c.horizontalFov, 49, 1e-3F);
    EXPECT_TRUE(near(c.eye, {1, 2, 3}));
    EXPECT_TRUE(near(c.forward, {-1, 0, 0}));
}

TEST(Lights, OfOtherKindsAreLeftOutWithAWarning) {
    const ImportedModel m = test::importText(
        "m.dae",
        collada(R"(<library_lights><light id="l" name="glow"><technique_common><ambient><color>1 1 1</color>
</ambient></technique_common></light></library_lights>)",
                R"(<node id="n1" name="n1"><instance_light url="#l"/></node>)"));
    EXPECT_TRUE(m.model.lights.empty());
    ASSERT_EQ(m.report.warnings.size(), 1U);
    EXPECT_NE(m.report.warnings[0].english().find("left out"), std::string::npos);
}

} // namespace
