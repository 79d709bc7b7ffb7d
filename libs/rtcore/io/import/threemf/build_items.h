/// Objects that a 3MF package says are to be built, and where they stand.
#pragma once

#include "rtcore/io/import/threemf/model_part.h"
#include "rtcore/io/import/threemf/package.h"

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rtcore::threemf {

/// A mesh where it stands.
struct PlacedObject {
    const PartContent* part = nullptr;
    const Object* object = nullptr;
    Affine toWorld;
    std::string name; ///< of the objects from the item down, joined by slashes
};

/// All parts of a package that are reached from its root.
class BuildItems {
  public:
    /// Reads the parts. Throws FileError BadData where the root or a part is missing or damaged, or an object
    /// holds itself, as readModelPart() does, and std::bad_alloc.
    explicit BuildItems(Package& package);

    const PartContent& root() const { return *root_; }
    const std::map<std::string, PartContent>& parts() const { return parts_; }

    std::uint64_t triangles() const { return all_.triangles; } ///< with all instances; stops at 2^62
    std::uint64_t objects() const { return all_.objects; }     ///< the same of what walk() visits
    /// Components that name an object that does not exist.
    std::uint64_t lost() const { return lost_; }
    /// Calls `use` for each mesh that has triangles, in the order of the items.
    void walk(const std::function<void(const PlacedObject&)>& use) const;

  private:
    struct Count {
        std::uint64_t triangles = 0, objects = 0;
        void add(const Count& other);
    };
    using Key = std::pair<const PartContent*, std::uint32_t>;

    const PartContent* partOf(Package& package, std::string_view name);
    void readReferences(Package& package);
    void showUnbuilt();
    Count countOf(const PartContent& part, const Component& component, int depth);
    std::pair<const PartContent*, const Object*> target(const PartContent& part,
                                                        const Component& component) const;
    void visit(const PlacedObject& at, const std::function<void(const PlacedObject&)>& use) const;

    std::map<std::string, PartContent> parts_; ///< by partKey()
    const PartContent* root_ = nullptr;
    std::vector<Component> items_;
    std::map<Key, Count> counts_;
    std::map<Key, bool> open_; ///< while its components are counted
    Count all_;
    std::uint64_t lost_ = 0;
};

} // namespace rtcore::threemf
