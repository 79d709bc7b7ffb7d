#include "renderer/renderer_options.h"

#include "common/cli/import_options.h"
#include "common/cli/isa_option.h"
#include "common/cli/parent_option.h"
#include "common/cli/threads_option.h"
#include "common/settings/image_size.h"
#include "common/settings/lighting_options.h"
#include "common/settings/setting_option.h"

#include "rtcore/io/drawings/drawing_file.h"
#include "rtcore/io/images/image_file.h"
#include "rtcore/neural/net_files.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

namespace renderer {

namespace {

constexpr std::size_t kDigestDigits = 8; ///< of the example

std::optional<PreviewOptions> readPreview(const app::Arguments& arguments) {
    const auto instance = arguments.text("preview");
    if (!instance) return std::nullopt;
    PreviewOptions preview{.instance = *instance};
    preview.run = static_cast<std::uint64_t>(arguments.integer("run-id").value_or(0));
    preview.linger = arguments.number("linger").value_or(preview.linger);
    return preview;
}

// Options that set settings, by the settings' own names; the range is checked by the table of settings.
struct SettingOption {
    const char* option;
    std::vector<std::pair<const char*, const char*>> assignments; ///< value null = the option's
};

const std::vector<SettingOption>& settingOptions() {
    static const std::vector<SettingOption> table = {
        {"width", {{"width", nullptr}}},
        {"height", {{"height", nullptr}}},
        {"integrator", {{"integrator", nullptr}}},
        {"samples", {{"path.samples", nullptr}}},
        {"antialiasing", {{"antialiasing", nullptr}}},
        {"bloom", {{"bloom.radius", nullptr}}},
        {"denoise", {{"denoise.net", nullptr}}},
        {"ambient-occlusion", {{"ambientOcclusion.on", "true"}}},
        {"no-ambient-occlusion", {{"ambientOcclusion.on", "false"}}},
        {"ao-samples", {{"ambientOcclusion.samples", nullptr}, {"ambientOcclusion.on", "true"}}},
        {"ao-distance", {{"ambientOcclusion.distance", nullptr}, {"ambientOcclusion.on", "true"}}},
        {"exposure", {{"exposure.value", nullptr}, {"exposure.mode", "fixed"}}},
    };
    return table;
}

/// The value of --denoise without the digest of its weights, and that.
std::pair<std::string, std::string> netAndDigest(const std::string& value) {
    const std::size_t at = value.find('@');
    if (at == std::string::npos) return {value, ""};
    const std::string net = value.substr(0, at), digest = value.substr(at + 1);
    if (net == "off" || net == "automatic")
        throw app::UsageError("option '--denoise': a digest is of the weights of small, base or large");
    const bool good = !digest.empty() && digest.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!good)
        throw app::UsageError("option '--denoise': '" + digest +
                              "' is not the beginning of a SHA-256, such as " +
                              std::string(rtcore::fileOf(rtcore::Net::Base).sha256).substr(0, kDigestDigits));
    return {net, digest};
}

void addSize(const std::string& text, std::vector<rtcore::SettingAssignment>& settings) {
    const std::optional<app::ImageSize> size = app::imageSizeOf(text);
    if (!size)
        throw app::UsageError("option '--size': '" + text + "' is no size; there are " +
                              app::imageSizeNames());
    settings.push_back(app::settingOf("size", "width", std::to_string(size->width)));
    settings.push_back(app::settingOf("size", "height", std::to_string(size->height)));
}

std::vector<rtcore::SettingAssignment> readSettings(const app::Arguments& arguments) {
    std::vector<rtcore::SettingAssignment> settings;
    for (const app::Occurrence& given : arguments.options()) {
        if (given.name == "setting") settings.push_back(app::settingOf(given.value));
        if (given.name == "size") addSize(given.value, settings);
        for (const SettingOption& row : settingOptions()) {
            if (given.name != row.option) continue;
            for (const auto& [name, value] : row.assignments) {
                const std::string own =
                    given.name == "denoise" ? netAndDigest(given.value).first : given.value;
                settings.push_back(app::settingOf(given.name, name, value != nullptr ? value : own));
            }
        }
    }
    return settings;
}

std::optional<rtcore::Vec2> readPosition(const app::Arguments& arguments, const char* name) {
    const std::optional<std::string> text = arguments.text(name);
    if (!text) return std::nullopt;
    rtcore::Vec2 position;
    const char* const end = text->data() + text->size();
    const auto [comma, first] = std::from_chars(text->data(), end, position.x);
    bool good = first == std::errc() && comma != end && *comma == ',';
    if (good) {
        const auto [last, second] = std::from_chars(comma + 1, end, position.y);
        good = second == std::errc() && last == end && position.x >= 0 && position.y >= 0;
    }
    if (!good) {
        throw app::UsageError("option '--" + std::string(name) + "': '" + *text +
                              "' is not a position such as 320,240, in pixels");
    }
    return position;
}

std::optional<std::filesystem::path> readPath(const app::Arguments& arguments, const char* name) {
    const std::optional<std::string> text = arguments.text(name);
    return text ? std::optional<std::filesystem::path>(*text) : std::nullopt;
}

void checkLight(const RendererOptions& options, const app::Arguments& arguments) {
    for (const char* ofMaking : {"light-time", "light-size"}) {
        if (!options.makeLight && arguments.has(ofMaking))
            throw app::UsageError("--" + std::string(ofMaking) + " needs --make-light");
    }
    if (!options.makeLight) return;
    if (options.makeLight->extension() != ".light")
        throw app::UsageError("--make-light writes a file of light; give a name that ends in .light");
    for (const char* ofImages :
         {"output", "light", "video", "follow", "verify", "preview", "report", "debug-scene", "chunk"}) {
        if (arguments.has(ofImages))
            throw app::UsageError("--make-light learns light and renders nothing; leave out --" +
                                  std::string(ofImages));
    }
}

template <std::size_t N>
std::size_t indexIn(const std::array<std::string_view, N>& names, std::string_view name) {
    return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
}

std::optional<app::PlanOrder> readPlan(const app::Arguments& arguments) {
    const auto file = readPath(arguments, "plan");
    if (!file) return std::nullopt;
    app::PlanOrder order{.file = *file};
    order.choice.side = static_cast<rtcore::PlanSide>(
        indexIn(rtcore::kPlanSides, arguments.text("plan-from").value_or("above")));
    if (const auto storey = arguments.integer("plan-storey")) order.choice.storey = static_cast<int>(*storey);
    order.choice.floor = arguments.number("plan-floor");
    order.choice.height = arguments.number("plan-height").value_or(order.choice.height);
    order.scale = arguments.number("plan-scale").value_or(order.scale);
    order.dpi = arguments.number("plan-dpi").value_or(order.dpi);
    order.image = static_cast<app::PlanImage>(
        indexIn(app::kPlanImages, arguments.text("plan-image").value_or("lines")));
    order.options.door = arguments.number("plan-door").value_or(order.options.door);
    if (const auto name = arguments.text("plan-paper"))
        order.paper = *std::ranges::find(rtcore::kPaperSizes, *name, &rtcore::PaperSize::name);
    return order;
}

void checkPlan(const RendererOptions& options, const app::Arguments& arguments) {
    for (const char* ofPlans : {"plan-from", "plan-storey", "plan-floor", "plan-height", "plan-scale",
                                "plan-paper", "plan-dpi", "plan-image", "plan-door"}) {
        if (!options.plan && arguments.has(ofPlans))
            throw app::UsageError("--" + std::string(ofPlans) + " needs --plan");
    }
    if (!options.plan) return;
    const auto format = rtcore::drawingFormatOf(options.plan->file);
    if (!format)
        throw app::UsageError(
            "--plan writes a drawing; give a name that ends in .svg, .pdf, .dxf, .png or .tif");
    for (const char* ofPixels : {"plan-dpi", "plan-image"}) {
        if (format != rtcore::DrawingFormat::Image && arguments.has(ofPixels))
            throw app::UsageError("--" + std::string(ofPixels) + " is of a .png or .tif");
    }
    for (const char* ofImages :
         {"output", "list", "make-light", "video", "verify", "preview", "report", "debug-scene"}) {
        if (arguments.has(ofImages))
            throw app::UsageError("--plan makes a drawing alone; leave out --" + std::string(ofImages));
    }
    if (options.plan->choice.side != rtcore::PlanSide::Above) {
        for (const char* ofStoreys : {"plan-storey", "plan-floor", "plan-height", "plan-door"}) {
            if (arguments.has(ofStoreys))
                throw app::UsageError("--" + std::string(ofStoreys) + " is of plans from above");
        }
    }
    if (arguments.has("plan-storey") && arguments.has("plan-floor"))
        throw app::UsageError("--plan-storey and --plan-floor exclude each other");
}

std::optional<FlightOrder> readFlight(const app::Arguments& arguments) {
    const auto name = arguments.text("flight");
    const auto seconds = arguments.number("turntable");
    if (name && seconds) throw app::UsageError("--flight and --turntable exclude each other");
    if (arguments.has("turns") && !seconds) throw app::UsageError("--turns needs --turntable");
    if (name) return FlightOrder{.name = *name, .turntable = {}};
    if (!seconds) return std::nullopt;
    const double turns = arguments.number("turns").value_or(1);
    if (turns == 0) throw app::UsageError("option '--turns': a turntable turns; give a number other than 0");
    return FlightOrder{.name = {}, .turntable = Turntable{*seconds, turns}};
}

void checkFlight(const RendererOptions& options, const app::Arguments& arguments) {
    if (!options.flight) {
        if (options.makeList) throw app::UsageError("--make-list needs --flight or --turntable");
        return;
    }
    if (options.list) throw app::UsageError("--list has its own cameras; leave out --flight and --turntable");
    if (options.camera && !options.flight->turntable)
        throw app::UsageError("--flight and --camera exclude each other: a flight has its cameras");
    if (options.plan)
        throw app::UsageError("--plan makes a drawing alone; leave out --flight and --turntable");
    if (!options.makeList) return;
    for (const char* ofImages :
         {"output", "light", "make-light", "video", "verify", "report", "frames", "chunk"}) {
        if (arguments.has(ofImages))
            throw app::UsageError("--make-list writes cameras and renders nothing; leave out --" +
                                  std::string(ofImages));
    }
}

void checkVariants(const RendererOptions& options, const app::Arguments& arguments) {
    if (options.variant != "all") return;
    for (const char* ofOne : {"preview", "follow", "verify", "video", "report", "make-list", "make-light",
                              "light", "plan", "debug-scene"}) {
        if (arguments.has(ofOne))
            throw app::UsageError("--variant=all makes images of several scenes; leave out --" +
                                  std::string(ofOne) + ", or name one variant");
    }
    if (std::ranges::any_of(options.outputs, isStandardOutput))
        throw app::UsageError("--variant=all writes several files; --output=- is for one image");
}

void checkPanorama(const RendererOptions& options, const app::Arguments& arguments) {
    if (!options.panorama) return;
    if (*options.panorama % 2 != 0)
        throw app::UsageError("--panorama is twice as wide as high; give an even number of pixels");
    for (const char* ofFlat : {"width", "height", "focus-at", "plan", "debug-scene", "stand-by"}) {
        if (arguments.has(ofFlat))
            throw app::UsageError("--panorama shows all directions and has a size of its own; leave out --" +
                                  std::string(ofFlat));
    }
}

void checkSize(const app::Arguments& arguments) {
    if (!arguments.has("size")) return;
    for (const char* other : {"width", "height", "panorama"}) {
        if (arguments.has(other))
            throw app::UsageError("--size is width and height; leave out --" + std::string(other));
    }
}

/// Colours, or the name of an image, which is read: throws what rtcore::readLdrImage() throws.
void readBackdrop(const app::Arguments& arguments, RendererOptions& options) {
    options.alpha = arguments.has("alpha");
    options.groundShadow = arguments.has("ground-shadow");
    if (options.groundShadow && !options.alpha && !arguments.has("backdrop"))
        throw app::UsageError("--ground-shadow needs --alpha or --backdrop: it falls on what is transparent");
    const auto text = arguments.text("backdrop");
    if (!text) return;
    if (options.alpha)
        throw app::UsageError("--backdrop fills what --alpha leaves open; leave one of them out");
    options.backdrop = rtcore::parseBackdropColours(*text);
    if (options.backdrop) return;
    if (text->starts_with('#'))
        throw app::UsageError("option '--backdrop': '" + *text +
                              "' is neither a colour such as #8090a0 nor two such as #ffffff,#8090a0");
    options.backdropFile = *text;
    options.backdrop.emplace(rtcore::readLdrImage(*text));
}

void checkBackground(const RendererOptions& options, const app::Arguments& arguments) {
    const char* const own = options.alpha ? "--alpha" : options.backdrop ? "--backdrop" : nullptr;
    if (own == nullptr) return;
    for (const char* ofOthers : {"plan", "make-light", "make-list", "debug-scene", "verify"}) {
        if (arguments.has(ofOthers))
            throw app::UsageError(std::string(own) + " is of images that are rendered; leave out --" +
                                  ofOthers);
    }
    if (options.alpha && options.video)
        throw app::UsageError(
            "films have no alpha: give --backdrop in place of --alpha, or leave out --video");
}

void checkCombinations(const RendererOptions& options, const app::Arguments& arguments) {
    if (options.list && options.camera) {
        throw app::UsageError("--list and --camera exclude each other: a list names its cameras");
    }
    checkFlight(options, arguments);
    checkPanorama(options, arguments);
    checkBackground(options, arguments);
    checkSize(arguments);
    for (const char* ofFrames : {"frames", "chunk", "verify", "video"}) {
        if (!options.hasFrames() && arguments.has(ofFrames))
            throw app::UsageError("--" + std::string(ofFrames) + " needs --list, --flight or --turntable");
    }
    if (options.follow && !options.list) throw app::UsageError("--follow needs --list");
    if (arguments.has("fps") && !options.video && !options.flight)
        throw app::UsageError("--fps needs --video, --flight or --turntable");
    if (arguments.has("follow-timeout") && !options.follow) {
        throw app::UsageError("--follow-timeout needs --follow");
    }
    if (options.follow && arguments.has("chunk")) {
        throw app::UsageError("--chunk and --follow exclude each other: how long the list gets is not known");
    }
    if (options.verify && (options.video || options.follow || options.force)) {
        throw app::UsageError("--verify renders nothing; leave out --video, --follow and --force");
    }
    if (options.preview && options.hasFrames()) {
        throw app::UsageError("--preview shows one image; leave out --list, --flight and --turntable");
    }
    for (const char* ofPreview : {"run-id", "linger", "stand-by"}) {
        if (!options.preview && arguments.has(ofPreview)) {
            throw app::UsageError("--" + std::string(ofPreview) + " needs --preview");
        }
    }
    if (options.standBy && (!options.outputs.empty() || arguments.has("linger"))) {
        throw app::UsageError(
            "--stand-by shows images as long as they are wanted, and writes none; leave out "
            "--output and --linger");
    }
    if (options.report && (options.standBy || options.verify || options.debugScene)) {
        throw app::UsageError("--report is of images that are rendered; leave out --stand-by, --verify and "
                              "--debug-scene");
    }
    if (options.report && options.report->extension() != ".json") {
        throw app::UsageError("--report writes JSON; give a name that ends in .json");
    }
    if (options.debugScene && (options.hasFrames() || options.preview)) {
        throw app::UsageError("--debug-scene draws one view and renders nothing; leave out --list, --flight, "
                              "--turntable and --preview");
    }
    if (options.debugScene && options.debugScene->extension() != ".obj") {
        throw app::UsageError("--debug-scene writes Wavefront OBJ; give a name that ends in .obj");
    }
    checkVariants(options, arguments);
    checkLight(options, arguments);
    checkPlan(options, arguments);
    const bool toStandardOutput =
        std::any_of(options.outputs.begin(), options.outputs.end(), isStandardOutput);
    if (arguments.has("format") && !toStandardOutput) {
        throw app::UsageError("--format is for --output=-; files are written as their extension says");
    }
}

} // namespace

