#include "rtcore/io/import/assimp/assimp_import.h"

#include "rtcore/io/import/assimp/ac3d_text.h"
#include "rtcore/io/import/assimp/assimp_files.h"
#include "rtcore/io/import/assimp/assimp_parts.h"
#include "rtcore/io/import/assimp/collada_text.h"
#include "rtcore/io/import/assimp/dxf_text.h"
#include "rtcore/io/import/assimp/expanded_nodes.h"
#include "rtcore/io/import/assimp/hidden_nodes.h"
#include "rtcore/io/import/assimp/md5_frame_rate.h"
#include "rtcore/io/import/assimp/mesh_poser.h"
#include "rtcore/io/import/assimp/scene_pose.h"
#include "rtcore/io/import/assimp/unread_content.h"
#include "rtcore/io/import/assimp/x3d_text.h"
#include "rtcore/io/import/gltf/gltf_damage.h"
#include "rtcore/io/import/import_forms.h"
#include "rtcore/io/import/inspection/cut_off.h"
#include "rtcore/io/import/inspection/exporter_notes.h"
#include "rtcore/io/import/inspection/foreign_formats.h"
#include "rtcore/io/import/inspection/import_warnings.h"
#include "rtcore/io/import/materials/colour_decoder.h"
#include "rtcore/io/import/materials/exporter_colours.h"
#include "rtcore/io/import/mesh/geometry_finish.h"
#include "rtcore/io/import/mesh/near_zero.h"
#include "rtcore/io/import/mesh/polygon.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/paths.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/up_axis.h"
#include "rtcore/settings/utf8.h"

#include <assimp/Importer.hpp>
#include <assimp/commonMetaData.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <new>
#include <optional>
#include <span>
#include <utility>

namespace rtcore {

namespace {

static_assert(sizeof(ai_real) == sizeof(float), "this file takes Assimp's numbers for floats");

[[noreturn]] void refuse(const Sentence& message) { throw FileError(FailureKind::BadData, "", message); }

/// A mesh under a node.
struct Instance {
    unsigned mesh;
    Affine toWorld;
    const aiNode* node;
    unsigned material; ///< its number in Assimp's list, or beyond that
};

/// All that the node graph says.
struct NodeWalk {
    std::vector<Instance> instances; ///< depth first, in the order of the file
    NodeTransforms transforms;
    double coarseness = 0; ///< of where nodes stand; looked at where an origin was taken off
};

bool hasMesh(const aiScene& scene, unsigned number) {
    return number < scene.mNumMeshes && scene.mMeshes[number] != nullptr;
}

bool needsTransforms(const aiScene& scene) {
    if (scene.mNumLights + scene.mNumCameras > 0) return true;
    for (unsigned m = 0; m < scene.mNumMeshes; ++m)
        if (hasMesh(scene, m) && scene.mMeshes[m]->mNumBones > 0) return true;
    return false;
}

/// Assimp has translations in floats.
double coarsenessOf(const Affine& local, const Affine& parent) {
    const Vec3 at = local.point({});
    return rtcore::coarsenessOf(std::span(&at, 1), parent);
}

/// Iterative, with a limit that only a graph with cycles reaches.
NodeWalk walkNodes(const aiScene& scene, const ScenePose& pose, const LocalOrigin& origin,
                   HiddenNodes& hidden) {
    constexpr std::size_t kMaxNodes = 4'000'000;
    const bool transforms = needsTransforms(scene);
    const Affine ofFile = lessOrigin(origin);
    NodeWalk walk;
    if (!origin.isZero()) walk.transforms.try_emplace(kNoNode, ofFile);
    std::size_t visited = 0;
    std::vector<std::pair<const aiNode*, Affine>> open;
    if (scene.mRootNode != nullptr) open.emplace_back(scene.mRootNode, ofFile);
    while (!open.empty()) {
        const auto [node, parent] = open.back();
        open.pop_back();
        if (++visited > kMaxNodes) refuse("its node graph has no end; repair the file");
        const Affine local = pose.localOf(*node), toWorld = parent * local;
        if (!origin.isZero()) walk.coarseness = std::max(walk.coarseness, coarsenessOf(local, parent));
        if (transforms) walk.transforms.try_emplace(node->mName.C_Str(), toWorld);
        const bool shown = !hidden.takeNext(*node);
        for (unsigned i = 0; shown && i < node->mNumMeshes; ++i) {
            if (hasMesh(scene, node->mMeshes[i]))
                walk.instances.push_back(
                    {node->mMeshes[i], toWorld, node, scene.mMeshes[node->mMeshes[i]]->mMaterialIndex});
        }
        for (unsigned i = node->mNumChildren; i-- > 0;) {
            if (node->mChildren[i] != nullptr) open.emplace_back(node->mChildren[i], toWorld);
        }
    }
    if (walk.instances.empty() && hidden.any())
        refuse("all of its parts are hidden; show them in the program that wrote it and export it again");
    return walk;
}

double coarsenessOf(const aiMesh& mesh, const Affine& toWorld) {
    std::vector<Vec3> positions;
    for (unsigned i = 0; mesh.mVertices != nullptr && i < mesh.mNumVertices; ++i)
        positions.push_back({mesh.mVertices[i].x, mesh.mVertices[i].y, mesh.mVertices[i].z});
    return rtcore::coarsenessOf(positions, toWorld);
}

/// Makes SourceMeshes of Assimp's meshes; keeps its memory from one to the next.
class MeshReader {
  public:
    MeshReader(const FormatQuirks& quirks, MeshPoser& poser, ImportReport& report)
        : quirks_(quirks), poser_(poser), report_(report), decode_(quirks.linearVertexColours) {}

