/// Packages of 3MF: files in a zip archive.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace rtcore::threemf {

/// The name of a part as it is looked up: without a slash before it, with %20 and the like decoded, in small
/// letters.
std::string partKey(std::string_view name);

/// Nothing is unpacked to the disk, and no name of a part leads out of the package. All that is read of one
/// object together is bounded by the file's size, so that a file of a few bytes cannot keep a reader busy.
class Package {
  public:
    /// Throws FileError: BadData for what is no zip archive, and what InputFile throws. `alive` is called now
    /// and then.
    Package(const std::filesystem::path& path, const std::function<void()>& alive);
    ~Package();
    Package(const Package&) = delete;
    Package& operator=(const Package&) = delete;

    bool has(std::string_view name) const { return parts_.contains(partKey(name)); }
    /// Names of all parts, as partKey() writes them, and as the archive does.
    const std::map<std::string, std::string>& parts() const { return names_; }

    /// Unpacks a part from front to back and hands its bytes to `use`. Throws FileError BadData where there
    /// is no such part, it is damaged or locked, or the package unpacks to far more than models do.
    void read(std::string_view name, const std::function<void(std::span<const char>)>& use);
    /// All of a part, of at most `max` bytes. Throws the same, also for a larger one.
    std::string bytes(std::string_view name, std::size_t max);

  private:
    struct Archive;
    struct Position {
        std::uint64_t offset, number; ///< in the list of contents
    };
    void refuseBeyondBudget(std::uint64_t unpacked) const;

    std::unique_ptr<Archive> archive_;
    const std::function<void()>& alive_;
    std::map<std::string, Position> parts_;
    std::map<std::string, std::string> names_;
    std::uint64_t budget_ = 0; ///< bytes that may still be unpacked
};

} // namespace rtcore::threemf
