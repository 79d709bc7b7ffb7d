/// THE table of settings: what settings/render_settings.h holds, by name. File readers, command lines,
/// dialogs, messages between processes and the manual all read this table.
#pragma once

#include "rtcore/settings/render_settings.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rtcore {

/// The value of one setting. An enumerator goes by its name ("automatic").
using SettingValue = std::variant<bool, int, float, std::string>;

inline constexpr double kUnlimited = 3.4028234663852886e38; ///< the largest float

enum class SettingType { Boolean, Integer, Number, Choice };

/// The results that a change of a setting invalidates; each includes all that follow but Pace.
enum class SettingChange {
    Light,   ///< the radiance of surfaces, which live frames keep
    Samples, ///< which of it an image has: its size, its rays
    Display, ///< how radiance is shown
    Pace,    ///< nothing: only how fast, or with how much noise, the same image comes about
};

/// The values that a page in a browser may ask for.
struct BrowserRange {
    double minimum = -kUnlimited, maximum = kUnlimited; ///< beside those of the setting
    bool offered = true;                                ///< false: pages have no such row
};

/// One row. The views are valid for the whole run of the program.
struct Setting {
    std::string_view name; ///< "width"; with a dot where the struct is nested: "ambientOcclusion.samples"
    /// The group that it is shown in: the part of the name before the dot, else the one in the table; "" =
    /// the image as a whole.
    std::string_view group;
    SettingType type;
    SettingValue defaultValue; ///< what a default RenderSettings holds
    double minimum, maximum;   ///< Integer and Number: inclusive; a maximum of kUnlimited is none
    std::string_view unit;     ///< "pixels"; "" when it has none
    std::string_view help;     ///< one line
    std::span<const std::string_view> choices; ///< Choice: names in the order of the enumeration
    /// Integer and Number, where 0 is no amount: the word for it, which is taken in its place: "automatic",
    /// "off"; else "".
    std::string_view zero;

    SettingValue (*get)(const RenderSettings&);
    void (*set)(RenderSettings&, const SettingValue&); ///< takes only what checkSetting() returns

    std::string_view liveChoice =
        {};                      ///< Choice: the only one of the live view, others are for stills; "": any
    std::string_view label = {}; ///< what it is called where its name says too little (settingLabel())
    SettingChange changes = SettingChange::Light;
    std::optional<Integrator> integrator = {}; ///< the only one that uses it
    BrowserRange browser = {};

    /// Images that differ in it are different images; else one may go on where the other ended.
    bool isOfImage() const { return changes == SettingChange::Light || changes == SettingChange::Samples; }
};

/// All rows, in the order in which they are shown. Safe from many threads.
std::span<const Setting> settingsTable();

/// A name that a setting had before: still read wherever a setting is named, never written.
struct FormerName {
    std::string_view former, name;
};
std::span<const FormerName> formerSettingNames();

/// The row of that name, or of the one that had it before; or null.
const Setting* findSetting(std::string_view name);

/// The same. Throws std::invalid_argument that tells the nearest known name.
const Setting& requireSetting(std::string_view name);

/// `value` as the setting's own type (a whole number is taken where a Number is wanted, and the word for 0).
/// Throws std::invalid_argument that tells the type, range or choices when the value is of another type, out
/// of range or not finite.
SettingValue checkSetting(const Setting& setting, const SettingValue& value);

/// Reads the value from text, as the command line gives it: true/false, on/off, yes/no, 1/0; decimal numbers
/// or the word for 0; names of choices. Throws as checkSetting does.
SettingValue parseSetting(const Setting& setting, std::string_view text);

/// By name. They throw std::invalid_argument as above and leave `settings` as it was.
void setSetting(RenderSettings& settings, std::string_view name, const SettingValue& value);
void setSettingFromText(RenderSettings& settings, std::string_view name, std::string_view text);
SettingValue getSetting(const RenderSettings& settings, std::string_view name);

/// Throws std::invalid_argument that tells what to use where the live view is to draw with a value that is
/// for stills only.
void checkLive(const Setting& setting, const SettingValue& value);
void checkLive(const RenderSettings& settings);

/// A setting and the value that a file or a command line gives it.
struct SettingAssignment {
    std::string name; ///< as in the table, where readers made it
    SettingValue value;
    friend bool operator==(const SettingAssignment&, const SettingAssignment&) = default;
};
/// In order, so that the last one wins. Throws as setSetting does.
void applySettings(RenderSettings& settings, std::span<const SettingAssignment> assignments);
/// One assignment for every setting that differs from a default RenderSettings; for all with `everything`.
std::vector<SettingAssignment> settingAssignments(const RenderSettings& settings, bool everything);

/// The names of settings that `asked` gives another value than the default, and that the integrator of
/// `settings` does not use; in the order of the table.
std::vector<std::string_view> unusedSettings(const RenderSettings& settings,
                                             std::span<const SettingAssignment> asked);

/// Whether light of surfaces that is known by `a` holds by `b`: all settings that change it are the same.
bool sameLight(const RenderSettings& a, const RenderSettings& b);

/// The English label of a setting, a group of them, a choice or the word for 0: "Brighter seconds" for
/// "exposure.brighterSeconds", "Image" for "".
std::string settingLabel(std::string_view name);

/// The value as parseSetting reads it; numbers in the fewest digits that keep every bit.
std::string settingText(const SettingValue& value);

/// The values that the setting takes, for help and messages: "1 to 32768", "at least 0, or automatic", "true
/// or false", "automatic or fixed".
std::string settingRange(const Setting& setting);

} // namespace rtcore
