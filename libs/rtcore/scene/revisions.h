/// The changes of what is shown, and their order: by them frames and caches tell whether they still hold.
/// They lie beside the scene, since whatever is kept of one (shadow maps, a frame before, samples that add
/// up) must be able to ask, in a program that serves or in one that does not.
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <utility>

namespace rtcore {

/// A kind of change, by what it leaves valid.
enum class Change : std::uint8_t {
    Scene,      ///< another scene is shown: nothing of the last one holds; all other kinds come with it
    View,       ///< the camera: the scene and its light are the same
    Light,      ///< a light was switched, moved, coloured, added or removed
    Sky,        ///< what surrounds the surfaces: environment map, background, ambient light, fog
    Material,   ///< what surfaces do with light; the edit sees to Scene::closed, too
    Visibility, ///< parts of the model are hidden or shown: rays meet other triangles
    Section,    ///< a plane cuts the model open: rays meet its triangles on one side only
    Setting,    ///< the settings of the image, its size included
};
inline constexpr std::size_t kChanges = static_cast<std::size_t>(Change::Setting) + 1;

/// A set of kinds.
class Changes {
  public:
    Changes() = default;
    Changes(std::initializer_list<Change> kinds) {
        for (const Change kind : kinds) set(kind);
    }
    static Changes all() {
        Changes changes;
        changes.kinds_.set();
        return changes;
    }

    void set(Change kind, bool on = true) { kinds_.set(static_cast<std::size_t>(kind), on); }
    bool has(Change kind) const { return kinds_.test(static_cast<std::size_t>(kind)); }
    bool hasAny(const Changes& of) const { return (kinds_ & of.kinds_).any(); }
    bool any() const { return kinds_.any(); }
    friend bool operator==(const Changes&, const Changes&) = default;

  private:
    std::bitset<kChanges> kinds_;
};

/// Counts the edits of what is shown. One that edits notes what it changed; each subscriber keeps the number
/// of the revision that it knows, and asks what changed since. One thread; several may read while none notes.
class Revisions {
  public:
    /// The revision that is shown now; 0 before anything was. It never falls.
    std::uint64_t revision() const { return revision_; }
    /// An edit changed these: that is one revision more. Without any kind there was no edit.
    void note(const Changes& changes) {
        if (!changes.any()) return;
        ++revision_;
        for (std::size_t kind = 0; kind < kChanges; ++kind) {
            if (changes.has(static_cast<Change>(kind))) last_[kind] = revision_;
        }
    }
    /// All that changed after that revision; after 0: all that was ever noted.
    Changes since(std::uint64_t revision) const {
        Changes changes;
        for (std::size_t kind = 0; kind < kChanges; ++kind)
            changes.set(static_cast<Change>(kind), last_[kind] > revision);
        return changes;
    }

  private:
    std::uint64_t revision_ = 0;
    std::uint64_t last_[kChanges] = {}; ///< the last revision that changed the kind
};

/// The revision that a subscriber knows already. One thread.
class Subscription {
  public:
    /// The changes since the last call; at the first one, since the beginning.
    Changes take(const Revisions& revisions) {
        return revisions.since(std::exchange(seen_, revisions.revision()));
    }

  private:
    std::uint64_t seen_ = 0;
};

} // namespace rtcore
