#include "rtcore/io/import/assimp/mesh_poser.h"

#include "rtcore/io/import/import_forms.h"
#include "rtcore/io/import/pose/vertex_joints.h"

#include <assimp/mesh.h>
#include <assimp/scene.h>

#include <cmath>
#include <set>
#include <string_view>

namespace rtcore {

namespace {

/// Fewer are not worth the threads.
constexpr std::size_t kMinForThreads = 50'000;

Vec3 vectorOf(const aiVector3D& v) { return {v.x, v.y, v.z}; }

void copyLists(const aiMesh& mesh, bool normals, PosedMesh& to) {
    to.positions.clear();
    to.normals.clear();
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) to.positions.push_back(vectorOf(mesh.mVertices[i]));
    for (unsigned i = 0; normals && i < mesh.mNumVertices; ++i)
        to.normals.push_back(vectorOf(mesh.mNormals[i]));
}

/// Adds the way from `base` (or from 0) to `target`.
void addWay(std::vector<Vec3>& list, const aiVector3D* target, const aiVector3D* base, float weight) {
    for (std::size_t i = 0; i < list.size(); ++i) {
        const Vec3 way = base != nullptr ? vectorOf(target[i]) - vectorOf(base[i]) : vectorOf(target[i]);
        list[i] = list[i] + weight * way;
    }
}

std::size_t firstVertex(const aiMesh& mesh) {
    const bool there = mesh.mNumFaces > 0 && mesh.mFaces != nullptr && mesh.mFaces[0].mNumIndices > 0 &&
                       mesh.mFaces[0].mIndices[0] < mesh.mNumVertices;
    return there ? mesh.mFaces[0].mIndices[0] : 0;
}

/// A node that Assimp made of the offset of a geometry from its node.
bool isGeometric(const aiNode& node) {
    const std::string_view name = node.mName.C_Str();
    return name.find("_$AssimpFbx$_Geometric") != std::string_view::npos && !name.ends_with("Inverse");
}

} // namespace

struct MeshPoser::Skin {
    std::vector<Affine> joints; ///< from the mesh to the world
    std::vector<JointWeight> weights;
};

bool MeshPoser::morph(const aiMesh& mesh, const aiNode& node) {
    if (mesh.mNumAnimMeshes == 0 || mesh.mAnimMeshes == nullptr) return false;
    const bool relative = mesh.mMethod == aiMorphingMethod_MORPH_RELATIVE;
    const std::vector<double> weights = weights_.of(mesh, node);
    bool moves = false;
    for (std::size_t i = 0; i < weights.size() && i < mesh.mNumAnimMeshes; ++i) {
        const auto weight = static_cast<float>(weights[i]);
        if (weight == 0 || !std::isfinite(weight)) continue;
        const aiAnimMesh* const target = mesh.mAnimMeshes[i];
        if (target == nullptr || target->mVertices == nullptr || target->mNumVertices != mesh.mNumVertices) {
            ++brokenTargets_;
            continue;
        }
        moves = true;
        addWay(posed_.positions, target->mVertices, relative ? nullptr : mesh.mVertices, weight);
        if (target->mNormals != nullptr)
            addWay(posed_.normals, target->mNormals, relative ? nullptr : mesh.mNormals, weight);
    }
    return moves;
}

/// The offset of the geometry from its node counts before its skin does (FBX).
Affine MeshPoser::geometricOf(const aiNode& node) const {
    Affine offset;
    for (const aiNode* at = node.mParent; at != nullptr && isGeometric(*at); at = at->mParent)
        offset = pose_.localOf(*at) * offset;
    return offset;
}

MeshPoser::Skin MeshPoser::skinOf(const aiMesh& mesh, const aiNode& node) {
    Skin skin;
    if (!quirks_.bindMatrices || mesh.mBones == nullptr) return skin;
    const Affine geometric = geometricOf(node);
    std::set<const aiBone*> known; // Assimp may hand over one twice
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
        const aiBone* const bone = mesh.mBones[b];
        if (bone == nullptr || bone->mWeights == nullptr || bone->mNumWeights == 0) continue;
        if (!known.insert(bone).second) continue;
        const auto joint = transforms_.find(bone->mName.C_Str());
        if (joint == transforms_.end()) {
            ++lostJoints_;
            continue;
        }
        const auto number = static_cast<std::uint32_t>(skin.joints.size());
        skin.joints.push_back(joint->second * affineOf(bone->mOffsetMatrix) * geometric);
        for (unsigned w = 0; w < bone->mNumWeights; ++w)
            skin.weights.push_back({bone->mWeights[w].mVertexId, number, bone->mWeights[w].mWeight});
    }
    return skin;
}

const PosedMesh* MeshPoser::pose(const aiMesh& mesh, const aiNode& node, const Affine& toWorld) {
    if (mesh.mNumBones == 0 && mesh.mNumAnimMeshes == 0) return nullptr;
    copyLists(mesh, mesh.mNormals != nullptr && !quirks_.facetNormals, posed_);
    const bool morphs = morph(mesh, node);
    const Skin skin = skinOf(mesh, node);
    if (!morphs && skin.joints.empty()) return nullptr;
    const VertexJoints joints(skin.weights, mesh.mNumVertices);
    const Affine first = joints.of(firstVertex(mesh), skin.joints, toWorld);
    posed_.mirrored = first.determinant() < 0;
#pragma omp parallel for schedule(static) if (posed_.positions.size() > kMinForThreads)
    for (std::size_t i = 0; i < posed_.positions.size(); ++i) {
        const Affine at = joints.of(i, skin.joints, toWorld);
        posed_.positions[i] = at.point(posed_.positions[i]);
        if (!posed_.normals.empty()) posed_.normals[i] = at.normal(posed_.normals[i]);
    }
    return &posed_;
}

void MeshPoser::warn(ImportReport& report) const {
    if (lostJoints_ > 0) addWarning(report, say(import_forms::kLostJoints, lostJoints_));
    if (brokenTargets_ > 0) addWarning(report, say(import_forms::kBrokenTargets, brokenTargets_));
}

} // namespace rtcore