    /// Valid until the next call.
    SourceMesh read(const aiMesh& mesh, const Instance& at, const TexcoordUse& use) {
        SourceMesh out;
        const PosedMesh* const posed =
            mesh.mVertices != nullptr ? poser_.pose(mesh, *at.node, at.toWorld) : nullptr;
        readTriangles(mesh, posed != nullptr ? posed->mirrored : at.toWorld.determinant() < 0);
        out.triangles = triangles_;
        if (triangles_.empty()) return out;
        if (posed != nullptr) {
            out.positions = posed->positions;
            out.normals = posed->normals;
        } else {
            readPositions(mesh, at.toWorld);
            out.positions = positions_;
            if (mesh.mNormals != nullptr && !quirks_.facetNormals)
                out.normals = readNormals(mesh, at.toWorld);
        }
        out.texcoords = readTexcoords(mesh, use);
        if (mesh.mColors[0] != nullptr && !quirks_.ignoredColours) out.colours = readColours(mesh);
        return out;
    }

  private:
    void readTriangles(const aiMesh& mesh, bool mirrored) {
        triangles_.clear();
        const unsigned faces = mesh.mFaces != nullptr && mesh.mVertices != nullptr ? mesh.mNumFaces : 0;
        triangles_.reserve(faces);
        for (unsigned f = 0; f < faces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (face.mNumIndices < 3 || face.mIndices == nullptr) {
                ++report_.ignoredPrimitives;
            } else if (!valid(face, mesh.mNumVertices)) {
                report_.unconnectedTriangles += face.mNumIndices - 2;
            } else if (face.mNumIndices == 3) {
                addTriangle(face, 0, 1, 2, mirrored);
            } else {
                cutPolygon(mesh, face, mirrored);
            }
        }
    }

    static bool valid(const aiFace& face, unsigned vertices) {
        for (unsigned i = 0; i < face.mNumIndices; ++i) {
            if (face.mIndices[i] >= vertices) return false;
        }
        return true;
    }

    void addTriangle(const aiFace& face, std::uint32_t a, std::uint32_t b, std::uint32_t c, bool mirrored) {
        if (mirrored) std::swap(b, c);
        triangles_.push_back({{face.mIndices[a], face.mIndices[b], face.mIndices[c]}});
    }

    void cutPolygon(const aiMesh& mesh, const aiFace& face, bool mirrored) {
        corners_.clear();
        for (unsigned i = 0; i < face.mNumIndices; ++i) {
            const aiVector3D& v = mesh.mVertices[face.mIndices[i]];
            corners_.push_back({v.x, v.y, v.z});
        }
        for (const Triangle& t : cutter_.cut(corners_)) addTriangle(face, t.v[0], t.v[1], t.v[2], mirrored);
    }

    void readPositions(const aiMesh& mesh, const Affine& toWorld) {
        positions_.clear();
        positions_.reserve(mesh.mNumVertices);
        const bool unmoved = toWorld.identity();
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
            const aiVector3D& v = mesh.mVertices[i];
            const Vec3 p{v.x, v.y, v.z};
            positions_.push_back(unmoved ? p : toWorld.point(p));
        }
    }

