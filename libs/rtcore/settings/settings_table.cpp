#include "rtcore/settings/settings_table.h"

#include "rtcore/platform/sentence.h"
#include "rtcore/settings/nearest_name.h"
#include "rtcore/settings/number_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace rtcore {

namespace {

constexpr std::array<std::string_view, 2> kIntegrators{"whitted", "path"};
constexpr std::array<std::string_view, 3> kEmitterLights{"automatic", "on", "off"};
constexpr std::array<std::string_view, 2> kIndirectModes{"off", "live"};
constexpr std::array<std::string_view, 3> kExposureModes{"automatic", "fixed", "incident"};
constexpr std::array<std::string_view, 3> kRecordedExposures{"scaled", "exact", "automatic"};
constexpr std::array<std::string_view, 2> kLightQuantities{"luminance", "illuminance"};
constexpr std::array<std::string_view, 4> kToneMappings{"luminance", "channels", "agx", "neutral"};
constexpr std::array<std::string_view, 2> kTexelFilters{"bilinear", "nearest"};
constexpr std::array<std::string_view, 5> kSamplingPatterns{"grid", "random", "jittered", "rotated",
                                                            "poisson"};
constexpr std::array<std::string_view, 3> kOcclusionPatterns{"rotated", "regular", "random"};
constexpr std::array<std::string_view, 2> kBloomKernels{"gaussian", "airy"};
constexpr std::array<std::string_view, 5> kDenoiseNets{"off", "small", "base", "large", "automatic"};

/// Groups and choices whose names say too little.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kLabels{
    {{"path", "Path tracing"}, {"whitted", "Whitted ray tracing"}, {"agx", "AgX"}, {"ies", "Luminaire"}}};

constexpr std::array<FormerName, 5> kFormerNames{{{"lampSamples", "areaLights.samples"},
                                                  {"denoise", "denoise.passes"},
                                                  {"bloom", "bloom.radius"},
                                                  {"bloomKernel", "bloom.kernel"},
                                                  {"bloomShare", "bloom.share"}}};

using Choices = std::span<const std::string_view>;

/// The names of an enumeration, in its order.
template <typename Enum>
Choices choicesOf() {
    if constexpr (std::is_same_v<Enum, Integrator>) return kIntegrators;
    if constexpr (std::is_same_v<Enum, EmitterLight>) return kEmitterLights;
    if constexpr (std::is_same_v<Enum, IndirectMode>) return kIndirectModes;
    if constexpr (std::is_same_v<Enum, ExposureMode>) return kExposureModes;
    if constexpr (std::is_same_v<Enum, RecordedExposure>) return kRecordedExposures;
    if constexpr (std::is_same_v<Enum, LightQuantity>) return kLightQuantities;
    if constexpr (std::is_same_v<Enum, ToneMapping>) return kToneMappings;
    if constexpr (std::is_same_v<Enum, TexelFilter>) return kTexelFilters;
    if constexpr (std::is_same_v<Enum, SamplingPattern>) return kSamplingPatterns;
    if constexpr (std::is_same_v<Enum, OcclusionPattern>) return kOcclusionPatterns;
    if constexpr (std::is_same_v<Enum, BloomKernel>) return kBloomKernels;
    if constexpr (std::is_same_v<Enum, DenoiseNet>) return kDenoiseNets;
    return {};
}

/// The member that a path of member pointers leads to: member<&RenderSettings::exposure,
/// &ExposureSettings::key>.
template <auto... Path>
auto& member(auto& settings) {
    return (settings.*....*Path);
}
template <auto... Path>
using MemberType = std::remove_cvref_t<decltype(member<Path...>(std::declval<RenderSettings&>()))>;

template <auto... Path>
SettingValue getMember(const RenderSettings& settings) {
    using Type = MemberType<Path...>;
    const Type value = member<Path...>(settings);
    if constexpr (std::is_enum_v<Type>) {
        return std::string(choicesOf<Type>()[static_cast<std::size_t>(value)]);
    } else {
        return value;
    }
}

