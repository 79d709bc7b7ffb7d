#include "rtcore/io/text/settings_section.h"

#include "rtcore/math/nearest_float.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace rtcore {

namespace {

class SectionReader {
  public:
    SectionReader(const std::string& file, bool live) : file_(file), live_(live) {}

    /// Recursion ends where names of the settings table end: two levels.
    void read(const TextTable& table, const std::string& prefix) {
        for (const TextEntry& entry : table.entries) {
            const std::string name = prefix + entry.key;
            const auto* nested = std::get_if<TextTable>(&entry.value.content);
            if (nested != nullptr && isGroup(name)) {
                read(*nested, name + ".");
            } else {
                assign(name, entry);
            }
        }
    }

    std::vector<SettingAssignment> assignments;

  private:
    struct Given {
        const Setting* setting;
        std::string name; ///< as the file has it
        TextPosition position;
    };

    static bool isGroup(const std::string& name) {
        const auto table = settingsTable();
        return std::any_of(table.begin(), table.end(),
                           [&](const Setting& setting) { return setting.name.starts_with(name + "."); });
    }

    void assign(const std::string& name, const TextEntry& entry) {
        const Setting& setting = at(entry.position, [&]() -> const Setting& { return requireSetting(name); });
        refuseTwice({&setting, name, entry.position});
        assignments.push_back({std::string(setting.name), at(entry.value.position, [&] {
                                   return checked(setting, convert(name, entry.value));
                               })});
    }

    SettingValue checked(const Setting& setting, const SettingValue& value) const {
        SettingValue taken = checkSetting(setting, value);
        if (live_) checkLive(setting, taken);
        return taken;
    }

    /// A name stands once in TOML, so a setting that is given twice is so by its former name as well.
    void refuseTwice(const Given& given) {
        for (const Given& before : given_) {
            if (before.setting != given.setting) continue;
            const Given& former = before.name == given.setting->name ? given : before;
            throw FileError(FailureKind::BadData, file_,
                            say("{0} is the former name of {1}, which stands here, too; remove {0}",
                                former.name, given.setting->name),
                            former.position.line, former.position.column);
        }
        given_.push_back(given);
    }

    /// Turns a refusal by the settings table into an error at its position in the file.
    template <typename Work>
    std::invoke_result_t<Work> at(TextPosition position, Work work) const {
        try {
            return work();
        } catch (const std::invalid_argument& error) {
            throw FileError(FailureKind::BadData, file_, sentenceOf(error), position.line, position.column);
        }
    }

    static SettingValue convert(const std::string& name, const TextValue& value) {
        if (const auto* flag = std::get_if<bool>(&value.content)) return *flag;
        if (const auto* text = std::get_if<std::string>(&value.content)) return *text;
        if (const auto* number = std::get_if<double>(&value.content)) return nearestFloat(*number);
        if (const auto* whole = std::get_if<std::int64_t>(&value.content)) return toNumber(*whole);
        throw BadValue(say("{0} is {1}, but takes one value", name, describeType(value)));
    }

    static SettingValue toNumber(std::int64_t whole) {
        const bool fits =
            whole >= std::numeric_limits<int>::min() && whole <= std::numeric_limits<int>::max();
        if (fits) return static_cast<int>(whole);
        return static_cast<float>(whole);
    }

    const std::string& file_;
    bool live_;
    std::vector<Given> given_;
};

} // namespace

std::vector<SettingAssignment> readSettingsSection(StrictTable& parent, std::string_view key) {
    const TextValue* value = parent.value(key);
    if (value == nullptr) return {};
    const auto* table = std::get_if<TextTable>(&value->content);
    if (table == nullptr)
        parent.fail(key,
                    say("{0} is {1}, but takes {2}", key, describeType(*value), say("a table, [{0}]", key)));
    SectionReader reader(parent.file(), key == "live");
    reader.read(*table, "");
    return std::move(reader.assignments);
}

void writeSettingsSection(TomlWriter& writer, std::string_view key,
                          std::span<const SettingAssignment> assignments) {
    if (assignments.empty()) return;
    writer.section("[" + std::string(key) + "]");
    for (const SettingAssignment& assignment : assignments) {
        const Setting* setting = findSetting(assignment.name);
        writer.add(setting != nullptr ? setting->name : assignment.name, assignment.value);
    }
}

} // namespace rtcore