    std::span<const Vec3> readNormals(const aiMesh& mesh, const Affine& toWorld) {
        normals_.clear();
        normals_.reserve(mesh.mNumVertices);
        const bool unmoved = toWorld.identity();
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
            const aiVector3D& v = mesh.mNormals[i];
            const Vec3 n{v.x, v.y, v.z};
            normals_.push_back(unmoved ? n : toWorld.normal(n));
        }
        return normals_;
    }

    std::span<const Vec2> readTexcoords(const aiMesh& mesh, const TexcoordUse& use) {
        const bool there =
            use.set < AI_MAX_NUMBER_OF_TEXTURECOORDS && mesh.mTextureCoords[use.set] != nullptr;
        const aiVector3D* const source = mesh.mTextureCoords[there ? use.set : 0];
        if (source == nullptr) return {};
        texcoords_.clear();
        texcoords_.reserve(mesh.mNumVertices);
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
            texcoords_.push_back(
                {source[i].x * use.scale.x + use.offset.x, source[i].y * use.scale.y + use.offset.y});
        }
        return texcoords_;
    }

    std::span<const Colour> readColours(const aiMesh& mesh) {
        colours_.clear();
        colours_.reserve(mesh.mNumVertices);
        for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
            const aiColor4D& c = mesh.mColors[0][i];
            colours_.push_back(decode_({c.r, c.g, c.b}));
        }
        return colours_;
    }

    const FormatQuirks& quirks_;
    MeshPoser& poser_;
    ImportReport& report_;
    ColourDecoder decode_;
    PolygonCutter cutter_;
    std::vector<Triangle> triangles_;
    std::vector<Vec3> positions_, normals_, corners_;
    std::vector<Vec2> texcoords_;
    std::vector<Colour> colours_;
};

/// Sources of facts about the materials that Assimp does not hand over.
struct MaterialSources {
    const FormatQuirks& quirks;
    MaterialTexts texts;
};

/// Model materials, in the order of the file, without those that no mesh uses.
class Materials {
  public:
    Materials(const aiScene& scene, const NodeWalk& walk, const MaterialSources& from, FileImport& to,
              TextureStore& textures)
        : numbers_(scene.mNumMaterials, kNoMaterial), uses_(scene.mNumMaterials), model_(&to.model) {
        std::vector<char> used(scene.mNumMaterials, 0);
        for (const Instance& i : walk.instances) {
            if (i.material < used.size()) used[i.material] = 1;
        }
        for (unsigned m = 0; m < scene.mNumMaterials; ++m) {
            if (used[m] == 0 || scene.mMaterials[m] == nullptr) continue;
            const aiMaterial& material = *scene.mMaterials[m];
            const MaterialText text = from.texts.of(m, scene.mNumMaterials);
            const SourceMaterial source = sourceMaterialOf(material, from.quirks, text);
            uses_[m] = texcoordUseOf(material, to.report);
            numbers_[m] = append(mapMaterial(source, textures), source.name, to.model);
        }
    }
    std::uint32_t numberOf(unsigned material) {
        if (material < numbers_.size() && numbers_[material] != kNoMaterial) return numbers_[material];
        if (plain_ == kNoMaterial) plain_ = append(Material{}, "", *model_);
        return plain_;
    }
    TexcoordUse texcoordUse(unsigned material) const {
        return material < uses_.size() ? uses_[material] : TexcoordUse{};
    }

  private:
    static constexpr std::uint32_t kNoMaterial = 0xFFFFFFFFU;
    static std::uint32_t append(Material material, const std::string& name, ModelBuffers& model) {
        material.nameOffset = model.addName(name);
        model.materials.push_back(material);
        return static_cast<std::uint32_t>(model.materials.size() - 1);
    }
    std::vector<std::uint32_t> numbers_;
    std::vector<TexcoordUse> uses_;
    std::uint32_t plain_ = kNoMaterial;
    ModelBuffers* model_ = nullptr;
};

/// An importer that is chosen by the name would take it for what it is not.
void refuseMisnamedFor(const std::filesystem::path& path, const Assimp::Importer& importer) {
    const std::string own = path.extension().string();
    if (own.empty() || !importer.IsExtensionSupported(own)) return;
    refuseMisnamed(path);
}

/// Assimp may quote all that follows in the file. Cut between characters of UTF-8.
std::string beginningOf(const std::string& reason) {
    constexpr std::size_t kMax = 300;
    if (reason.size() <= kMax) return reason;
    return std::string(utf8Beginning(reason, kMax)) + " ...";
}

