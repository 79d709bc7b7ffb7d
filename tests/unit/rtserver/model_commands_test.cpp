// Commands for the materials and parts of a model: what they tell, what they change, that it is taken back,
// and that a scene that is written shows the same.
#include "command_room.h"

#include "rtserver/document/exports.h"

#include "rtcore/io/scene_loader.h"
#include "rtcore/scene/material_numbers.h"
#include "rtcore/scene/material_textures.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace rtserver {
namespace {

using rtcore::Change;
using rtcore::Changes;
using rtcore::Colour;

/// A floor, a box and a sphere, with names; the sphere's material has none.
rtcore::LoadedScene furnished() {
    rtcore::LoadedScene room = test::makeRoom();
    test::SceneBuilder b;
    const auto named = [&](const char* name, float albedo) {
        rtcore::Material m = test::matte(albedo);
        m.nameOffset = b.buffers.addName(name);
        return b.material(m);
    };
    const auto part = [&](const char* name, auto add) {
        const auto first = static_cast<std::uint32_t>(b.buffers.triangles.size());
        add();
        const auto count = static_cast<std::uint32_t>(b.buffers.triangles.size()) - first;
        b.buffers.parts.push_back({b.buffers.addName(name), first, count});
    };
    const std::uint32_t oak = named("oak", 0.5F), steel = named("steel", 0.4F), none = named("", 0.9F);
    part("room/floor", [&] { b.square({0, 0, 0}, {0, 1, 0}, 10, oak); });
    part("room/box", [&] { b.box({-0.5F, 0, -3}, {0.5F, 2, -2}, steel); });
    part("ball", [&] { b.sphere({2, 1, -3}, 1, 6, none); });
    b.scene.lights = room.scene.lights;
    room.scene = b.finish();
    room.tree = rtcore::buildKdTree(room.scene.mesh(), {});
    room.sceneFile.reset();
    return room;
}

class ModelCommands : public test::CommandRoom {
  protected:
    void SetUp() override {
        options.settings.push_back({"exposure.mode", std::string("fixed")});
        document.show(test::worldOf(furnished()));
        changes();
    }
    const rtcore::Material& material(std::size_t index) { return document.scene()->materials.at(index); }
    auto frame() {
        drawFrame();
        return host.maker.image().pixels;
    }
};

TEST_F(ModelCommands, TellWhatTheModelConsistsOf) {
    EXPECT_EQ(answer("parts"), "1 shown 2 room/floor\n2 shown 12 room/box\n3 shown 120 ball");
    EXPECT_EQ(answer("parts 3"), "3 shown 120 ball");
    EXPECT_EQ(answer("parts 4"), "");
    EXPECT_EQ(answer("materials"), "1 - oak\n2 - steel\n3 -");
    EXPECT_EQ(refusal("parts 0").code, 2);
    EXPECT_EQ(answer("seen 0.5 0.5"), "part 2 room/box\nmaterial 2 steel");
    EXPECT_EQ(refusal("seen 0.5 0").text, "nothing of the model is seen there");
    const std::string text = answer("material get steel");
    EXPECT_EQ(text.substr(0, text.find("\nspecular")),
              "[[material]]\nname = \"steel\"\ndiffuse = [0.4, 0.4, 0.4]");
    EXPECT_EQ(text.find("textures"), std::string::npos) << "it has none";
    for (const rtcore::MaterialNumber& number : rtcore::kMaterialNumbers)
        EXPECT_NE(text.find(fmt::format("\n{} = ", number.key)), std::string::npos) << number.key;
}

TEST_F(ModelCommands, TellOfEveryTextureThatItIsThere) {
    for (const auto texture : rtcore::kMaterialTextures) {
        rtcore::LoadedScene room = test::makeRoom();
        test::SceneBuilder b;
        rtcore::Material m;
        m.*texture = b.texture(1, 1, {{255, 255, 255, 255}});
        b.square({0, 0, 0}, {0, 1, 0}, 10, b.material(m));
        room.scene = b.finish();
        room.tree = rtcore::buildKdTree(room.scene.mesh(), {});
        room.sceneFile.reset();
        document.show(test::worldOf(std::move(room)));
        EXPECT_NE(answer("material get 1").find("textures = true"), std::string::npos);
        answer("material set 1 textures false");
        EXPECT_NE(answer("material get 1").find("textures = false"), std::string::npos);
        EXPECT_EQ(material(0).*texture, rtcore::kNoTexture);
    }
}

TEST_F(ModelCommands, AMaskHasThePixelsOfAPart) {
    answer("resolution 40 30");
    const std::string text = answer("mask part 2");
    EXPECT_EQ(text.substr(0, 6), "40 30 ");
    std::istringstream words(text.substr(6));
    std::size_t run = 0, all = 0, in = 0;
    for (bool inside = false; words >> run; inside = !inside) {
        all += run;
        in += inside ? run : 0;
    }
    EXPECT_EQ(all, 1200U);
    EXPECT_GT(in, 20U);
    EXPECT_LT(in, 400U);
    EXPECT_EQ(answer("mask material 2"), text) << "which is that part's alone";
    EXPECT_EQ(refusal("mask part 4").code, 2);
    EXPECT_EQ(refusal("mask material 4").code, 2);
}

TEST_F(ModelCommands, EditMaterialsByTheKeysOfAScene) {
    answer("material set steel roughness 0.1");
    EXPECT_EQ(changes(), Changes{Change::Material});
    EXPECT_EQ(material(1).roughness, 0.1F);
    answer("material set steel metallic 1");
    answer("material set steel diffuse 0.9 0.8 0.7");
    EXPECT_EQ(material(1).diffuse, (Colour{0.9F, 0.8F, 0.7F}));
    EXPECT_EQ(answer("materials"), "1 - oak\n2 edited steel\n3 -");
    answer("material set 3 opacity 0.1");
    EXPECT_TRUE(document.scene()->isClosed(20)) << "the ball";
    answer("material set * emission 1 1 1");
    EXPECT_EQ(material(0).emission, rtcore::kWhite);
    answer("material reset steel");
    EXPECT_EQ(material(1), document.world().loaded.scene.materials[1]);
    EXPECT_EQ(refusal("material set steel roughness 2").code, 2);
    EXPECT_EQ(refusal("material set steel opactiy 1").text, "unknown key 'opactiy'; did you mean 'opacity'?");
    EXPECT_EQ(refusal("material set steel diffuseTexture a.png").code, 2);
    EXPECT_EQ(refusal("material set tin roughness 1").text,
              "no material of the model is 'tin'; 'materials' lists them");
    changes();
    answer("material set oak opacity 1");
    EXPECT_EQ(changes(), Changes{}) << "what it is already";
}

TEST_F(ModelCommands, HideAndShowParts) {
    answer("part hide 2");
    EXPECT_EQ(changes(), Changes{Change::Visibility});
    EXPECT_EQ(answer("seen 0.5 0.8"), "part 1 room/floor\nmaterial 1 oak") << "what is behind";
    answer("part isolate ball room/box");
    EXPECT_EQ(answer("parts"), "1 hidden 2 room/floor\n2 shown 12 room/box\n3 shown 120 ball");
    answer("part show room/*");
    EXPECT_EQ(document.scene()->hiddenParts, nullptr);
    EXPECT_EQ(document.tracer(), document.world().tracer) << "nothing is slower than before";
    answer("part hide *");
    EXPECT_EQ(refusal("seen 0.5 0.9").text, "nothing of the model is seen there");
    answer("part show-all");
    EXPECT_EQ(document.scene()->hiddenParts, nullptr);
    EXPECT_EQ(refusal("part hide attic").text, "no part of the model is 'attic'; 'parts' lists them");
}

TEST_F(ModelCommands, AreTakenBackToTheSameBits) {
    const auto first = frame();
    const std::vector<std::string> edits = {"part hide room/box",
                                            "material set oak diffuse 1 0 0",
                                            "material set 3 opacity 0",
                                            "part isolate ball",
                                            "part show-all",
                                            "material reset oak"};
    std::vector<decltype(frame())> frames;
    for (const std::string& edit : edits) {
        answer(edit);
        frames.push_back(frame());
    }
    EXPECT_NE(frames.front(), first);
    for (std::size_t i = edits.size(); i-- > 0;) {
        EXPECT_EQ(frame(), frames[i]) << edits[i];
        answer("undo");
    }
    EXPECT_EQ(frame(), first);
    for (std::size_t i = 0; i < edits.size(); ++i) {
        answer("redo");
        EXPECT_EQ(frame(), frames[i]) << edits[i];
    }
}

TEST_F(ModelCommands, AHiddenFloorCarriesNothing) {
    answer("walk");
    move(std::chrono::milliseconds(200), {});
    EXPECT_FALSE(walk.onUnseenFloor());
    answer("part hide room/floor");
    for (int i = 0; i < 20; ++i) move(std::chrono::milliseconds(100), {});
    EXPECT_TRUE(walk.onUnseenFloor());
}

TEST_F(ModelCommands, AWrittenSceneNamesThem) {
    answer("part isolate ball");
    answer("material set oak roughness 0.3");
    answer("material set 3 opacity 0.5");
    const rtcore::SceneFile file = sceneFileOf(document);
    ASSERT_EQ(file.parts.size(), 2U);
    EXPECT_EQ(file.parts[0], (rtcore::PartDescription{"*", {}, true}));
    EXPECT_EQ(file.parts[1], (rtcore::PartDescription{"ball", {}, false}));
    ASSERT_EQ(file.materials.size(), 2U);
    EXPECT_EQ(file.materials[0].pattern, "oak");
    EXPECT_EQ(file.materials[0].roughness, 0.3F);
    EXPECT_EQ(file.materials[1].number, 3) << "it has no name";
}

/// Edits in a file and edits by commands give the same, bit for bit.
TEST_F(ModelCommands, AWrittenSceneShowsTheSame) {
    std::ofstream(folder / "m.mtl") << "newmtl red\nKd 0.8 0.1 0.1\nnewmtl blue\nKd 0.1 0.1 0.8\nKs 0.5 0.5 "
                                       "0.5\nNs 20\nillum 2\n";
    std::ofstream(folder / "m.obj")
        << "mtllib m.mtl\nv -2 -2 0\nv 2 -2 0\nv 0 2 0\nv -1 -1 1\nv 1 -1 1\nv 0 1 1\n"
           "o back\nusemtl red\nf 1 2 3\no front\nusemtl blue\nf 4 5 6\nusemtl red\nf 6 5 4\n";
    std::ofstream(folder / "m.scn") << "version = 2\nmodel = \"m.obj\"\nambient = [1, 1, 1]\n[camera]\neye = "
                                       "[0, 0, 5]\nlookAt = [0, 0, 0]\n[[material]]\nname = "
                                       "\"red\"\nshininess = 4\n";
    const auto show = [&](const std::filesystem::path& path) {
        document.show(std::make_unique<World>(rtcore::loadScene(path), path, rtcore::ImportOptions()));
        answer("camera reset");
    };
    show(folder / "m.scn");
    for (const char* edit : {"material set red roughness 0.4", "material set blue metallic 0.7",
                             "material set blue diffuse 0.3 0.6 0.2", "material set red opacity 0.5",
                             "part hide front/blue", "section add 0 0.5 0 0 1 0.1", "section light cut"})
        answer(edit);
    answer("export scene DIR/e.scn");
    const rtcore::Scene edited = *document.scene();
    const auto whole = frame();
    show(folder / "e.scn");
    EXPECT_EQ(document.scene()->materials, edited.materials);
    EXPECT_TRUE(rtcore::sameParts(document.scene()->hiddenParts, edited.hiddenParts));
    EXPECT_NE(document.scene()->hiddenParts, nullptr);
    EXPECT_EQ(document.scene()->sections, edited.sections);
    EXPECT_FALSE(edited.sections.empty());
    EXPECT_EQ(document.scene()->closed == nullptr, edited.closed == nullptr);
    EXPECT_EQ(frame(), whole);
}

} // namespace
} // namespace rtserver
