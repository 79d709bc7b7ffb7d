/// Text in TOML, which the readers of this folder read back to the same values, bit for bit.
#pragma once

#include "rtcore/math/colour.h"
#include "rtcore/math/vec.h"
#include "rtcore/scene/local_origin.h"
#include "rtcore/settings/settings_table.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rtcore {

/// shortestText as a TOML float: "70.0". Not a number and infinity give text that every reader refuses.
std::string tomlNumber(double value);
/// The fewest digits that a reader by way of double turns into the same float.
std::string tomlNumber(float value);
/// In double quotes, with quotes, backslashes and what has a controlCode() escaped. What is no UTF-8 stays,
/// and no reader takes it.
std::string tomlString(std::string_view text);

/// Line by line, in the order of the calls.
class TomlWriter {
  public:
    /// "[live]" or "[[light]]", after a blank line.
    void section(std::string_view header);

    void add(std::string_view key, bool value);
    void add(std::string_view key, int value);
    void add(std::string_view key, float value);
    void add(std::string_view key, double value);
    void add(std::string_view key, std::string_view value);
    void add(std::string_view key, Vec3 value);
    void add(std::string_view key, const FilePoint& value);
    void add(std::string_view key, const std::vector<FilePoint>& values);
    /// In the coordinates in which that of the scene's zero is `zero`.
    void addPosition(std::string_view key, Vec3 value, const LocalOrigin& zero);
    /// Nothing when it is zero.
    void add(std::string_view key, const LocalOrigin& value);
    void add(std::string_view key, Colour value);
    void add(std::string_view key, const std::vector<bool>& values);
    void add(std::string_view key, const std::vector<int>& values);
    void add(std::string_view key, const std::vector<std::string>& values);
    void add(std::string_view key, const SettingValue& value);
    void add(std::string_view key, const char* value) { add(key, std::string_view(value)); }
    void add(std::string_view key, const std::string& value) { add(key, std::string_view(value)); }
    /// Nothing when there is no value.
    template <typename T>
    void add(std::string_view key, const std::optional<T>& value) {
        if (value) add(key, *value);
    }

    const std::string& text() const { return text_; }

  private:
    void line(std::string_view key, std::string_view value);

    std::string text_;
};

} // namespace rtcore
