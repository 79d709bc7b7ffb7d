/// A table of a text file as its reader asks for it: by key, type and range. What does not fit is an error
/// with file, line and column, and so is every unknown key.
#pragma once

#include "rtcore/io/text/text_value.h"
#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/scene/local_origin.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

/// The range of a number, compared after it was rounded to float. Not a number and infinity are always
/// refused.
struct Limits {
    double minimum = -3.4028234663852886e38, maximum = 3.4028234663852886e38;
    bool minimumExcluded = false, maximumExcluded = false;
};
inline constexpr Limits kAnyNumber{};
inline constexpr Limits kNotNegative{.minimum = 0};
inline constexpr Limits kPositive{.minimum = 0, .minimumExcluded = true};
inline constexpr Limits kUnitRange{.minimum = 0, .maximum = 1};
inline constexpr Limits kCoordinate{.minimum = -1e12, .maximum = 1e12};

/// Use: ask for every key that the format knows, call finish(), then check what must be there.
/// An absent key is nullopt. All functions throw FileError BadData. Keeps references to what it was made
/// from.
class StrictTable {
  public:
    /// `table` must hold a TextTable.
    StrictTable(const TextValue& table, const std::string& file);

    std::optional<bool> boolean(std::string_view key);
    std::optional<int> integer(std::string_view key, int minimum, int maximum);
    std::optional<std::vector<int>> integers(std::string_view key, int minimum, int maximum);
    std::optional<float> number(std::string_view key, const Limits& limits);
    std::optional<double> preciseNumber(std::string_view key, const Limits& limits);
    std::optional<std::string> text(std::string_view key);
    /// The number of the name in `names`.
    std::optional<std::size_t> choice(std::string_view key, std::span<const std::string_view> names);
    std::optional<Vec3> vector(std::string_view key);
    /// Three coordinates, or one of them along an axis, as seen from the zero of readOrigin().
    std::optional<Vec3> position(std::string_view key);
    /// The same in doubles, at most 1e12 from zero.
    std::optional<FilePoint> precisePosition(std::string_view key);
    /// Such positions in brackets.
    std::optional<std::vector<FilePoint>> positions(std::string_view key);
    std::optional<float> height(std::string_view key, Vec3 up);
    std::optional<Colour> colour(std::string_view key, const Limits& limits);
    /// A number means grey.
    std::optional<Colour> colourOrNumber(std::string_view key, const Limits& limits);
    std::optional<std::vector<bool>> booleans(std::string_view key);
    std::optional<std::vector<std::string>> texts(std::string_view key);
    /// Joined to `folder`; an absolute path stays.
    std::optional<std::filesystem::path> path(std::string_view key, const std::filesystem::path& folder);
    std::optional<std::vector<std::filesystem::path>> paths(std::string_view key,
                                                            const std::filesystem::path& folder);
    std::optional<StrictTable> table(std::string_view key);
    /// An array of tables, [[key]]; empty when absent.
    std::vector<StrictTable> tables(std::string_view key);
    /// The value as it is, or null.
    const TextValue* value(std::string_view key);

    /// The root of a file of this suite: `version = n` must be there, 1 <= n <= newest. Tables that are asked
    /// for afterwards know it.
    void checkVersion(int newest = 1);
    /// The key `origin` of the root: from where its positions count. Positions of tables that are asked for
    /// afterwards are then seen from `zero`, or where there is none from `origin`. Returns the one that
    /// holds.
    LocalOrigin readOrigin(const std::optional<LocalOrigin>& zero);
    /// Refuses the key in a file of an older version than that which brought it.
    void needVersion(int version, std::string_view key) const;
    /// Refuses the first key that was not asked for, and names the nearest that was.
    void finish() const;
    template <typename T>
    T require(std::string_view key, const std::optional<T>& value) const {
        if (!value) failMissing(key);
        return *value;
    }
    /// Refuses the value of `key`, or the table when it has no such key.
    [[noreturn]] void fail(std::string_view key, const Sentence& message) const;
    [[noreturn]] void failMissing(std::string_view key) const;

    const std::string& file() const { return *file_; }

  private:
    const TextEntry* find(std::string_view key) const;
    template <typename T>
    const T* typed(std::string_view key, const Sentence& wanted);
    FilePoint shifted(FilePoint point) const;
    StrictTable within(const TextValue& table) const;

    const TextValue* table_;
    const std::string* file_;
    int version_ = 1;
    FilePoint shift_{}; ///< what to add to positions
    std::vector<std::string_view> asked_;
};

} // namespace rtcore