RendererOptions readRendererOptions(const app::Arguments& arguments) {
    RendererOptions options;
    options.scene = arguments.positionals().at(0);
    for (const std::string& output : arguments.all("output")) options.outputs.emplace_back(output);
    options.standardOutputFormat = arguments.text("format").value_or("png");
    options.camera = readPath(arguments, "camera");
    options.model = readPath(arguments, "model");
    options.list = readPath(arguments, "list");
    options.variant = arguments.text("variant");
    options.flight = readFlight(arguments);
    if (const auto width = arguments.integer("panorama")) options.panorama = static_cast<int>(*width);
    options.makeList = readPath(arguments, "make-list");
    options.settingsFile = readPath(arguments, "set");
    if (const auto range = arguments.text("frames")) options.frames = parseFrameRange(*range);
    if (const auto chunk = arguments.text("chunk")) options.chunk = parseChunk(*chunk);
    options.force = arguments.has("force");
    options.verify = arguments.has("verify");
    options.follow = arguments.has("follow");
    options.followTimeout = arguments.number("follow-timeout").value_or(options.followTimeout);
    options.video = readPath(arguments, "video");
    options.framesPerSecond = arguments.number("fps");
    options.preview = readPreview(arguments);
    options.standBy = arguments.has("stand-by");
    if (options.preview || arguments.has("parent")) options.parent = app::parentOf(arguments);
    options.requeue = arguments.has("requeue");
    options.focusAt = readPosition(arguments, "focus-at");
    options.settings = readSettings(arguments);
    if (const auto net = arguments.text("denoise")) options.netDigest = netAndDigest(*net).second;
    options.threads = app::threadsOf(arguments);
    app::useIsa(arguments);
    options.import = app::readImportOptions(arguments);
    options.import.threads = options.threads;
    options.lighting = app::readLightingOptions(arguments);
    options.selection = app::readSelection(arguments);
    options.nets = readPath(arguments, "nets").value_or("");
    options.aovs = arguments.has("aovs");
    readBackdrop(arguments, options);
    options.verbose = arguments.has("verbose");
    options.report = readPath(arguments, "report");
    options.debugScene = readPath(arguments, "debug-scene");
    options.light = readPath(arguments, "light");
    options.makeLight = readPath(arguments, "make-light");
    options.lightBounds.seconds = arguments.number("light-time").value_or(options.lightBounds.seconds);
    options.lightBounds.megabytes = arguments.number("light-size").value_or(options.lightBounds.megabytes);
    options.plan = readPlan(arguments);
    checkCombinations(options, arguments);
    for (const std::filesystem::path& output : options.outputs) checkOutput(output, options.missingFolder());
    if (options.video) checkFilm(*options.video);
    if (options.report) checkPlace(*options.report);
    if (options.makeLight) checkPlace(*options.makeLight);
    if (options.plan) checkPlace(options.plan->file);
    if (options.makeList) checkPlace(*options.makeList);
    options.progress = app::progressStyle(arguments.text("progress").value_or("auto"));
    return options;
}

} // namespace renderer