template <auto... Path>
void setMember(RenderSettings& settings, const SettingValue& value) {
    using Type = MemberType<Path...>;
    if constexpr (std::is_enum_v<Type>) {
        const Choices names = choicesOf<Type>();
        const auto found = std::find(names.begin(), names.end(), std::get<std::string>(value));
        member<Path...>(settings) = static_cast<Type>(found - names.begin());
    } else {
        member<Path...>(settings) = std::get<Type>(value);
    }
}

template <typename Type>
constexpr SettingType settingType() {
    if (std::is_same_v<Type, bool>) return SettingType::Boolean;
    if (std::is_same_v<Type, int>) return SettingType::Integer;
    return std::is_same_v<Type, float> ? SettingType::Number : SettingType::Choice;
}

struct Range {
    double minimum = 0, maximum = 0;
};

/// A row while it is written: what few rows have is said behind them.
struct Row : Setting {
    /// 0 is no amount.
    Row&& zeroIs(std::string_view word) && {
        zero = word;
        return std::move(*this);
    }
    /// The group of one without a dot.
    Row&& in(std::string_view shownWith) && {
        group = shownWith;
        return std::move(*this);
    }
    /// The only choice that the live view draws with.
    Row&& liveOnlyWith(std::string_view choice) && {
        liveChoice = choice;
        return std::move(*this);
    }
    /// Its label where its name says too little.
    Row&& called(std::string_view text) && {
        label = text;
        return std::move(*this);
    }
    Row&& changing(SettingChange what) && {
        changes = what;
        return std::move(*this);
    }
    Row&& usedBy(Integrator only) && {
        integrator = only;
        return std::move(*this);
    }
    Row&& inBrowsers(BrowserRange narrower) && {
        browser = narrower;
        return std::move(*this);
    }
    Row&& notInBrowsers() && {
        browser.offered = false;
        return std::move(*this);
    }
};

template <auto... Path>
Row row(std::string_view name, Range range, std::string_view unit, std::string_view help) {
    using Type = MemberType<Path...>;
    const std::size_t dot = name.find('.');
    return {{name,
             dot == std::string_view::npos ? std::string_view() : name.substr(0, dot),
             settingType<Type>(),
             getMember<Path...>(RenderSettings{}),
             range.minimum,
             range.maximum,
             unit,
             help,
             choicesOf<Type>(),
             {},
             &getMember<Path...>,
             &setMember<Path...>}};
}
template <auto... Path>
Row row(std::string_view name, std::string_view help) {
    return row<Path...>(name, Range{}, "", help);
}

