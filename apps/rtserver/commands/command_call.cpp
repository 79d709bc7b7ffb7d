#include "rtserver/commands/command_call.h"

#include "common/cli/command_line.h"

#include "rtcore/io/text/sentence_json.h"
#include "rtcore/motion/key_codes.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/settings/number_text.h"
#include "rtcore/settings/plain_text.h"
#include "rtcore/settings/settings_table.h"

#include <fmt/format.h>

#include <optional>

namespace rtserver {

float number(const std::string& text) { return static_cast<float>(preciseNumber(text)); }
double preciseNumber(const std::string& text) { return app::parseNumber(text).value(); }
int integer(const std::string& text) { return static_cast<int>(app::parseInteger(text).value()); }
bool flag(const std::string& text) { return text == "on"; }

rtcore::Vec3 vectorAt(const Call& call, std::size_t i) {
    return {number(call[i]), number(call[i + 1]), number(call[i + 2])};
}

rtcore::Vec3 positionAt(const Call& call, std::size_t i) {
    return call.document().scene()->origin.local(
        {preciseNumber(call[i]), preciseNumber(call[i + 1]), preciseNumber(call[i + 2])});
}

std::string positionText(const Call& call, rtcore::Vec3 p) {
    const rtcore::LocalOrigin& origin = call.document().scene()->origin;
    if (origin.isZero())
        return fmt::format("{} {} {}", rtcore::settingText(p.x), rtcore::settingText(p.y),
                           rtcore::settingText(p.z));
    const auto [x, y, z] = origin.inFile(p);
    return fmt::format("{} {} {}", rtcore::shortestText(x), rtcore::shortestText(y), rtcore::shortestText(z));
}

int keyOf(const std::string& name) {
    const std::optional<int> code = rtcore::keyNamed(name);
    if (!code) {
        throw app::UsageError(
            rtcore::say("unknown key {0}; there are letters, digits, Space, Left, Right, Up, Down, Shift, "
                        "Control, CapsLock and others",
                        rtcore::inQuotes(name)));
    }
    return *code;
}

std::filesystem::path pathOf(const std::string& text) {
    std::filesystem::path path(text);
    if (!path.is_absolute())
        throw app::UsageError(rtcore::say("the path {0} is not absolute", rtcore::inQuotes(text)));
    return path;
}

Answer warningAnswer(const rtcore::Sentence& warning) {
    if (warning.empty()) return {};
    const rtcore::Sentence told = rtcore::say("warning: {0}", warning);
    return {told.english(), rtcore::sentenceJson(told)};
}

void refuseInput(const app::InputFiles& inputs, const std::filesystem::path& path,
                 std::string_view replaces) {
    const auto input = inputs.find(path);
    if (input && (replaces.empty() || input->extension() != replaces)) inputs.refuse(path);
}

} // namespace rtserver