/// In place of the file's, where Assimp would not understand that.
std::optional<std::string> textForAssimp(const std::filesystem::path& path, const ColladaWeights& weights) {
    if (auto text = colladaForAssimp(path, weights)) return text;
    if (auto text = dxfForAssimp(path)) return text;
    return x3dForAssimp(path);
}

Sentence foreignFiles(const std::vector<std::string>& files) {
    return say("it names files outside of its folder, which are not read: {0}; put them beside the model",
               firstOf(files));
}

/// Only parses: Assimp's own post-processing takes ten times as long as ours.
const aiScene& readScene(Assimp::Importer& importer, const std::filesystem::path& path, bool animations,
                         const ColladaWeights& weights, ImportReport& report) {
    const auto files = std::make_shared<OpenedFiles>();
    std::optional<ReplacedFile> replaced;
    if (auto text = textForAssimp(path, weights)) replaced = {plainPath(path).string(), std::move(*text)};
    importer.SetIOHandler(filesForAssimp(path, files, std::move(replaced))); // which it owns from now on
    // A file of lights or bones alone holds no surface: none is made up.
    importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_READ_ANIMATIONS, animations);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_MD5_NO_ANIM_AUTOLOAD, !animations);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_AC_EVAL_SUBDIVISION, !subdividesTextures(path));
    refuseMisnamedFor(path, importer);
    const aiScene* const scene = importer.ReadFile(path.string(), 0);
    for (const std::string& file : files->read) addFile(report, file);
    if (scene != nullptr) {
        if (!files->outside.empty()) addWarning(report, foreignFiles(files->outside));
        return *scene;
    }
    const std::string reason = importer.GetErrorString();
    if (reason.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
    refuseMisnamed(path);
    if (const auto sentence = cutOff(path)) refuse(*sentence);
    if (const auto sentence = gltfDamage(path)) refuse(*sentence);
    if (!files->outside.empty()) refuse(foreignFiles(files->outside));
    if (reason.find("No suitable reader") != std::string::npos) {
        refuse("no importer knows this format; convert it to glTF, OBJ, PLY or STL");
    }
    refuse(say(
        "Assimp cannot read it: {0}; open it in the program that wrote it and export it again, as glTF or "
        "OBJ for example",
        beginningOf(reason)));
}

std::string formatOf(const Assimp::Importer& importer) {
    const int index = importer.GetPropertyInteger("importerIndex", -1);
    const aiImporterDesc* const info =
        index >= 0 ? importer.GetImporterInfo(static_cast<std::size_t>(index)) : nullptr;
    return info != nullptr && info->mName != nullptr ? info->mName : "";
}

std::string textOf(const aiScene& scene, const char* name) {
    aiString text;
    const bool there = scene.mMetaData != nullptr && scene.mMetaData->Get(name, text);
    return there ? text.C_Str() : "";
}

/// FBX: neither is applied by Assimp.
void readFbxSettings(const aiScene& scene, ModelOrigin& origin) {
    std::int32_t axis = 1, sign = 1;
    double centimetres = 1;
    if (scene.mMetaData == nullptr) return;
    scene.mMetaData->Get("UpAxis", axis);
    scene.mMetaData->Get("UpAxisSign", sign);
    scene.mMetaData->Get("UnitScaleFactor", centimetres);
    if (axis >= 0 && axis <= 2) origin.up = kAxes.at(static_cast<std::size_t>(2 * axis + (sign < 0 ? 1 : 0)));
    if (centimetres > 0 && std::isfinite(centimetres)) origin.metresPerUnit = 0.01 * centimetres;
}

ModelOrigin originOf(const std::filesystem::path& path, const std::string& format, const FormatQuirks& quirks,
                     const aiScene& scene) {
    ModelOrigin origin{format, exporterNotes(path), {}, {}};
    if (origin.exporter.empty()) origin.exporter = textOf(scene, AI_METADATA_SOURCE_GENERATOR);
    origin.metresPerUnit = statedUnit(origin.exporter);
    if (quirks.metresAndYUp) {
        origin.up = Vec3{0, 1, 0};
        origin.metresPerUnit = 1;
    }
    if (quirks.ownAxes) readFbxSettings(scene, origin);
    readFixedUnits(path, origin);
    return origin;
}

/// The only one of this name, or nothing.
std::optional<unsigned> materialNamed(const aiScene& scene, const std::string& name) {
    std::optional<unsigned> found;
    for (unsigned m = 0; m < scene.mNumMaterials; ++m) {
        if (scene.mMaterials[m] == nullptr || name != scene.mMaterials[m]->GetName().C_Str()) continue;
        if (found) return std::nullopt;
        found = m;
    }
    return found;
}