std::vector<Setting> makeTable() {
    using S = RenderSettings;
    using Path = PathSettings;
    using Occlusion = AmbientOcclusionSettings;
    using Bloom = BloomSettings;
    using Exposure = ExposureSettings;
    using Lens = DepthOfFieldSettings;
    using False = FalseColourSettings;
    return {
        row<&S::width>("width", {1, 32768}, "pixels", "width of the image")
            .changing(SettingChange::Samples)
            .notInBrowsers(),
        row<&S::height>("height", {1, 32768}, "pixels", "height of the image")
            .changing(SettingChange::Samples)
            .notInBrowsers(),
        row<&S::antialiasing>("antialiasing", {1, 16}, "", "N x N samples per pixel, averaged")
            .called("Anti-aliasing")
            .changing(SettingChange::Samples)
            .usedBy(Integrator::Whitted)
            .inBrowsers({.maximum = 4}),
        row<&S::sampling>("sampling",
                          "positions of the samples in a pixel: rotated is best at edges, grid is fastest")
            .changing(SettingChange::Samples)
            .usedBy(Integrator::Whitted),
        row<&S::adaptive>("adaptive", {0, 1}, "",
                          "pixels that differ less from their neighbours get a quarter of the "
                          "samples; off: all get all, 0.05: hard to see")
            .zeroIs("off")
            .changing(SettingChange::Samples)
            .usedBy(Integrator::Whitted),
        row<&S::shadows>("shadows", "lights cast shadows").in("rays"),
        row<&S::reflections>("reflections", "mirrors reflect").in("rays"),
        row<&S::refractions>("refractions", "transparent surfaces let light through").in("rays"),
        row<&S::textures>("textures", "textures are shown").in("rays"),
        row<&S::maxDepth>("maxDepth", {0, 1000}, "bounces", "most bounces by mirrors and glass")
            .in("rays")
            .called("Max. bounces")
            .inBrowsers({.maximum = 64}),
        row<&S::minContribution>("minContribution", {0, 1}, "",
                                 "a ray that adds less than this fraction to its pixel is not traced")
            .in("rays")
            .called("Min. contribution")
            .usedBy(Integrator::Whitted)
            .inBrowsers({.minimum = 0.001}),
        row<&S::ambientOcclusion, &Occlusion::on>("ambientOcclusion.on",
                                                  "corners are darker than open surfaces")
            .usedBy(Integrator::Whitted),
        row<&S::ambientOcclusion, &Occlusion::samples>("ambientOcclusion.samples", {1, 4096}, "rays",
                                                       "rays per point for ambient occlusion")
            .usedBy(Integrator::Whitted)
            .inBrowsers({.maximum = 256}),
        row<&S::ambientOcclusion, &Occlusion::distance>(
            "ambientOcclusion.distance", {0, kUnlimited}, "scene units",
            "how far off a surface occludes; automatic: 15 % of the scene's diagonal")
            .zeroIs("automatic")
            .usedBy(Integrator::Whitted),
        row<&S::ambientOcclusion, &Occlusion::pattern>("ambientOcclusion.pattern",
                                                       "directions of the rays, turned for each point, the "
                                                       "same for all, or any")
            .usedBy(Integrator::Whitted),
        row<&S::ambientOcclusion, &Occlusion::light>(
            "ambientOcclusion.light", {0, kUnlimited}, "radiance",
            "ambient light; automatic: the scene's, or one that suits it when it has none")
            .zeroIs("automatic")
            .called("Ambient light")
            .usedBy(Integrator::Whitted),
        row<&S::skyLight, &SkyLightSettings::on>(
            "skyLight.on", "light surfaces from the sky or environment map, with shadows (image-based "
                           "lighting); ambient light only with ambientOcclusion.on")
            .usedBy(Integrator::Whitted),
        row<&S::skyLight, &SkyLightSettings::samples>("skyLight.samples", {1, 4096}, "rays",
                                                      "rays per point for the light of the sky")
            .usedBy(Integrator::Whitted)
            .inBrowsers({.maximum = 256}),
        row<&S::indirect, &IndirectSettings::mode>(
            "indirect.mode", "light that surfaces send to each other, and that of the sky, learned while one "
                             "walks; in place of ambient light, occlusion and skyLight; images by paths with "
                             "denoise.net are mixed with one lit by it, and flicker less")
            .called("Indirect light"),
        row<&S::integrator>("integrator", "whitted: mirrors, glass and light that comes straight; path: all "
                                          "light, also from surface to surface; only for stills")
            .liveOnlyWith("whitted")
            .in("path")
            .notInBrowsers(),
        row<&S::path, &Path::samples>("path.samples", {1, 1 << 20}, "samples",
                                      "paths per pixel; 4 times as many halve the noise")
            .called("Samples per pixel")
            .changing(SettingChange::Pace)
            .usedBy(Integrator::Path)
            .notInBrowsers(),
        row<&S::path, &Path::bounces>("path.bounces", {0, 128}, "bounces",
                                      "most bounces of a path; 0: only light that comes straight")
            .called("Max. bounces")
            .usedBy(Integrator::Path)
            .notInBrowsers(),
        row<&S::path, &Path::rouletteFrom>(
            "path.rouletteFrom", {0, 128}, "",
            "bounce from which weak paths may end by chance: less work, more noise, the same mean")
            .called("Roulette from bounce")
            .changing(SettingChange::Samples)
            .usedBy(Integrator::Path)
            .notInBrowsers(),
        row<&S::path, &Path::clampIndirect>(
            "path.clampIndirect", {0, kUnlimited}, "radiance",
            "most that a bounce after the first adds to a sample: fewer bright dots, "
            "but some light is lost")
            .zeroIs("off")
            .called("Clamp indirect light")
            .usedBy(Integrator::Path)
            .notInBrowsers(),
        row<&S::path, &Path::caustics>(
            "path.caustics", "light reaches surfaces by way of mirrors and glass, too: much more noise")
            .usedBy(Integrator::Path)
            .notInBrowsers(),
        row<&S::path, &Path::emitters>(
            "path.emitters", "surfaces that emit light others; automatic: unless lights stand in them")
            .called("Light from emission")
            .usedBy(Integrator::Path)
            .notInBrowsers(),
        row<&S::path, &Path::seed>("path.seed", {0, (1 << 24) - 1}, "", "another number gives other noise")
            .called("Seed of the noise")
            .changing(SettingChange::Samples)
            .usedBy(Integrator::Path)
            .notInBrowsers(),
        row<&S::path, &Path::filter>("path.filter", {0, 8}, "passes",
                                     "of the filter that smooths noise of images by paths")
            .zeroIs("off")
            .changing(SettingChange::Display)
            .usedBy(Integrator::Path)
            .notInBrowsers(),
        row<&S::path, &Path::seedPerFrame>("path.seedPerFrame",
                                           "the number of a list's frame is added to the seed, so that noise "
                                           "does not stand still in a film")
            .changing(SettingChange::Samples)
            .usedBy(Integrator::Path)
            .notInBrowsers(),
        row<&S::depthOfField, &Lens::on>("depthOfField.on", "only what is in focus is sharp")
            .changing(SettingChange::Samples),
        row<&S::depthOfField, &Lens::fNumber>("depthOfField.fNumber", {0.1, 1000}, "",
                                              "focal length over the lens's diameter, of a film 36 mm wide: "
                                              "smaller is more blurred")
            .changing(SettingChange::Samples),
        row<&S::depthOfField, &Lens::focus>("depthOfField.focus", {0, kUnlimited}, "scene units",
                                            "distance of what is sharp; automatic: of what is in the middle")
            .zeroIs("automatic")
            .changing(SettingChange::Samples),
        row<&S::depthOfField, &Lens::blades>("depthOfField.blades", {0, 32}, "",
                                             "corners of the aperture; fewer than 3: round")
            .zeroIs("round")
            .changing(SettingChange::Samples),
        row<&S::fog, &FogSettings::on>("fog.on", "the scene's fog is shown"),
        row<&S::fog, &FogSettings::shafts>(
            "fog.shafts", {0, 1024}, "rays",
            "shadow rays to each light along a ray through fog: shafts of light")
            .zeroIs("off")
            .inBrowsers({.maximum = 64}),
        row<&S::areaLights, &AreaLightSettings::samples>(
            "areaLights.samples", {0, 4096}, "rays",
            "shadow rays to each area light: soft shadows; off: area lights are points")
            .zeroIs("off")
            .inBrowsers({.maximum = 64}),
        row<&S::denoise, &DenoiseSettings::passes>("denoise.passes", {0, 8}, "passes",
                                                   "smooths noise, but not edges")
            .zeroIs("off")
            .changing(SettingChange::Display),
        row<&S::denoise, &DenoiseSettings::net>(
            "denoise.net", "a trained net takes the noise of paths away: small is quick, large is best; "
                           "automatic: base where its weights are, else the filter, not for lists")
            .liveOnlyWith("off")
            .changing(SettingChange::Display)
            .usedBy(Integrator::Path)
            .notInBrowsers(),
        row<&S::denoise, &DenoiseSettings::mix>(
            "denoise.mix",
            "the error of a net's image is estimated from 16 samples on, and from 64 on it is mixed "
            "with the sampled one: each where it has the smaller error")
            .changing(SettingChange::Display)
            .usedBy(Integrator::Path)
            .notInBrowsers(),
        row<&S::bloom, &Bloom::radius>("bloom.radius", {0, 4096}, "pixels",
                                       "size of the bloom around bright spots")
            .zeroIs("off")
            .changing(SettingChange::Display)
            .inBrowsers({.maximum = 256}),
        row<&S::bloom, &Bloom::kernel>("bloom.kernel",
                                       "blur of a plain lens, or the coloured rings of a perfect one")
            .changing(SettingChange::Display),
        row<&S::bloom, &Bloom::share>("bloom.share", {0, 1}, "", "fraction of all light that bloom spreads")
            .changing(SettingChange::Display),
        row<&S::exposure, &Exposure::mode>("exposure.mode",
                                           "automatic follows the image's brightness, incident "
                                           "the light on what is seen: a white room stays "
                                           "white, a black car black")
            .changing(SettingChange::Display),
        row<&S::exposure, &Exposure::value>("exposure.value", {1e-30, 1e30}, "radiance",
                                            "fixed exposure: radiance that is shown as half of white")
            .changing(SettingChange::Display),
        row<&S::exposure, &Exposure::key>("exposure.key", {1e-4, 100}, "",
                                          "exposure that is not fixed: larger is brighter")
            .changing(SettingChange::Display),
        row<&S::exposure, &Exposure::brighterSeconds>("exposure.brighterSeconds", {0, 1000}, "seconds",
                                                      "time to get used to more light, in real time")
            .changing(SettingChange::Pace),
        row<&S::exposure, &Exposure::darkerSeconds>("exposure.darkerSeconds", {0, 1000}, "seconds",
                                                    "time to get used to less light, in real time")
            .changing(SettingChange::Pace),
        row<&S::exposure, &Exposure::local>("exposure.local", {0, 1}, "",
                                            "how much the exposure of a region follows its own brightness")
            .changing(SettingChange::Display),
        row<&S::exposure, &Exposure::recorded>("exposure.recorded",
                                               "exposures of .cam files in stills; scaled: brighter light of "
                                               "paths looks as bright as recorded, by "
                                               "the list's first frame; automatic: measured anew")
            .called("Recorded exposures")
            .changing(SettingChange::Display),
        row<&S::toneMapping>("toneMapping",
                             "luminance keeps hues, channels lets bright colours fade to white, agx is like "
                             "film, neutral keeps all but the brightest colours")
            .in("exposure")
            .changing(SettingChange::Display),
        row<&S::toneContrast>("toneContrast", {0, 3}, "",
                              "contrast and colour of agx: 0 as soft as film, 1 punchy, and beyond")
            .in("exposure")
            .changing(SettingChange::Display),
        row<&S::dithering>("dithering", "noise of less than one step hides bands in smooth gradients")
            .changing(SettingChange::Display),
        row<&S::falseColours, &False::on>("falseColours.on",
                                          "light is shown by the colours of a scale, dark to bright, in "
                                          "place of the image; without bloom and local exposure")
            .changing(SettingChange::Display),
        row<&S::falseColours, &False::quantity>(
            "falseColours.quantity", "luminance is how bright things look, in cd/m2; illuminance how much "
                                     "light arrives at the surface that is seen first, in lux")
            .changing(SettingChange::Display),
        row<&S::falseColours, &False::from>("falseColours.from", {0, 1e30}, "cd/m2 or lux",
                                            "lower end of the scale; automatic: by what is seen")
            .zeroIs("automatic")
            .changing(SettingChange::Display),
        row<&S::falseColours, &False::to>("falseColours.to", {0, 1e30}, "cd/m2 or lux",
                                          "upper end of the scale; automatic: by what is seen")
            .zeroIs("automatic")
            .changing(SettingChange::Display),
        row<&S::falseColours, &False::isolines>("falseColours.isolines",
                                                "lines of equal light at 1, 2, 5, 10, 20 and so on")
            .changing(SettingChange::Display),
        row<&S::falseColours, &False::legend>("falseColours.legend", "the scale is painted into the image")
            .changing(SettingChange::Display),
        row<&S::environmentFilter>("environmentFilter", "lookup in environment maps").in("rays"),
    };
}

