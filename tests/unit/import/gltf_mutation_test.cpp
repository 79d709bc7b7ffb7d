// The reader of glTF facts beside Assimp: any bytes give facts or none, and nothing else happens.
#include "rtcore/io/import/gltf/gltf_file.h"
#include "support/damaged_text.h"
#include "support/temporary_folder.h"
#include "unit/import/gltf_text.h"
#include "unit/import/import_support.h"

#include <gtest/gtest.h>

namespace {

std::string richJson() {
    return R"({"asset":{"version":"2.0","generator":"a"},"scene":0,"scenes":[{"nodes":[0,1]}],
"nodes":[{"mesh":0,"children":[2]},{"mesh":1,"skin":0},{"mesh":0}],
"extensionsUsed":["KHR_materials_unlit","EXT_x"],"extensionsRequired":["EXT_x"],
"buffers":[{"uri":"my%20box.bin","byteLength":36},{"uri":"data:,","byteLength":1}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"accessors":[{"bufferView":0,"componentType":5126,"count":30,"type":"VEC3"},{"componentType":5123,"count":12,"type":"SCALAR"}],
"textures":[{"source":0,"sampler":0}],"images":[{"uri":"a.png"}],"samplers":[{"magFilter":9728}],
"materials":[{"alphaMode":"BLEND","normalTexture":{"index":0,"scale":0.5},"extensions":{
"KHR_materials_emissive_strength":{"emissiveStrength":6},"KHR_materials_ior":{"ior":2},
"KHR_materials_transmission":{"transmissionFactor":1,"transmissionTexture":{"index":0}}}},{}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"COLOR_0":0},"indices":1,"mode":4,"material":0}]},
{"primitives":[{"attributes":{"POSITION":0},"mode":5},{"attributes":{"POSITION":0},"mode":6}]}]})";
}

TEST(GltfMutation, FactsAreReadOrNot) {
    const test::TemporaryFolder folder;
    test::GltfScene scene;
    scene.material = R"({"alphaMode":"MASK"})";
    scene.colours = true;
    test::DamagedText damaged({richJson(), scene.text(), scene.binary()}, test::kJsonTokens, 8);
    long read = 0;
    for (long i = 0; i < test::damagedTexts(); ++i) {
        test::writeText(folder / "a.gltf", damaged.next());
        if (rtcore::readGltfFile(folder / "a.gltf")) ++read;
    }
    EXPECT_GT(read, 0);
    EXPECT_LT(read, test::damagedTexts());
}

} // namespace
