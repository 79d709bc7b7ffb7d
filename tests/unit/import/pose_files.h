/// Small models with joints, morph targets and animations, as text. All show the bar (0 0 0) (1 0 0) (1 2 0)
/// (0 2 0), of which a second joint at y = 1 moves the upper end.
#pragma once

#include <string>

namespace test {

/// The second joint is turned by a quarter about z; its animation `Walk` begins straight and ends so after a
/// second. The mesh's own frame stands at x = 100. `moves`: keys of the animation.
inline std::string
barX(const std::string& moves = "2; 0;16;1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,1.0,0.0,1.0;;,"
                                "4800;16;0.0,1.0,0.0,0.0,-1.0,0.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,1.0,0.0,1.0;;;",
     const std::string& weights = "1.0,1.0") {
    return "xof 0303txt 0032\n"
           "Frame Root { FrameTransformMatrix { "
           "1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0;; }\n"
           " Frame B0 { FrameTransformMatrix { "
           "1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0;; } }\n"
           " Frame B1 { FrameTransformMatrix { "
           "0.0,1.0,0.0,0.0,-1.0,0.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,1.0,0.0,1.0;; } }\n"
           " Frame Bar { FrameTransformMatrix { "
           "1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0,100.0,0.0,0.0,1.0;; }\n"
           "  Mesh { 4; 0.0;0.0;0.0;,1.0;0.0;0.0;,1.0;2.0;0.0;,0.0;2.0;0.0;; 2; 3;0,1,2;,3;0,2,3;;\n"
           "   XSkinMeshHeader { 1;1;2; }\n"
           "   SkinWeights { \"B0\"; 2; 0,1; 1.0,1.0; "
           "1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0;; }\n"
           "   SkinWeights { \"B1\"; 2; 2,3; " +
           weights +
           "; 1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,0.0,0.0,1.0,0.0,0.0,-1.0,0.0,1.0;; }\n"
           "  } } }\n"
           "AnimationSet Walk { Animation { {B1} AnimationKey { 4; " +
           moves + " } } }\n";
}

/// A .md5mesh, and the .md5anim beside it, whose second frame turns the second joint by a quarter the other
/// way. Their z is up: Assimp makes (x, z, -y) of (x, y, z).
inline const char* const kBarMd5Mesh =
    "MD5Version 10\ncommandline \"\"\n\nnumJoints 2\nnumMeshes 1\n\njoints {\n\t\"B0\"\t-1 ( 0 0 0 ) ( 0 0 0 "
    ")\n"
    "\t\"B1\"\t0 ( 0 1 0 ) ( 0 0 0 )\n}\n\nmesh {\n\tshader \"none\"\n\n\tnumverts 4\n\tvert 0 ( 0 0 ) 0 1\n"
    "\tvert 1 ( 0 0 ) 1 1\n\tvert 2 ( 0 0 ) 2 1\n\tvert 3 ( 0 0 ) 3 1\n\n\tnumtris 2\n\ttri 0 0 1 2\n"
    "\ttri 1 0 2 3\n\n\tnumweights 4\n\tweight 0 0 1 ( 0 0 0 )\n\tweight 1 0 1 ( 1 0 0 )\n"
    "\tweight 2 1 1 ( 1 1 0 )\n\tweight 3 1 1 ( 0 1 0 )\n}\n";
inline const char* const kBarMd5Anim =
    "MD5Version 10\ncommandline \"\"\n\nnumFrames 2\nnumJoints 2\nframeRate 2\nnumAnimatedComponents 6\n\n"
    "hierarchy {\n\t\"B0\"\t-1 0 0\n\t\"B1\"\t0 63 0\n}\n\nbounds {\n\t( 0 0 0 ) ( 1 2 0 )\n"
    "\t( 0 0 0 ) ( 1 2 0 )\n}\n\nbaseframe {\n\t( 0 0 0 ) ( 0 0 0 )\n\t( 0 1 0 ) ( 0 0 0 )\n}\n\n"
    "frame 0 {\n\t0 1 0 0 0 0\n}\n\nframe 1 {\n\t0 1 0 0 0 0.70710678\n}\n";

inline std::string floatsDae(const std::string& id, const std::string& numbers, int count, int stride) {
    const std::string kind = stride == 16 ? "float4x4" : "float";
    const int params = stride == 16 ? 1 : stride;
    std::string text = "<source id=\"" + id + "\"><float_array id=\"" + id + "-a\" count=\"" +
                       std::to_string(count * stride) + "\">" + numbers +
                       "</float_array><technique_common><accessor source=\"#" + id + "-a\" count=\"" +
                       std::to_string(count) + "\" stride=\"" + std::to_string(stride) + "\">";
    for (int i = 0; i < params; ++i)
        text += std::string("<param name=\"") + "XYZ"[i] + "\" type=\"" + kind + "\"/>";
    return text + "</accessor></technique_common></source>";
}

inline std::string wordsDae(const std::string& id, const char* list, const std::string& words, int count) {
    return "<source id=\"" + id + "\"><" + list + " id=\"" + id + "-a\" count=\"" + std::to_string(count) +
           "\">" + words + "</" + list + "><technique_common><accessor source=\"#" + id + "-a\" count=\"" +
           std::to_string(count) +
           "\" stride=\"1\"><param name=\"P\" type=\"name\"/></accessor></technique_common></source>";
}

inline std::string geometryDae(const std::string& id, const std::string& positions) {
    return "<geometry id=\"" + id + "\" name=\"" + id + "\"><mesh>" + floatsDae(id + "-p", positions, 4, 3) +
           "<vertices id=\"" + id + "-v\"><input semantic=\"POSITION\" source=\"#" + id +
           "-p\"/></vertices><triangles count=\"2\"><input semantic=\"VERTEX\" source=\"#" + id +
           "-v\" offset=\"0\"/><p>0 1 2 0 2 3</p></triangles></mesh></geometry>";
}

inline std::string collada(const std::string& libraries, const std::string& nodes) {
    return "<?xml version=\"1.0\" encoding=\"utf-8\"?><COLLADA "
           "xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\"><asset><unit "
           "meter=\"1\" "
           "name=\"meter\"/><up_axis>Y_UP</up_axis></asset>" +
           libraries + "<library_visual_scenes><visual_scene id=\"S\" name=\"S\">" + nodes +
           "</visual_scene></library_visual_scenes><scene><instance_visual_scene "
           "url=\"#S\"/></scene></COLLADA>";
}

constexpr const char* kBarPositions = "0 0 0 1 0 0 1 2 0 0 2 0";

/// As barX(), with a bind shape matrix that doubles what the mesh says, which is half as large, and a node of
/// its own that stands at x = 100.
inline std::string barDae() {
    const std::string skin =
        "<library_controllers><controller id=\"C\"><skin source=\"#G\"><bind_shape_matrix>2 0 0 0 0 2 0 0 0 "
        "0 2 "
        "0 0 0 0 1</bind_shape_matrix>" +
        wordsDae("J", "Name_array", "B0 B1", 2) +
        floatsDae("M", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1 1 0 0 0 0 1 0 -1 0 0 1 0 0 0 0 1", 2, 16) +
        floatsDae("W", "1", 1, 1) +
        "<joints><input semantic=\"JOINT\" source=\"#J\"/><input semantic=\"INV_BIND_MATRIX\" "
        "source=\"#M\"/></joints><vertex_weights count=\"4\"><input semantic=\"JOINT\" source=\"#J\" "
        "offset=\"0\"/><input semantic=\"WEIGHT\" source=\"#W\" offset=\"1\"/><vcount>1 1 1 1</vcount><v>0 0 "
        "0 0 "
        "1 0 1 0</v></vertex_weights></skin></controller></library_controllers>";
    const std::string moves =
        "<library_animations><animation id=\"Walk\" name=\"Walk\">" + floatsDae("T", "0 1", 2, 1) +
        floatsDae("O", "0 90", 2, 1) + wordsDae("I", "Name_array", "LINEAR LINEAR", 2) +
        "<sampler id=\"A\"><input semantic=\"INPUT\" source=\"#T\"/><input semantic=\"OUTPUT\" "
        "source=\"#O\"/><input semantic=\"INTERPOLATION\" source=\"#I\"/></sampler><channel source=\"#A\" "
        "target=\"B1/turn.ANGLE\"/></animation></library_animations>";
    return collada(
        "<library_geometries>" + geometryDae("G", "0 0 0 0.5 0 0 0.5 1 0 0 1 0") + "</library_geometries>" +
            skin + moves,
        "<node id=\"B0\" sid=\"B0\" type=\"JOINT\"/><node id=\"B1\" sid=\"B1\" type=\"JOINT\"><translate "
        "sid=\"move\">0 1 0</translate><rotate sid=\"turn\">0 0 1 90</rotate></node><node "
        "id=\"Bar\"><translate>100 0 0</translate><instance_controller "
        "url=\"#C\"><skeleton>#B0</skeleton></instance_controller></node>");
}

/// Targets that move the bar by 1 along z and by 1 along x.
inline std::string morphDae(const std::string& weights, const std::string& method = "NORMALIZED",
                            const std::string& animations = "") {
    const std::string controller =
        "<library_controllers><controller id=\"C\"><morph source=\"#G\" method=\"" + method + "\">" +
        wordsDae("T", "IDREF_array", "G1 G2", 2) + floatsDae("W", weights, 2, 1) +
        "<targets><input semantic=\"MORPH_TARGET\" source=\"#T\"/><input semantic=\"MORPH_WEIGHT\" "
        "source=\"#W\"/></targets></morph></controller></library_controllers>";
    const bool relative = method == "RELATIVE";
    return collada("<library_geometries>" + geometryDae("G", kBarPositions) +
                       geometryDae("G1", relative ? "0 0 1 0 0 1 0 0 1 0 0 1" : "0 0 1 1 0 1 1 2 1 0 2 1") +
                       geometryDae("G2", relative ? "1 0 0 1 0 0 1 0 0 1 0 0" : "1 0 0 2 0 0 2 2 0 1 2 0") +
                       "</library_geometries>" + controller + animations,
                   "<node id=\"Bar\"><instance_controller url=\"#C\"/></node>");
}

/// An animation "Grow" of a second that moves the target of a channel from one value to another.
inline std::string growingDae(const std::string& target, const std::string& values) {
    return "<library_animations><animation id=\"Grow\" name=\"Grow\">" + floatsDae("GT", "0 1", 2, 1) +
           floatsDae("GO", values, 2, 1) + wordsDae("GI", "Name_array", "LINEAR LINEAR", 2) +
           "<sampler id=\"GA\"><input semantic=\"INPUT\" source=\"#GT\"/><input semantic=\"OUTPUT\" "
           "source=\"#GO\"/><input semantic=\"INTERPOLATION\" source=\"#GI\"/></sampler><channel "
           "source=\"#GA\" "
           "target=\"" +
           target + "\"/></animation></library_animations>";
}

inline std::string fbx(const std::string& objects, const std::string& connections) {
    return "; FBX 7.4.0 project file\nFBXHeaderExtension:  {\n FBXHeaderVersion: 1003\n FBXVersion: 7400\n}\n"
           "GlobalSettings:  {\n Version: 1000\n Properties70:  {\n P: \"UpAxis\", \"int\", \"Integer\", "
           "\"\",1\n }\n}\nObjects:  {\n" +
           objects + "}\nConnections:  {\n" + connections + "}\n";
}

inline std::string modelFbx(int id, const std::string& name, const std::string& kind,
                            const std::string& properties = "") {
    return " Model: " + std::to_string(id) + ", \"Model::" + name + "\", \"" + kind +
           "\" {\n  Version: 232\n  Properties70:  {\n" + properties +
           "  }\n  Shading: T\n  Culling: "
           "\"CullingOff\"\n }\n";
}

inline std::string geometryFbx(int id, const std::string& name = "") {
    return " Geometry: " + std::to_string(id) + ", \"Geometry::" + name +
           "\", \"Mesh\" {\n  Vertices: *12 {\n   a: 0,0,0,1,0,0,1,2,0,0,2,0\n  }\n  PolygonVertexIndex: *6 "
           "{\n   a: 0,1,-3,0,2,-4\n  }\n  GeometryVersion: 124\n }\n";
}

inline std::string linkFbx(int part, int whole) {
    return " C: \"OO\"," + std::to_string(part) + "," + std::to_string(whole) + "\n";
}

inline std::string vectorFbx(const std::string& name, const std::string& numbers) {
    return "   P: \"" + name + "\", \"" + name + "\", \"\", \"A\"," + numbers + "\n";
}

/// As barX(), with an offset of the geometry from its node, by 1 along x, that counts before the skin.
inline std::string barFbx() {
    const std::string identity = "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1", down = "1,0,0,0,0,1,0,0,0,0,1,0,0,-1,0,1",
                      up = "1,0,0,0,0,1,0,0,0,0,1,0,0,1,0,1";
    const auto cluster = [](int id, const char* vertices, const std::string& mesh, const std::string& link) {
        return " Deformer: " + std::to_string(id) +
               ", \"SubDeformer::\", \"Cluster\" {\n  Version: 100\n  UserData: \"\", \"\"\n  Indexes: *2 "
               "{\n   a: " +
               vertices + "\n  }\n  Weights: *2 {\n   a: 1,1\n  }\n  Transform: *16 {\n   a: " + mesh +
               "\n  }\n  TransformLink: *16 {\n   a: " + link + "\n  }\n }\n";
    };
    return fbx(
        geometryFbx(1) +
            modelFbx(2, "Bar", "Mesh",
                     vectorFbx("Lcl Translation", "100,0,0") +
                         "   P: \"GeometricTranslation\", \"Vector3D\", \"Vector\", \"\",1,0,0\n") +
            modelFbx(3, "B0", "LimbNode") +
            modelFbx(4, "B1", "LimbNode",
                     vectorFbx("Lcl Translation", "0,1,0") + vectorFbx("Lcl Rotation", "0,0,90")) +
            " Deformer: 10, \"Deformer::\", \"Skin\" {\n  Version: 101\n  Link_DeformAcuracy: 50\n }\n" +
            cluster(11, "0,1", identity, identity) + cluster(12, "2,3", down, up),
        linkFbx(2, 0) + linkFbx(3, 0) + linkFbx(4, 0) + linkFbx(1, 2) + linkFbx(10, 1) + linkFbx(11, 10) +
            linkFbx(12, 10) + linkFbx(3, 11) + linkFbx(4, 12));
}

/// A shape that moves the bar by 1 along z, `percent` far; its channel says so as Blender does, or as Maya.
inline std::string morphFbx(const std::string& percent, bool asProperty) {
    const std::string said =
        asProperty
            ? "  DeformPercent: 100\n  Properties70:  {\n   P: \"DeformPercent\", \"Number\", \"\", \"A\"," +
                  percent + "\n  }\n"
            : "  DeformPercent: " + percent + "\n";
    return fbx(
        geometryFbx(1, "G") + modelFbx(2, "Bar", "Mesh") +
            " Geometry: 3, \"Geometry::Up\", \"Shape\" {\n  Version: 100\n  Indexes: *4 {\n   a: "
            "0,1,2,3\n  }\n  Vertices: *12 {\n   a: 0,0,1,0,0,1,0,0,1,0,0,1\n  }\n  Normals: *12 {\n   a: "
            "0,0,0,0,0,0,0,0,0,0,0,0\n  }\n }\n"
            " Deformer: 4, \"Deformer::\", \"BlendShape\" {\n  Version: 100\n }\n"
            " Deformer: 5, \"SubDeformer::Slider\", \"BlendShapeChannel\" {\n  Version: 100\n" +
            said + "  FullWeights: *1 {\n   a: 100\n  }\n }\n",
        linkFbx(2, 0) + linkFbx(1, 2) + linkFbx(4, 1) + linkFbx(5, 4) + linkFbx(3, 5));
}

} // namespace test