const std::vector<Setting>& table() {
    static const std::vector<Setting> rows = makeTable();
    return rows;
}

/// "brighterSeconds": "Brighter seconds".
std::string spacedWords(std::string_view name) {
    const auto isCapital = [](char c) { return c >= 'A' && c <= 'Z'; };
    std::string text;
    for (const char c : name) {
        if (isCapital(c) && !text.empty()) text += ' ';
        const bool first = text.empty();
        text += first && c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A')
                : !first && isCapital(c)      ? static_cast<char>(c - 'A' + 'a')
                                              : c;
    }
    return text;
}

std::string textOf(double limit) { return settingText(static_cast<float>(limit)); }

/// The range of a number, in words.
Sentence rangeWith(const Setting& setting, std::string_view unit) {
    const std::string min = textOf(setting.minimum);
    Sentence range = setting.maximum >= kUnlimited ? say("at least {0}", min)
                                                   : say("{0} to {1}", min, textOf(setting.maximum));
    if (!unit.empty()) range = say("{0} {1}", range, unit);
    return setting.zero.empty() ? range : say("{0}, or {1}", range, setting.zero);
}

/// The values of a setting of any type, in words.
Sentence rangeOf(const Setting& setting, std::string_view unit) {
    if (setting.type == SettingType::Boolean) return say("true or false");
    if (setting.type != SettingType::Choice) return rangeWith(setting, unit);
    Sentence names = setting.choices.front();
    for (const std::string_view name : std::span(setting.choices).subspan(1))
        names = say("{0} or {1}", names, name);
    return names;
}

