#include "rtcore/io/import/assimp/fbx_notes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace rtcore {

namespace {

using Id = std::int64_t;

/// The objects of a file, and which of them belong to which.
class FbxObjects {
  public:
    explicit FbxObjects(const std::vector<FbxElement>& elements) {
        for (const FbxElement& part : elements) {
            for (const FbxElement& each : part.children) {
                if (part.name == "Objects")
                    objects_.emplace(each.id(0), &each);
                else if (each.text(0) == "OO")
                    parts_[each.id(2)].push_back(each.id(1));
            }
        }
    }

    /// Null where there is none.
    const FbxElement* find(Id id) const {
        const auto found = objects_.find(id);
        return found != objects_.end() ? found->second : nullptr;
    }
    /// Of one kind, in the order of the file; `kind` "": all that have any.
    std::vector<Id> partsOf(Id id, std::string_view element, std::string_view kind = "") const {
        std::vector<Id> list;
        const auto found = parts_.find(id);
        if (found == parts_.end()) return list;
        for (const Id part : found->second) {
            const FbxElement* const object = find(part);
            if (object != nullptr && object->name == element && (kind.empty() || object->text(2) == kind))
                list.push_back(part);
        }
        return list;
    }
    const std::map<Id, const FbxElement*>& all() const { return objects_; }

  private:
    std::map<Id, const FbxElement*> objects_;
    std::map<Id, std::vector<Id>> parts_;
};

std::optional<double> propertyOf(const FbxElement& object, std::string_view name) {
    const FbxElement* const list = object.child("Properties70");
    if (list == nullptr) return std::nullopt;
    for (const FbxElement& property : list->children)
        if (property.text(0) == name && property.values.size() > 4) return property.number(4);
    return std::nullopt;
}

/// Follows the models as Assimp makes nodes of them.
class Visibility {
  public:
    Visibility(const FbxObjects& objects, FbxNotes& notes) : objects_(objects), notes_(notes) {}

    void walk() {
        std::vector<Open> open;
        push(0, "", false, open);
        std::size_t visited = 0;
        while (!open.empty() && ++visited <= kMaxNodes) {
            const Open at = std::move(open.back());
            open.pop_back();
            const FbxElement& model = *objects_.find(at.id);
            const bool inherits = propertyOf(model, "Visibility Inheritance").value_or(1) != 0;
            const bool below =
                at.outside || (at.hidden && inherits) || propertyOf(model, "Visibility").value_or(1) == 0;
            const bool own = below || propertyOf(model, "Show").value_or(1) == 0;
            const std::string path = at.path + "/" + model.text(1);
            notes_.hidden[path].push_back(own ? 1 : 0);
            notes_.hidesSome |= own;
            if (at.depth < kDeepest) pushChildren(at, path, below, open);
        }
        if (!notes_.hidesSome) notes_.hidden.clear();
    }

  private:
    static constexpr std::size_t kMaxNodes = 4'000'000; // more has only a graph with cycles
    static constexpr int kDeepest = 256;
    struct Open {
        Id id;
        std::string path;
        bool hidden;  ///< a node above it is
        bool outside; ///< a level of detail that is not shown
        int depth;
    };

    void push(Id parent, const std::string& path, bool hidden, std::vector<Open>& open, int depth = 0,
              std::optional<Id> shownLevel = {}, bool outside = false) const {
        const std::vector<Id> children = objects_.partsOf(parent, "Model");
        for (std::size_t i = children.size(); i-- > 0;) {
            const bool otherLevel = shownLevel && children[i] != *shownLevel;
            open.push_back({children[i], path, hidden, outside || otherLevel, depth});
        }
    }

    void pushChildren(const Open& at, const std::string& path, bool hidden, std::vector<Open>& open) const {
        std::optional<Id> level;
        if (isLevelGroup(at.id)) level = firstLevel(at.id);
        push(at.id, path, hidden, open, at.depth + 1, level, at.outside);
    }

    bool isLevelGroup(Id id) const {
        return objects_.find(id)->text(2) == "LodGroup" ||
               !objects_.partsOf(id, "NodeAttribute", "LodGroup").empty();
    }

    /// The first that is not hidden itself.
    std::optional<Id> firstLevel(Id group) const {
        for (const Id child : objects_.partsOf(group, "Model"))
            if (propertyOf(*objects_.find(child), "Visibility").value_or(1) != 0) return child;
        return std::nullopt;
    }

