/// The tables of docs/manual.md are made from those of the programs: options, exit codes, keys.
/// RT_RENEW_DOCS=1 in the environment writes them anew.
#include "bspbuilder/builder_spec.h"
#include "common/cli/command_names.h"
#include "common/cli/help_text.h"
#include "cui/cui_spec.h"
#include "gui/gui_spec.h"
#include "renderer/renderer_spec.h"
#include "rtserver/server_options.h"
#include "support/document_section.h"

#include "rtcore/motion/key_bindings.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace {

const std::string kPage = RT_DOCUMENTS "/manual.md";

const std::array<app::ProgramSpec, 5>& programs() {
    static const std::array all = {
        app::withStandardOptions(bspbuilder::builderSpec()),
        app::withStandardOptions(renderer::rendererSpec()), app::withStandardOptions(rtserver::serverSpec()),
        app::withStandardOptions(cui::cuiSpec()), app::withStandardOptions(gui::guiSpec())};
    return all;
}

std::string labelOf(const app::Option& option) {
    std::string label;
    for (const std::string& spelling : app::optionSpellings(option))
        label += (label.empty() ? "" : ", ") + spelling;
    return "`" + label + (option.argument.empty() ? "" : "=" + option.argument) + "`";
}

std::string meaningOf(const app::Option& option) {
    return option.help + (option.more.empty() ? "" : ". " + option.more);
}

bool isSame(const app::Option& one, const app::Option& other) {
    return one.name == other.name && meaningOf(one) == meaningOf(other);
}

/// The names of the programs that have this option, with the same meaning.
std::vector<std::string> programsWith(const app::Option& option) {
    std::vector<std::string> names;
    for (const app::ProgramSpec& program : programs()) {
        const app::Option* own = program.find(option.name);
        if (own != nullptr && isSame(*own, option)) names.push_back(program.name);
    }
    return names;
}

bool isCommon(const app::Option& option) { return programsWith(option).size() > 1; }

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

/// Each once, those of most programs first.
std::vector<app::Option> commonOptions() {
    std::vector<app::Option> all;
    for (const app::ProgramSpec& program : programs()) {
        for (const app::OptionGroup& group : program.groups) {
            for (const app::Option& option : group.options) {
                const bool known = std::any_of(all.begin(), all.end(),
                                               [&](const app::Option& each) { return isSame(each, option); });
                if (!known && isCommon(option)) all.push_back(option);
            }
        }
    }
    std::stable_sort(all.begin(), all.end(), [](const app::Option& one, const app::Option& other) {
        return programsWith(one).size() > programsWith(other).size();
    });
    return all;
}

TEST(ManualTables, OfOptionsOfSeveralPrograms) {
    std::string table = test::tableRow({"option", "of", ""}) + "|---|---|---|\n";
    for (const app::Option& option : commonOptions()) {
        const std::vector<std::string> names = programsWith(option);
        table += test::tableRow(
            {labelOf(option), names.size() == programs().size() ? "all" : joined(names), meaningOf(option)});
    }
    test::expectSection(kPage, "options of several programs", table);
}

TEST(ManualTables, OfOptions) {
    for (const app::ProgramSpec& program : programs()) {
        for (const app::OptionGroup& group : program.groups) {
            std::string rows;
            for (const app::Option& option : group.options) {
                if (!isCommon(option)) rows += test::tableRow({labelOf(option), meaningOf(option)});
            }
            if (!rows.empty())
                test::expectSection(kPage, program.name + ": " + group.title,
                                    test::tableRow({"option", ""}) + "|---|---|\n" + rows);
        }
    }
}

TEST(ManualTables, OfExitCodes) {
    std::string table = test::tableRow({"exit code", ""}) + "|---|---|\n";
    for (const app::HelpWord& code : app::exitCodeNotes()) table += test::tableRow({code.label, code.help});
    test::expectSection(kPage, "exit codes", table);
}

std::string keysOf(const rtcore::KeyBinding& binding) {
    const std::string key = rtcore::keyName(binding.key);
    return binding.with == rtcore::KeyNone ? key : rtcore::keyName(binding.with) + "+" + key;
}

TEST(ManualTables, OfKeys) {
    std::string table = test::tableRow({"action", "keys"}) + "|---|---|\n";
    for (std::size_t i = 0; i < rtcore::kActions; ++i) {
        const auto action = static_cast<rtcore::Action>(i);
        std::map<int, std::string> keys; // by the number of the light or environment map
        for (const rtcore::KeyBinding& each : rtcore::defaultKeyBindings()) {
            if (each.action != action) continue;
            std::string& known = keys[each.number];
            known += (known.empty() ? "" : ", ") + keysOf(each);
        }
        std::string text;
        for (const auto& [number, names] : keys) text += (text.empty() ? "" : ", ") + names;
        const std::string name(rtcore::actionName(action));
        table += test::tableRow({"`" + name + (rtcore::hasNumber(action) ? " N`" : "`"), text});
    }
    test::expectSection(kPage, "keys", table);
}

} // namespace