[[noreturn]] void refuse(const Setting& setting, const std::string& given) {
    const Sentence takes = rangeOf(setting, setting.unit);
    throw BadValue(setting.type == SettingType::Integer
                       ? say("{0} is {1}, but takes a whole number, {2}", setting.name, given, takes)
                       : say("{0} is {1}, but takes {2}", setting.name, given, takes));
}

/// Compared as floats, so that the limits themselves are taken. Not a number is in no range.
bool inRange(const Setting& setting, float value) {
    return value >= static_cast<float>(setting.minimum) && value <= static_cast<float>(setting.maximum);
}

bool isZeroWord(const Setting& setting, const SettingValue& value) {
    const std::string* word = std::get_if<std::string>(&value);
    return word != nullptr && !setting.zero.empty() && *word == setting.zero;
}

std::string givenText(const SettingValue& value) {
    const std::string text = settingText(value);
    return std::holds_alternative<std::string>(value) ? inQuotes(text) : text;
}

int checkInteger(const Setting& setting, const SettingValue& value) {
    if (isZeroWord(setting, value)) return 0;
    const int* number = std::get_if<int>(&value);
    const bool good = number != nullptr && *number >= setting.minimum && *number <= setting.maximum;
    if (!good) refuse(setting, givenText(value));
    return *number;
}

