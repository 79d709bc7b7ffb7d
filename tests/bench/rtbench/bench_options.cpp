#include "bench/rtbench/bench_options.h"

#include "common/cli/import_options.h"
#include "common/cli/isa_option.h"

#include "rtcore/settings/plain_text.h"
#include "rtcore/simd/instruction_set.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace rtbench {

namespace {

using app::OptionGroup;
using app::ValueKind;

constexpr int kMaxSide = 16384;

OptionGroup rayOptions() {
    return {"What is traced",
            {{.name = "views",
              .value = ValueKind::Text,
              .argument = "FILE",
              .help = "views by the names of the models' files; without it, or for models that it does not "
                      "name, a view is made: inside for interiors, of the whole for objects"},
             {.name = "rays",
              .value = ValueKind::Text,
              .argument = "LIST",
              .help = "kinds of rays with commas between: primary, shadow, ao, mirror, bounce; none for "
                      "--frames alone [all]"},
             {.name = "size",
              .value = ValueKind::Integer,
              .argument = "N",
              .help = "rays of an image of N x N pixels [1024]",
              .minimum = 8,
              .maximum = kMaxSide},
             {.name = "fast", .help = "build fast trees, not exact ones"},
             {.name = "frames", .help = "render whole frames, too, with each of the tracers"},
             {.name = "frame-size",
              .value = ValueKind::Text,
              .argument = "WxH",
              .help = "the size of these frames [1280x720]"}}};
}

OptionGroup measuringOptions() {
    return {
        "How it is measured",
        {{.name = "threads",
          .value = ValueKind::Integer,
          .argument = "N",
          .help = "trace with N threads; one is measured in its processor time, more in wall time [1]",
          .minimum = 1,
          .maximum = 1024},
         app::isaOption(),
         {.name = "embree",
          .value = ValueKind::Choice,
          .argument = "STATE",
          .help = "off: our figures alone [on]",
          .choices = {"off", "on"}},
         {.name = "modes", .help = "print the figures of every mode of Embree, not only of the best ones"},
         {.name = "rounds",
          .value = ValueKind::Integer,
          .argument = "N",
          .help = "stop after N rounds, however large the spread is [12]",
          .minimum = 2,
          .maximum = 1000}}};
}

OptionGroup outputOptions() {
    return {"Output",
            {{.name = "json",
              .value = ValueKind::Text,
              .argument = "FILE",
              .help = "write the figures to FILE as JSON, too"},
             app::progressOption()}};
}

std::vector<const RayTest*> readTests(std::string_view list) {
    std::vector<const RayTest*> tests;
    if (list == "none") return tests;
    std::vector<std::string_view> words;
    for (std::size_t comma = 0; comma != std::string_view::npos;) {
        comma = list.find(',');
        words.push_back(list.substr(0, comma));
        if (comma != std::string_view::npos) list.remove_prefix(comma + 1);
    }
    for (const std::string_view word : words) {
        const bool known = std::any_of(kRayTests.begin(), kRayTests.end(),
                                       [&](const RayTest& test) { return test.name == word; });
        if (known) continue;
        throw app::UsageError("option '--rays': " + rtcore::inQuotes(std::string(word)) +
                              " is not one of primary, shadow, ao, mirror, bounce");
    }
    for (const RayTest& test : kRayTests) {
        if (std::find(words.begin(), words.end(), test.name) != words.end()) tests.push_back(&test);
    }
    return tests;
}

void readFrameSize(const std::string& text, BenchOptions& options) {
    const std::size_t cross = text.find('x');
    const auto side = [&](std::string_view digits) {
        const auto value = app::parseInteger(digits);
        if (!value || *value < 1 || *value > kMaxSide) {
            throw app::UsageError("option '--frame-size': " + rtcore::inQuotes(text) +
                                  " is no size such as 1280x720");
        }
        return static_cast<int>(*value);
    };
    const std::string_view all = text;
    options.frameWidth = side(all.substr(0, cross));
    options.frameHeight = side(cross == std::string::npos ? "" : all.substr(cross + 1));
}

} // namespace

const app::ProgramSpec& benchSpec() {
    static const app::ProgramSpec spec{
        .name = "rtbench",
        .purpose =
            "Measures how many rays per second are traced, beside Embree (when it was built with it) on "
            "the same rays in the same run, and checks that both hit the same.",
        .positionals = {{.name = "MODEL", .help = "model, .bsp or .scn", .repeats = true}},
        .groups = {rayOptions(), measuringOptions(), app::importOptionGroup(), outputOptions()},
        .examples = {{"rtbench sibenik.ply dragon.ply --views views.toml", "all kinds of rays, one thread"},
                     {"rtbench nave.bsp --rays none --frames --threads 2", "whole frames alone"},
                     {"rtbench nave.bsp --isa avx2 --json nave.json", "both sides without AVX-512"}},
    };
    return spec;
}

BenchOptions readBenchOptions(const app::Arguments& arguments) {
    BenchOptions options;
    for (const std::string& scene : arguments.positionals()) options.scenes.emplace_back(scene);
    if (const auto file = arguments.text("views")) options.views = *file;
    options.tests = readTests(arguments.text("rays").value_or("primary,shadow,ao,mirror,bounce"));
    if (const auto size = arguments.integer("size")) options.size = static_cast<int>(*size);
    if (const auto threads = arguments.integer("threads")) options.threads = static_cast<int>(*threads);
    if (const auto rounds = arguments.integer("rounds")) options.rounds = static_cast<int>(*rounds);
    app::useIsa(arguments);
    options.embree = arguments.text("embree").value_or("on") == "on";
    options.modes = arguments.has("modes");
    options.fast = arguments.has("fast");
    options.frames = arguments.has("frames");
    if (const auto size = arguments.text("frame-size")) readFrameSize(*size, options);
    if (const auto file = arguments.text("json")) options.json = *file;
    options.import = app::readImportOptions(arguments);
    options.progress = app::progressStyle(arguments.text("progress").value_or("auto"));
    if (options.tests.empty() && !options.frames)
        throw app::UsageError("nothing to measure: --rays=none without --frames");
    return options;
}

} // namespace rtbench
