#include "bridge/tokens.h"

#include "bridge/net/doorkeeper.h"

#include "common/process/private_files.h"

#include "rtcore/platform/error.h"

namespace bridge {

namespace {

bool isToken(const std::string& text) {
    constexpr std::size_t kLeast = 22, kMost = 128;
    const bool plain =
        text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_") ==
        std::string::npos;
    return plain && text.size() >= kLeast && text.size() <= kMost;
}

Tokens tokensOf(const std::string& path) {
    const std::optional<std::string> text = app::readPrivateFile(path);
    if (!text) {
        Tokens tokens{newToken(), newToken()};
        app::writePrivateFile(path, tokens.driver + "\n" + tokens.viewer + "\n");
        return tokens;
    }
    const std::size_t line = std::min(text->find('\n'), text->size());
    const std::string rest = line < text->size() ? text->substr(line + 1) : "";
    Tokens tokens{text->substr(0, line), rest.substr(0, rest.find('\n'))};
    if (isToken(tokens.driver) && isToken(tokens.viewer) && tokens.driver != tokens.viewer) return tokens;
    throw rtcore::FileError(
        rtcore::FailureKind::BadData, path,
        "it takes two lines, the driver's and the viewer's token, of at least 22 letters, "
        "digits, - or _");
}

} // namespace

Tokens openTokens(const std::optional<std::filesystem::path>& file, bool viewOnly) {
    Tokens tokens = file ? tokensOf(file->string()) : Tokens{newToken(), newToken()};
    if (viewOnly) tokens.driver.clear();
    return tokens;
}

} // namespace bridge