    const FbxObjects& objects_;
    FbxNotes& notes_;
};

std::vector<double> fullPositions(const FbxElement& channel, std::size_t shapes) {
    std::vector<double> full;
    if (const FbxElement* element = channel.child("FullWeights")) {
        if (const FbxElement* const list = element->child("a")) element = list;
        for (std::size_t i = 0; i < element->values.size(); ++i) full.push_back(element->number(i) / 100);
    }
    // Some write weights of vertices there.
    const bool rises = std::ranges::adjacent_find(full, std::ranges::greater_equal{}) == full.end();
    if (shapes > 1 && full.size() == shapes && rises && full.front() > 0) return full;
    full.clear();
    for (std::size_t i = 0; i < shapes; ++i)
        full.push_back(static_cast<double>(i + 1) / static_cast<double>(shapes));
    return full;
}

FbxMorphChannel channelOf(const FbxObjects& objects, Id id) {
    const FbxElement& stated = *objects.find(id);
    FbxMorphChannel channel;
    const FbxElement* const percent = stated.child("DeformPercent");
    const double otherwise = percent != nullptr ? percent->number(0) : 0;
    channel.position = propertyOf(stated, "DeformPercent").value_or(otherwise) / 100;
    if (!std::isfinite(channel.position)) channel.position = 0;
    for (const Id shape : objects.partsOf(id, "Geometry", "Shape"))
        channel.targets.push_back(objects.find(shape)->text(1));
    channel.full = fullPositions(stated, channel.targets.size());
    return channel;
}

void addMaterials(const FbxObjects& objects, FbxNotes& notes) {
    std::map<std::string, int> times;
    for (const auto& [id, object] : objects.all())
        if (object->name == "Model") ++times[object->text(1)];
    for (const auto& [id, object] : objects.all()) {
        if (object->name != "Model" || times[object->text(1)] > 1) continue;
        std::vector<std::string>& names = notes.materials[object->text(1)];
        for (const Id material : objects.partsOf(id, "Material"))
            names.push_back(objects.find(material)->text(1));
    }
}

FbxMorphs morphsOf(const FbxObjects& objects, Id geometry) {
    FbxMorphs morphs{objects.find(geometry)->text(1), {}, {}};
    for (const Id blend : objects.partsOf(geometry, "Deformer", "BlendShape"))
        for (const Id channel : objects.partsOf(blend, "Deformer", "BlendShapeChannel"))
            morphs.channels.push_back(channelOf(objects, channel));
    return morphs;
}

} // namespace

std::size_t FbxMorphs::targetCount() const {
    std::size_t count = 0;
    for (const FbxMorphChannel& channel : channels) count += channel.full.size();
    return count;
}

std::vector<double> FbxMorphChannel::weightsAt(double at) const {
    std::vector<double> weights(full.size(), 0);
    if (full.empty()) return weights;
    const auto above = std::ranges::upper_bound(full, at);
    const auto i = static_cast<std::size_t>(above - full.begin());
    if (i == 0) {
        weights[0] = at / full[0];
    } else if (i == full.size()) {
        weights.back() = at / full.back();
    } else {
        const double part = (at - full[i - 1]) / (full[i] - full[i - 1]);
        weights[i - 1] = 1 - part;
        weights[i] = part;
    }
    return weights;
}

std::string fbxApplication(const std::vector<FbxElement>& elements) {
    for (const FbxElement& part : elements) {
        const FbxElement* const info = part.name == "FBXHeaderExtension" ? part.child("SceneInfo") : nullptr;
        const FbxElement* const list = info != nullptr ? info->child("Properties70") : nullptr;
        if (list == nullptr) continue;
        for (const FbxElement& property : list->children)
            if (property.text(0) == kFbxApplication) return property.text(4);
    }
    return {};
}

FbxNotes fbxNotesOf(const std::vector<FbxElement>& elements) {
    const FbxObjects objects(elements);
    FbxNotes notes;
    Visibility(objects, notes).walk();
    addMaterials(objects, notes);
    std::map<Id, std::vector<std::string>> nodes; // by geometry
    for (const auto& [id, object] : objects.all()) {
        if (object->name != "Model") continue;
        for (const Id geometry : objects.partsOf(id, "Geometry")) nodes[geometry].push_back(object->text(1));
    }
    for (const auto& [id, object] : objects.all()) {
        if (object->name != "Geometry" || object->text(2) != "Mesh") continue;
        FbxMorphs morphs = morphsOf(objects, id);
        if (morphs.channels.empty()) continue;
        morphs.nodes = nodes[id];
        notes.morphs.push_back(std::move(morphs));
    }
    return notes;
}

} // namespace rtcore