float checkNumber(const Setting& setting, const SettingValue& value) {
    if (isZeroWord(setting, value)) return 0;
    const int* whole = std::get_if<int>(&value);
    const float* number = std::get_if<float>(&value);
    if (whole == nullptr && number == nullptr) refuse(setting, givenText(value));
    const float checked = number != nullptr ? *number : static_cast<float>(*whole);
    if (!inRange(setting, checked)) refuse(setting, givenText(value));
    return checked;
}

std::string checkChoice(const Setting& setting, const SettingValue& value) {
    const std::string* name = std::get_if<std::string>(&value);
    if (name == nullptr) refuse(setting, settingText(value));
    if (std::find(setting.choices.begin(), setting.choices.end(), *name) == setting.choices.end())
        refuse(setting, inQuotes(*name));
    return *name;
}

/// The whole text as a number; no white space, no hexadecimal.
template <typename Number>
bool parseNumber(std::string_view text, Number& number) {
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    return error == std::errc() && stop == end;
}

bool parseBoolean(const Setting& setting, std::string_view text) {
    constexpr std::array<std::string_view, 4> yes{"true", "on", "yes", "1"}, no{"false", "off", "no", "0"};
    if (std::find(yes.begin(), yes.end(), text) != yes.end()) return true;
    if (std::find(no.begin(), no.end(), text) == no.end()) refuse(setting, inQuotes(text));
    return false;
}

} // namespace

std::span<const Setting> settingsTable() { return table(); }

std::span<const FormerName> formerSettingNames() { return kFormerNames; }

const Setting* findSetting(std::string_view name) {
    const auto* const former = std::find_if(kFormerNames.begin(), kFormerNames.end(),
                                            [&](const FormerName& each) { return each.former == name; });
    if (former != kFormerNames.end()) name = former->name;
    const auto found = std::find_if(table().begin(), table().end(),
                                    [&](const Setting& setting) { return setting.name == name; });
    return found == table().end() ? nullptr : &*found;
}

const Setting& requireSetting(std::string_view name) {
    if (const Setting* setting = findSetting(name)) return *setting;
    std::vector<std::string_view> names;
    for (const Setting& setting : table()) names.push_back(setting.name);
    throw BadValue(unknownNameMessage(form("setting"), name, names));
}

