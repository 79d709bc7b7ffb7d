#include "rtcore/io/import/assimp/scene_pose.h"

#include "rtcore/io/import/assimp/assimp_parts.h"
#include "rtcore/io/import/import_forms.h"
#include "rtcore/io/import/pose/animation_choice.h"
#include "rtcore/io/import/pose/key_frames.h"

#include <assimp/anim.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rtcore {

namespace {

/// Key times are numbers and do not go back.
template <typename Key>
bool isInOrder(const Key* keys, unsigned count) {
    if (count > 0 && keys == nullptr) return false;
    for (unsigned i = 0; i < count; ++i)
        if (!std::isfinite(keys[i].mTime) || (i > 0 && keys[i].mTime < keys[i - 1].mTime)) return false;
    return true;
}

bool isSound(const aiNodeAnim& channel) {
    return isInOrder(channel.mPositionKeys, channel.mNumPositionKeys) &&
           isInOrder(channel.mRotationKeys, channel.mNumRotationKeys) &&
           isInOrder(channel.mScalingKeys, channel.mNumScalingKeys);
}

aiVector3D vectorAt(const aiVectorKey* keys, unsigned count, double ticks) {
    const KeyInterval at = keyInterval(count, ticks, [&](std::size_t i) { return keys[i].mTime; });
    const aiVector3D &a = keys[at.from].mValue, &b = keys[at.to].mValue;
    const auto between = [&](float from, float to) {
        return static_cast<float>(double{from} + at.part * (double{to} - double{from}));
    };
    return {between(a.x, b.x), between(a.y, b.y), between(a.z, b.z)};
}

Rotation rotationOf(const aiQuaternion& q) { return {double{q.x}, double{q.y}, double{q.z}, double{q.w}}; }

Rotation unitRotation(Rotation q) {
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    if (!(length > 0) || !std::isfinite(length)) return {0, 0, 0, 1};
    for (double& v : q) v /= length;
    return q;
}

Rotation rotationAt(const aiQuatKey* keys, unsigned count, double ticks) {
    const KeyInterval at = keyInterval(count, ticks, [&](std::size_t i) { return keys[i].mTime; });
    return slerp(unitRotation(rotationOf(keys[at.from].mValue)), unitRotation(rotationOf(keys[at.to].mValue)),
                 at.part);
}

Affine composed(const aiVector3D& translation, const Rotation& rotation, const aiVector3D& scale) {
    const auto [x, y, z, w] = rotation;
    const double r[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                            {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                            {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
    Affine a;
    for (unsigned row = 0; row < 3; ++row) {
        for (unsigned column = 0; column < 3; ++column)
            a.m[row][column] = r[row][column] * double{scale[column]};
        a.m[row][3] = double{translation[row]};
    }
    return a;
}

/// Of a channel without keys of a kind, what the node has.
Affine localAt(const aiNodeAnim& channel, const aiNode& node, double ticks) {
    aiVector3D translation, scale(1, 1, 1);
    aiQuaternion turn;
    node.mTransformation.Decompose(scale, turn, translation);
    Rotation rotation = unitRotation(rotationOf(turn));
    if (channel.mNumPositionKeys > 0)
        translation = vectorAt(channel.mPositionKeys, channel.mNumPositionKeys, ticks);
    if (channel.mNumRotationKeys > 0)
        rotation = rotationAt(channel.mRotationKeys, channel.mNumRotationKeys, ticks);
    if (channel.mNumScalingKeys > 0) scale = vectorAt(channel.mScalingKeys, channel.mNumScalingKeys, ticks);
    return composed(translation, unitRotation(rotation), scale);
}

struct Beginning {
    double ticks = std::numeric_limits<double>::infinity();
    template <typename Key>
    void add(const Key* keys, unsigned count) {
        if (count > 0 && keys != nullptr && std::isfinite(keys[0].mTime))
            ticks = std::min(ticks, keys[0].mTime);
    }
};

/// Of the first key of all.
double beginningOf(const aiAnimation& animation) {
    Beginning begin;
    for (unsigned i = 0; i < animation.mNumChannels; ++i) {
        const aiNodeAnim& channel = *animation.mChannels[i];
        begin.add(channel.mPositionKeys, channel.mNumPositionKeys);
        begin.add(channel.mRotationKeys, channel.mNumRotationKeys);
        begin.add(channel.mScalingKeys, channel.mNumScalingKeys);
    }
    for (unsigned i = 0; i < animation.mNumMorphMeshChannels; ++i)
        begin.add(animation.mMorphMeshChannels[i]->mKeys, animation.mMorphMeshChannels[i]->mNumKeys);
    return std::isfinite(begin.ticks) ? begin.ticks : 0;
}

/// The first node of each name, as Assimp finds them.
std::map<std::string, const aiNode*> nodesByName(const aiScene& scene) {
    std::map<std::string, const aiNode*> nodes;
    constexpr std::size_t kMaxNodes = 4'000'000; // more has only a graph with cycles
    std::vector<const aiNode*> open{scene.mRootNode};
    for (std::size_t visited = 0; !open.empty() && visited < kMaxNodes; ++visited) {
        const aiNode* const node = open.back();
        open.pop_back();
        if (node == nullptr) continue;
        nodes.try_emplace(node->mName.C_Str(), node);
        for (unsigned i = node->mNumChildren; i-- > 0;) open.push_back(node->mChildren[i]);
    }
    return nodes;
}

/// The weights of each target of a channel, by time.
std::map<unsigned, std::vector<std::pair<double, double>>> keysByTarget(const aiMeshMorphAnim& channel) {
    std::map<unsigned, std::vector<std::pair<double, double>>> keys;
    for (unsigned i = 0; i < channel.mNumKeys; ++i) {
        const aiMeshMorphKey& key = channel.mKeys[i];
        for (unsigned k = 0; k < key.mNumValuesAndWeights; ++k)
            keys[key.mValues[k]].emplace_back(key.mTime, key.mWeights[k]);
    }
    return keys;
}

} // namespace

Affine affineOf(const aiMatrix4x4& m) {
    Affine a;
    a.m = {{{m.a1, m.a2, m.a3, m.a4}, {m.b1, m.b2, m.b3, m.b4}, {m.c1, m.c2, m.c3, m.c4}}};
    return a;
}

ScenePose::ScenePose(const aiScene& scene, const FormatQuirks& quirks) : scene_(scene), quirks_(quirks) {}

void ScenePose::choose(const PoseChoice& choice, ImportReport& report) {
    std::vector<const aiAnimation*> animations;
    std::vector<std::string> names;
    for (unsigned i = 0; i < scene_.mNumAnimations; ++i) {
        if (scene_.mAnimations[i] == nullptr) continue;
        animations.push_back(scene_.mAnimations[i]);
        names.emplace_back(scene_.mAnimations[i]->mName.C_Str());
    }
    const auto number = animationOf(choice, names, report);
    if (!number) return;
    const aiAnimation& animation = *animations[*number];
    const double otherwise =
        animation.mTicksPerSecond > 0 ? animation.mTicksPerSecond : quirks_.ticksPerSecond;
    const double rate = quirks_.statedTicks.value_or(otherwise);
    const bool first = choice.kind == PoseChoice::Kind::First;
    move(animation, first ? beginningOf(animation) : choice.seconds * rate);
    if (damagedChannels_ > 0) addWarning(report, say(import_forms::kBrokenChannels, damagedChannels_));
}

void ScenePose::move(const aiAnimation& animation, double ticks) {
    moveNodes(animation, ticks);
    moveTargets(animation, ticks);
}

void ScenePose::moveNodes(const aiAnimation& animation, double ticks) {
    const std::map<std::string, const aiNode*> nodes = nodesByName(scene_);
    for (unsigned i = 0; i < animation.mNumChannels; ++i) {
        const aiNodeAnim& channel = *animation.mChannels[i];
        const auto node = nodes.find(channel.mNodeName.C_Str());
        if (!isSound(channel)) {
            ++damagedChannels_;
        } else if (node != nodes.end()) {
            moved_[node->second] = localAt(channel, *node->second, ticks);
        }
    }
}

void ScenePose::moveTargets(const aiAnimation& animation, double ticks) {
    for (unsigned i = 0; i < animation.mNumMorphMeshChannels; ++i) {
        const aiMeshMorphAnim& channel = *animation.mMorphMeshChannels[i];
        if (!isInOrder(channel.mKeys, channel.mNumKeys)) {
            ++damagedChannels_;
            continue;
        }
        for (const auto& [target, keys] : keysByTarget(channel)) {
            const KeyInterval at =
                keyInterval(keys.size(), ticks, [&list = keys](std::size_t k) { return list[k].first; });
            const double from = keys[at.from].second, to = keys[at.to].second;
            weights_[channel.mName.C_Str()][target] = from + at.part * (to - from);
        }
    }
}

Affine ScenePose::localOf(const aiNode& node) const {
    const auto moved = moved_.find(&node);
    return moved != moved_.end() ? moved->second : affineOf(node.mTransformation);
}

std::optional<double> ScenePose::animatedWeight(const aiNode& node, unsigned target) const {
    if (weights_.empty()) return std::nullopt;
    const std::string name = node.mName.C_Str();
    for (const std::string& key : {name, name + "*0"}) { // FBX says which of the node's meshes it is
        const auto channel = weights_.find(key);
        if (channel == weights_.end()) continue;
        const auto weight = channel->second.find(target);
        if (weight != channel->second.end()) return weight->second;
    }
    return std::nullopt;
}

/// By the names of the mesh and its node, with as many targets.
const FbxMorphs* MorphWeights::fbxMorphsOf(const aiMesh& mesh, const aiNode& node) const {
    const std::string meshName = mesh.mName.C_Str(), nodeName = node.mName.C_Str();
    const FbxMorphs* best = nullptr;
    for (const FbxMorphs& morphs : fbx_.morphs) {
        if (morphs.targetCount() != mesh.mNumAnimMeshes) continue;
        const bool ofNode = std::ranges::find(morphs.nodes, nodeName) != morphs.nodes.end();
        if (!ofNode && morphs.mesh != meshName) continue;
        if (ofNode && (morphs.mesh == meshName || morphs.mesh.empty())) return &morphs;
        if (best == nullptr) best = &morphs;
    }
    return best;
}

std::vector<double> MorphWeights::of(const aiMesh& mesh, const aiNode& node) const {
    std::vector<double> weights;
    for (unsigned i = 0; i < mesh.mNumAnimMeshes; ++i)
        weights.push_back(mesh.mAnimMeshes[i] != nullptr ? double{mesh.mAnimMeshes[i]->mWeight} : 0);
    if (const FbxMorphs* const morphs = fbxMorphsOf(mesh, node)) {
        weights.clear();
        for (unsigned c = 0; c < morphs->channels.size(); ++c) {
            const FbxMorphChannel& channel = morphs->channels[c];
            const double at = pose_.animatedWeight(node, c).value_or(channel.position);
            for (const double weight : channel.weightsAt(at)) weights.push_back(weight);
        }
        return weights;
    }
    for (unsigned i = 0; i < weights.size(); ++i)
        weights[i] = pose_.animatedWeight(node, i).value_or(weights[i]);
    return weights;
}

} // namespace rtcore