/// Assimp gives all nodes that show one geometry of an FBX file the materials of the first of them, and reads
/// those of such nodes alone.
void setInstanceMaterials(const aiScene& scene, const FbxNotes& notes, NodeWalk& walk, ImportReport& report) {
    std::uint64_t lost = 0;
    std::map<unsigned, const std::vector<std::string>*> first; // of each mesh: materials of its first node
    for (Instance& instance : walk.instances) {
        const auto own = notes.materials.find(instance.node->mName.C_Str());
        const auto* const names = own != notes.materials.end() ? &own->second : nullptr;
        const auto [of, isNew] = first.try_emplace(instance.mesh, names);
        if (isNew || names == nullptr || of->second == nullptr || *names == *of->second) continue;
        if (instance.material >= scene.mNumMaterials || scene.mMaterials[instance.material] == nullptr)
            continue;
        const std::string given = scene.mMaterials[instance.material]->GetName().C_Str();
        const auto at = std::ranges::find(*of->second, given);
        const auto number = static_cast<std::size_t>(at - of->second->begin());
        if (std::ranges::count(*of->second, given) != 1 || number >= names->size()) continue;
        const auto material = materialNamed(scene, (*names)[number]);
        instance.material = material.value_or(instance.material);
        lost += material ? 0 : 1;
    }
    if (lost > 0) addWarning(report, say(import_forms::kLostInstanceMaterials, lost));
}

/// Instances multiply: a small file can stand for more triangles than any memory holds.
void makeRoom(const aiScene& scene, const NodeWalk& walk, std::uint64_t memoryLimit,
              MeshAssembler& assembler) {
    ExpandedCount count;
    for (const Instance& i : walk.instances) {
        const aiMesh& mesh = *scene.mMeshes[i.mesh];
        count.add({1, mesh.mNumVertices, mesh.mNumFaces}); // polygons have more, but no more than vertices
    }
    makeRoomFor(count, memoryLimit, assembler);
}

void warnOfFiles(const std::filesystem::path& path, const std::string& format, ImportReport& report) {
    if (format.starts_with("Blender"))
        addWarning(report, say("what modifiers make of its meshes, and some objects of its hierarchy, may "
                               "be missing; export it from Blender as glTF to be sure"));
    for (const char* const form : unreadInCollada(path)) addWarning(report, form);
    for (const Sentence& sentence : unreadInX3d(path)) addWarning(report, sentence);
    if (subdividesTextures(path))
        addWarning(report, say("its surfaces are not subdivided, as that would smear their textures along "
                               "seams; export them subdivided"));
}

/// The names of the nodes from below the root on, with slashes between them.
std::string pathOf(const aiScene& scene, const aiNode& node) {
    constexpr int kDeepest = 256; // which only a graph with cycles reaches
    std::string path;
    const aiNode* at = &node;
    for (int depth = 0; at != nullptr && at != scene.mRootNode && depth < kDeepest; ++depth) {
        const std::string name = at->mName.C_Str();
        if (!name.empty()) path = path.empty() ? name : name + "/" + path;
        at = at->mParent;
    }
    return path;
}

/// The name of the object, as its author sees it; the meshes of one node, which differ in their material, go
/// by that.
std::string nameOf(const Instance& instance, const aiScene& scene) {
    const aiMesh& mesh = *scene.mMeshes[instance.mesh];
    const std::string path = pathOf(scene, *instance.node);
    std::string name = path.empty() ? mesh.mName.C_Str() : "";
    if (instance.node->mNumMeshes > 1 && instance.material < scene.mNumMaterials) {
        const aiMaterial* const material = scene.mMaterials[instance.material];
        const std::string own = material != nullptr ? material->GetName().C_Str() : "";
        if (!own.empty()) name = own;
    }
    return path.empty() || name.empty() ? path + name : path + "/" + name;
}

