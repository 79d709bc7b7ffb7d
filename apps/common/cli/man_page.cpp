#include "common/cli/man_page.h"

#include "common/cli/command_names.h"
#include "common/cli/help_text.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace app {

namespace {

constexpr std::array<const char*, 6> kPrograms = {"BSPBuilder", "CUI",      "GUI",
                                                  "Renderer",   "RTBridge", "RTServer"};

// Roff's own characters; a minus that it may not take for a hyphen.
std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
        case '\\':
            result += "\\e";
            break;
        case '-':
            result += "\\-";
            break;
        case '\'':
            result += "\\(aq";
            break;
        case '`':
            result += "\\(ga";
            break;
        case '^':
            result += "\\(ha";
            break;
        case '~':
            result += "\\(ti";
            break;
        default:
            result += c;
        }
    }
    return result;
}

// A paragraph: a line must not begin as a request does.
std::string line(std::string_view text) {
    const std::string result = escaped(text);
    return (result.starts_with('.') ? "\\&" : "") + result + "\n";
}

std::string bold(std::string_view text) { return "\\fB" + escaped(text) + "\\fR"; }
std::string italic(std::string_view text) { return "\\fI" + escaped(text) + "\\fR"; }
std::string section(std::string_view title) { return ".SH " + std::string(title) + "\n"; }

std::string manEntry(const std::string& label, std::string_view text) {
    return ".TP\n" + (label.starts_with('.') ? "\\&" + label : label) + "\n" + line(text);
}

// "Renders a scene, quickly. See CUI." becomes "renders a scene".
std::string summary(const std::string& purpose) {
    std::string text = purpose.substr(0, std::min(purpose.find(". "), purpose.find(", ")));
    if (text.ends_with('.')) text.pop_back();
    if (!text.empty()) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    return text;
}

std::string optionLabel(const Option& option) {
    std::string label;
    for (const std::string& spelling : optionSpellings(option)) {
        label += (label.empty() ? "" : ", ") + bold(spelling);
    }
    if (option.value != ValueKind::None) label += "=" + italic(option.argument);
    return label;
}

// Literal words in bold, placeholders in italics.
std::string commandLabel(const std::string& label) {
    std::string result;
    for (std::size_t i = 0; i < label.size();) {
        const bool place = isPlaceholder(label.substr(i, 1));
        const bool letter =
            place || std::islower(static_cast<unsigned char>(label[i])) != 0 || label[i] == '-';
        std::size_t end = i + 1;
        while (letter && end < label.size() &&
               (std::isalnum(static_cast<unsigned char>(label[end])) != 0 || label[end] == '-')) {
            ++end;
        }
        const std::string_view part = std::string_view(label).substr(i, end - i);
        result += place ? italic(part) : letter ? bold(part) : escaped(part);
        i = end;
    }
    return result;
}

std::string synopsis(const ProgramSpec& spec) {
    std::string text = bold(spec.name);
    for (const Positional& positional : spec.positionals) {
        const std::string name = italic(positional.name) + (positional.repeats ? "..." : "");
        text += positional.optional ? " [" + name + "]" : " " + name;
    }
    return text + " [" + italic("OPTION") + "]...\n";
}

std::string entries(std::string_view title, std::span<const HelpWord> rows) {
    if (rows.empty()) return "";
    std::string text = section(title);
    for (const HelpWord& row : rows) text += manEntry(bold(row.label), row.help);
    return text;
}

std::string options(const ProgramSpec& spec) {
    std::string commands, text;
    for (const OptionGroup& group : spec.groups) {
        for (const HelpWord& word : group.words) commands += manEntry(commandLabel(word.label), word.help);
        if (group.options.empty()) continue;
        text += ".SS " + escaped(group.title) + "\n";
        for (const Option& option : group.options) text += manEntry(optionLabel(option), option.help);
    }
    return (commands.empty() ? "" : section("COMMANDS") + commands) + section("OPTIONS") + text;
}

std::string examples(const ProgramSpec& spec) {
    if (spec.examples.empty()) return "";
    std::string text = section("EXAMPLES");
    for (const Example& example : spec.examples) text += manEntry(bold(example.command), example.meaning);
    return text;
}

std::string seeAlso(const ProgramSpec& spec) {
    std::string text;
    for (const char* program : kPrograms) {
        if (program == spec.name) continue;
        text += (text.empty() ? ".BR " : " ,\n.BR ") + std::string(program) + " (1)";
    }
    return section("SEE ALSO") + text + "\n";
}

} // namespace

std::string manPage(const ProgramSpec& program) {
    const ProgramSpec spec = withStandardOptions(program);
    std::string text =
        ".TH " + spec.name + " 1 \"\" \"rtsuite " + suiteVersion() + "\" \"User Commands\"\n.ad l\n.nh\n";
    text += section("NAME") + line(spec.name + " - " + summary(spec.purpose));
    text += section("SYNOPSIS") + synopsis(spec);
    text += section("DESCRIPTION") + line(spec.purpose);
    if (!spec.positionals.empty()) text += section("ARGUMENTS");
    for (const Positional& positional : spec.positionals)
        text += manEntry(italic(positional.name), positional.help);
    text += options(spec);
    text += entries("EXIT STATUS", exitCodeNotes());
    text += entries("ENVIRONMENT", spec.environment);
    text += entries("FILES", spec.files);
    return text + examples(spec) + seeAlso(spec);
}

} // namespace app
