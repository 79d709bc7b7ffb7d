#include "rtcore/io/import/threemf/build_items.h"

#include "rtcore/io/import/threemf/model_part_reader.h"
#include "rtcore/io/import/threemf/xml_events.h"
#include "rtcore/platform/error.h"

#include <algorithm>
#include <set>

namespace rtcore::threemf {

namespace {

constexpr std::string_view kUsualRoot = "3D/3dmodel.model";
constexpr std::string_view kRelations = "_rels/.rels";

[[noreturn]] void refuseBuild(const Sentence& why) { throw FileError(FailureKind::BadData, "", why); }

class RootFinder : public XmlEvents {
  public:
    void begin(const XmlElement& e) override {
        if (e.name() == "Relationship" && e.text("Type").ends_with("/3dmodel") && root.empty())
            root = e.text("Target");
    }
    void end(XmlName /*name*/) override {}
    std::string root;
};

/// By the relations of the package, else by its usual name, else the first by name.
std::string rootOf(Package& package) {
    if (package.has(kRelations)) {
        RootFinder finder;
        XmlReader reader(finder, std::string(kRelations));
        package.read(kRelations, [&](std::span<const char> piece) { reader.read(piece); });
        reader.finish();
        if (package.has(finder.root)) return finder.root;
    }
    if (package.has(kUsualRoot)) return std::string(kUsualRoot);
    for (const auto& [key, name] : package.parts())
        if (key.ends_with(".model")) return name;
    refuseBuild(say("there is no 3MF model inside; unpack it and give the model inside"));
}

} // namespace

void BuildItems::Count::add(const Count& other) {
    constexpr std::uint64_t kMax = std::uint64_t{1} << 62U;
    triangles = std::min(triangles + other.triangles, kMax);
    objects = std::min(objects + other.objects, kMax);
}

BuildItems::BuildItems(Package& package) {
    root_ = partOf(package, rootOf(package));
    items_ = root_->items;
    if (items_.empty()) showUnbuilt();
    readReferences(package);
    for (const Component& item : items_) all_.add(countOf(*root_, item, 0));
}

const PartContent* BuildItems::partOf(Package& package, std::string_view name) {
    const auto [at, isNew] = parts_.try_emplace(partKey(name));
    if (isNew) at->second = readModelPart(package, name);
    return &at->second;
}

/// Parts may name further parts.
void BuildItems::readReferences(Package& package) {
    std::set<std::string> known;
    std::vector<std::string> names;
    const auto note = [&](const Component& c) {
        if (!c.part.empty() && known.insert(partKey(c.part)).second) names.push_back(c.part);
    };
    const auto noteAll = [&](const PartContent& part) {
        for (const auto& [id, object] : part.objects)
            for (const Component& component : object.components) note(component);
    };
    for (const Component& item : items_) note(item);
    noteAll(*root_);
    for (std::size_t i = 0; i < names.size(); ++i) noteAll(*partOf(package, std::string(names[i])));
}

/// Objects that are no parts of others, of a file that builds nothing.
void BuildItems::showUnbuilt() {
    std::set<std::uint32_t> inside;
    for (const auto& [id, object] : root_->objects)
        for (const Component& component : object.components) inside.insert(component.object);
    for (const auto& [id, object] : root_->objects)
        if (!inside.contains(id)) items_.push_back({"", id, {}});
}

std::pair<const PartContent*, const Object*> BuildItems::target(const PartContent& part,
                                                                const Component& component) const {
    const PartContent* in = &part;
    if (!component.part.empty()) {
        const auto at = parts_.find(partKey(component.part));
        if (at == parts_.end()) return {nullptr, nullptr};
        in = &at->second;
    }
    const auto object = in->objects.find(component.object);
    return {in, object == in->objects.end() ? nullptr : &object->second};
}

BuildItems::Count BuildItems::countOf(const PartContent& part, const Component& component, int depth) {
    constexpr int kMaxDepth = 1000;
    const auto [in, object] = target(part, component);
    if (object == nullptr) {
        ++lost_;
        return {};
    }
    const Key key{in, component.object};
    if (const auto known = counts_.find(key); known != counts_.end()) return known->second;
    if (open_[key] || depth > kMaxDepth)
        refuseBuild(say("its object {0} holds itself, or others in more than {1} levels; export it again",
                        component.object, kMaxDepth));
    open_[key] = true;
    Count count{object->triangles.size(), 1};
    for (const Component& inner : object->components) count.add(countOf(*in, inner, depth + 1));
    open_[key] = false;
    return counts_[key] = count;
}

void BuildItems::visit(const PlacedObject& at, const std::function<void(const PlacedObject&)>& use) const {
    if (!at.object->triangles.empty()) use(at);
    for (const Component& component : at.object->components) {
        const auto [part, object] = target(*at.part, component);
        if (object == nullptr || counts_.at({part, component.object}).triangles == 0) continue;
        const bool both = !at.name.empty() && !object->name.empty();
        visit({part, object, at.toWorld * component.transform, at.name + (both ? "/" : "") + object->name},
              use);
    }
}

void BuildItems::walk(const std::function<void(const PlacedObject&)>& use) const {
    for (const Component& item : items_) {
        const auto [part, object] = target(*root_, item);
        if (object != nullptr) visit({part, object, item.transform, object->name}, use);
    }
}

} // namespace rtcore::threemf
