/// The numbers of docs/manual.md, docs/import.md and the help are those of the code.
#include "bspbuilder/builder_options.h"
#include "ipc/layout/limits.h"
#include "renderer/film_rate.h"
#include "renderer/renderer_options.h"
#include "rtserver/server_options.h"

#include "rtcore/io/scene_loader.h"
#include "rtcore/motion/walker.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iomanip>
#include <iterator>
#include <sstream>
#include <string>
#include <type_traits>

namespace {

std::string pageOf(const std::string& name) {
    std::ifstream file(std::string(RT_DOCUMENTS "/") + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string text(double number) {
    std::ostringstream stream;
    stream << std::setprecision(12) << number;
    return stream.str();
}

/// Parts of a text, one after another.
template <typename... Parts>
std::string joined(const Parts&... parts) {
    std::ostringstream stream;
    const auto add = [&](const auto& part) {
        if constexpr (std::is_arithmetic_v<std::decay_t<decltype(part)>>) {
            stream << text(static_cast<double>(part));
        } else {
            stream << part;
        }
    };
    (add(parts), ...);
    return stream.str();
}

void expectIn(const std::string& page, const std::string& sentence) {
    EXPECT_NE(page.find(sentence), std::string::npos) << sentence;
}

/// The text on an option in help and manual.
std::string helpOf(const app::ProgramSpec& spec, const std::string& option) {
    const app::Option* found = spec.find(option);
    EXPECT_NE(found, nullptr) << option;
    return found == nullptr ? "" : found->help + ". " + found->more;
}

const std::string kManual = pageOf("manual.md");

TEST(ManualNumbers, OfImporting) {
    using namespace rtcore;
    const app::ProgramSpec& spec = bspbuilder::builderSpec();
    expectIn(helpOf(spec, "crease-angle"), joined("[", kCreaseAngle, "]"));
    expectIn(helpOf(spec, "deflection"), fmt::format("[{:g}]", kDeflection));
    const double perMegabyte = kImportSecondsPerByte * 1e6;
    const std::string time = joined(kImportSeconds, ", and ", perMegabyte, " more for each MB of the file; ",
                                    kTinyModelSeconds, " for a ");
    expectIn(helpOf(spec, "time-limit"), time);
    expectIn(helpOf(spec, "time-limit"),
             joined("a file below ", kTinyModel / 1000, " kB that is no `.gltf`"));
    expectIn(pageOf("import.md"), joined("Limits: memory, half of the machine's; time, ", kImportSeconds,
                                         " s and ", perMegabyte, " s for each MB of the file\n(",
                                         kTinyModelSeconds, " s below ", kTinyModel / 1000, " kB"));
}

TEST(ManualNumbers, OfBuilding) {
    const app::Option& quality = *bspbuilder::builderSpec().find("quality");
    const int usual = rtcore::BuildOptions().fastQuality;
    expectIn(quality.help, joined(quality.minimum, " is quickest to build, ", quality.maximum,
                                  " quickest to trace [", usual, "]"));
    std::string triangles = text(rtcore::kFastTreeTriangles);
    triangles.insert(triangles.size() - 3, ",");
    expectIn(kManual, "A model of more than " + triangles + " triangles is shown from a kd-tree that");
}

TEST(ManualNumbers, OfRendering) {
    const app::ProgramSpec& spec = renderer::rendererSpec();
    const renderer::RendererOptions usual;
    expectIn(helpOf(spec, "follow-timeout"), joined("[", usual.followTimeout, "]"));
    expectIn(helpOf(spec, "fps"), joined("else ", renderer::kUsualFrameRate, "]"));
    expectIn(helpOf(spec, "fps"), joined("With `--follow` it is always ", renderer::kUsualFrameRate));
    const renderer::PreviewOptions preview{.instance = "x"};
    expectIn(helpOf(spec, "linger"), joined("[", preview.linger, "]"));
    const rtcore::RenderSettings settings;
    EXPECT_EQ(settings.width * 3, settings.height * 4);
    expectIn(helpOf(spec, "width"), "or the scene, else 4:3");
}

TEST(ManualNumbers, OfServing) {
    expectIn(helpOf(rtserver::serverSpec(), "resolution"), joined("Up to ", ipc::kMaxFrameSide, " each way"));
    expectIn(kManual, joined("to the step of 1/", rtcore::kTicksPerSecond, " s"));
}

} // namespace