/// Of morph targets in a pose: nothing where the file animates none. Geometries are moved before Assimp reads
/// them, so that it reads such a file twice.
ColladaWeights weightsInPose(const std::filesystem::path& path, const PoseChoice& choice) {
    if (choice.kind == PoseChoice::Kind::Rest) return {};
    const std::optional<std::string> text = colladaForAssimp(path);
    if (!text || text->find(kWeightNode) == std::string::npos) return {};
    Assimp::Importer importer;
    ImportReport report; // that of the second time counts
    const aiScene& scene = readScene(importer, path, true, {}, report);
    const FormatQuirks quirks = quirksOf(formatOf(importer));
    ScenePose pose(scene, quirks);
    pose.choose(choice, report);
    ColladaWeights weights;
    for (unsigned i = 0; scene.mRootNode != nullptr && i < scene.mRootNode->mNumChildren; ++i) {
        const aiNode* const node = scene.mRootNode->mChildren[i];
        if (node != nullptr && std::string_view(node->mName.C_Str()).starts_with(kWeightNode))
            weights[node->mName.C_Str()] = static_cast<float>(pose.localOf(*node).m[0][3]);
    }
    return weights;
}

FileImport sceneAsItLies(const std::filesystem::path& path, const FileImportOptions& options) {
    std::vector<FbxElement> fbx = isFbx(path) ? readFbxElements(path) : std::vector<FbxElement>();
    refuseManyNodes(path, fbx, options.memoryLimit);
    const auto importer = std::make_shared<Assimp::Importer>();
    FileImport result;
    const bool animated = options.pose.kind != PoseChoice::Kind::Rest;
    const aiScene& scene =
        readScene(*importer, path, animated, weightsInPose(path, options.pose), result.report);
    options.alive();
    result.source = importer;
    FormatQuirks quirks = quirksOf(formatOf(*importer));
    if (quirks.fbxNotes && fbx.empty()) fbx = readFbxElements(path);
    if (quirks.md5 && animated) quirks.statedTicks = md5FrameRate(path);
    result.report.origin = originOf(path, formatOf(*importer), quirks, scene);
    const std::string application = fbxApplication(fbx);
    quirks.displayColours =
        hasDisplayColours(application.empty() ? result.report.origin.exporter : application);
    ScenePose pose(scene, quirks);
    pose.choose(options.pose, result.report);
    const FbxNotes notes = fbxNotesOf(fbx);
    HiddenNodes hidden(scene, notes);
    NodeWalk walk = walkNodes(scene, pose, options.origin, hidden);
    setInstanceMaterials(scene, notes, walk, result.report);
    result.coarseness = walk.coarseness;
    MeshAssembler assembler;
    makeRoom(scene, walk, options.memoryLimit, assembler);

    const SceneEmbeddedPictures embedded(scene);
    TextureStore textures(result.model, result.report, path.parent_path(), embedded, options.alive);
    Materials materials(scene, walk, {quirks, MaterialTexts(path)}, result, textures);
    const MorphWeights weights(pose, notes);
    MeshPoser poser(walk.transforms, quirks, pose, weights);
    MeshReader reader(quirks, poser, result.report);
    for (const Instance& instance : walk.instances) {
        const aiMesh& mesh = *scene.mMeshes[instance.mesh];
        if (!options.origin.isZero())
            result.coarseness = std::max(result.coarseness, coarsenessOf(mesh, instance.toWorld));
        SourceMesh source = reader.read(mesh, instance, materials.texcoordUse(instance.material));
        if (source.triangles.empty()) continue;
        source.material = materials.numberOf(instance.material);
        const std::uint32_t first = assembler.triangleCount();
        assembler.add(source);
        result.model.parts.push_back(
            {result.model.addName(nameOf(instance, scene)), first, assembler.triangleCount() - first});
        options.alive();
    }
    finishGeometry(assembler, options.creaseAngle, options.origin, result);
    const std::optional<Sentence> cut = cutOff(path);
    if (cut && result.model.triangles.empty()) refuse(*cut);
    refuseUseless(assembler, scene.mNumMeshes, result);

    if (cut) addWarning(result.report, *cut);
    warnOfLostTriangles(result.model, result.report);
    warnOfFiles(path, formatOf(*importer), result.report);
    poser.warn(result.report);
    warnOfMissingTextures(textures.missing(), result.report);
    warnWhenInvisible(result.model, result.report);
    warnOfOutliers(result.model, result.report);
    Box3 bounds;
    for (const Vertex& v : result.model.vertices) bounds.extend(v.position());
    addLights(scene, walk.transforms, quirks, bounds, result.model, result.report);
    addCameras(scene, walk.transforms, quirks, result.model, result.report);
    return result;
}

} // namespace

FileImport importWithAssimp(const std::filesystem::path& path, const FileImportOptions& options) {
    return readNearZero(sceneAsItLies, path, options);
}

} // namespace rtcore
