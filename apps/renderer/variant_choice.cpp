#include "renderer/variant_choice.h"

#include "rtcore/io/loading/file_kind.h"
#include "rtcore/io/text/scn.h"
#include "rtcore/io/variants/variant_switch.h"
#include "rtcore/platform/error.h"
#include "rtcore/platform/sentence.h"
#include "rtcore/settings/plain_text.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

namespace renderer {

namespace {

constexpr std::string_view kAll = "all", kNone = "none";

rtcore::SceneVariants variantsOf(const std::filesystem::path& scene) {
    rtcore::InputFile file(scene);
    if (rtcore::kindOfFile(scene, file) != rtcore::FileKind::Scene) return {};
    return rtcore::readSceneFile(scene).variants;
}

[[noreturn]] void refuse(const std::string& name, const rtcore::SceneVariants& variants,
                         const std::filesystem::path& scene) {
    std::string names;
    for (const rtcore::SceneVariant& each : variants)
        names += (names.empty() ? "" : ", ") + rtcore::inQuotes(each.name);
    throw rtcore::FileError(
        rtcore::FailureKind::NoInput, scene.string(),
        variants.empty()
            ? rtcore::say("it has no variant {0}, nor any other; a .scn has them", rtcore::inQuotes(name))
            : rtcore::say("it has no variant {0}, but {1}", rtcore::inQuotes(name), names));
}

bool isWordOfFile(char c) {
    const auto code = static_cast<unsigned char>(c);
    constexpr unsigned char kFirstOfUtf8 = 0x80;
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || code >= kFirstOfUtf8;
    return letter || (c >= '0' && c <= '9') || c == '.' || c == '_';
}

} // namespace

std::string fileWordOf(const std::string& name) {
    std::string word = name;
    std::ranges::replace_if(
        word, [](char c) { return !isWordOfFile(c); }, '-');
    return word;
}

std::filesystem::path withWord(const std::filesystem::path& path, const std::string& word) {
    if (word.empty()) return path;
    return path.parent_path() / (path.stem().string() + '_' + word + path.extension().string());
}

std::vector<RendererOptions> runsOf(const RendererOptions& options) {
    if (!options.variant) return {options};
    const rtcore::SceneVariants variants = variantsOf(options.scene);
    const bool known = rtcore::findVariant(variants, *options.variant) != variants.end();
    const bool all = !known && *options.variant == kAll && !variants.empty();
    if (!known && !all && (*options.variant != kNone || variants.empty()))
        refuse(*options.variant, variants, options.scene);
    if (!all) return {options};
    std::vector<RendererOptions> runs;
    std::set<std::string> words;
    for (const rtcore::SceneVariant& each : variants) {
        RendererOptions& run = runs.emplace_back(options);
        run.variant = each.name;
        run.outputWord = fileWordOf(each.name);
        for (int i = 2; !words.insert(run.outputWord).second; ++i)
            run.outputWord = fileWordOf(each.name) + '-' + std::to_string(i);
    }
    return runs;
}

void showVariant(const RendererOptions& options, rtcore::LoadedScene& loaded) {
    if (!loaded.sceneFile || loaded.sceneFile->variants.empty()) return;
    const rtcore::SceneFile& file = *loaded.sceneFile;
    rtcore::RenderSettings settings;
    rtcore::applySettings(settings, loaded.still);
    const rtcore::VariantScene base{loaded.scene, settings.skyLight.on};
    const rtcore::SceneVariant none;
    rtcore::VariantScene shown = base;
    switchVariant(shown, base, none, shownVariant(file));
    const auto find = [&](const std::string& name) -> const rtcore::SceneVariant& {
        const auto found = rtcore::findVariant(file.variants, name);
        return found != file.variants.end() ? *found : none;
    };
    if (options.variant) switchVariant(shown, base, find(file.activeVariant), find(*options.variant));
    loaded.scene = std::move(shown.scene);
    if (shown.skyLight != base.skyLight) loaded.still.push_back({"skyLight.on", shown.skyLight});
}

} // namespace renderer