SettingValue checkSetting(const Setting& setting, const SettingValue& value) {
    switch (setting.type) {
    case SettingType::Boolean:
        if (!std::holds_alternative<bool>(value)) refuse(setting, settingText(value));
        return value;
    case SettingType::Integer:
        return checkInteger(setting, value);
    case SettingType::Number:
        return checkNumber(setting, value);
    case SettingType::Choice:
        break;
    }
    return checkChoice(setting, value);
}

SettingValue parseSetting(const Setting& setting, std::string_view text) {
    if (setting.type == SettingType::Boolean) return parseBoolean(setting, text);
    if (setting.type == SettingType::Choice) return checkSetting(setting, std::string(text));
    if (int whole = 0; parseNumber(text, whole)) return checkSetting(setting, whole);
    if (float number = 0; parseNumber(text, number)) return checkSetting(setting, number);
    return checkSetting(setting, std::string(text));
}

void setSetting(RenderSettings& settings, std::string_view name, const SettingValue& value) {
    const Setting& setting = requireSetting(name);
    setting.set(settings, checkSetting(setting, value));
}

void setSettingFromText(RenderSettings& settings, std::string_view name, std::string_view text) {
    const Setting& setting = requireSetting(name);
    setting.set(settings, parseSetting(setting, text));
}

SettingValue getSetting(const RenderSettings& settings, std::string_view name) {
    return requireSetting(name).get(settings);
}

void applySettings(RenderSettings& settings, std::span<const SettingAssignment> assignments) {
    RenderSettings changed = settings;
    for (const SettingAssignment& assignment : assignments)
        setSetting(changed, assignment.name, assignment.value);
    settings = changed;
}

std::vector<SettingAssignment> settingAssignments(const RenderSettings& settings, bool everything) {
    std::vector<SettingAssignment> assignments;
    for (const Setting& setting : table()) {
        SettingValue value = setting.get(settings);
        if (everything || value != setting.defaultValue)
            assignments.push_back({std::string(setting.name), std::move(value)});
    }
    return assignments;
}

void checkLive(const Setting& setting, const SettingValue& value) {
    const std::string* choice = std::get_if<std::string>(&value);
    if (setting.liveChoice.empty() || choice == nullptr || *choice == setting.liveChoice) return;
    throw BadValue(say("{0} is {1}, which is for stills, not for the live view; put it into [still], or use "
                       "'Renderer --setting {0}={1}'",
                       setting.name, *choice));
}

void checkLive(const RenderSettings& settings) {
    for (const Setting& setting : table()) checkLive(setting, setting.get(settings));
}

std::vector<std::string_view> unusedSettings(const RenderSettings& settings,
                                             std::span<const SettingAssignment> asked) {
    std::vector<std::string_view> names;
    for (const Setting& setting : table()) {
        if (!setting.integrator || *setting.integrator == settings.integrator) continue;
        const bool given = std::any_of(asked.begin(), asked.end(), [&](const SettingAssignment& each) {
            return findSetting(each.name) == &setting && each.value != setting.defaultValue;
        });
        if (given) names.push_back(setting.name);
    }
    return names;
}

bool sameLight(const RenderSettings& a, const RenderSettings& b) {
    return std::ranges::all_of(table(), [&](const Setting& setting) {
        return setting.changes != SettingChange::Light || setting.get(a) == setting.get(b);
    });
}

std::string settingText(const SettingValue& value) {
    if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    if (const int* whole = std::get_if<int>(&value)) return fmt::format("{}", *whole);
    if (const std::string* name = std::get_if<std::string>(&value)) return *name;
    return shortestText(std::get<float>(value));
}

std::string settingLabel(std::string_view name) {
    if (name.empty()) return "Image";
    if (const Setting* const setting = findSetting(name); setting != nullptr && !setting->label.empty())
        return std::string(setting->label);
    const auto* const known = std::ranges::find(kLabels, name, [](const auto& each) { return each.first; });
    if (known != kLabels.end()) return std::string(known->second);
    return spacedWords(name.substr(name.rfind('.') + 1));
}

std::string settingRange(const Setting& setting) { return rangeOf(setting, "").english(); }

} // namespace rtcore
