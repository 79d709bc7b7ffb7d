#include "renderer/report_file.h"

#include "common/settings/image_texts.h"

#include "rtcore/neural/net_files.h"
#include "rtcore/platform/files.h"
#include "rtcore/post/net_denoise.h"
#include "rtcore/settings/settings_table.h"

#include <nlohmann/json.hpp>

#include <array>
#include <span>
#include <string>
#include <utility>
#include <variant>

namespace renderer {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, rtcore::kRayKinds> kKindNames{"primary",   "shadow",    "mirror",
                                                                "refracted", "occlusion", "scattered"};

Json raysOf(const rtcore::RayStatistics& statistics) {
    Json rays;
    for (std::size_t kind = 0; kind < kKindNames.size(); ++kind)
        rays[kKindNames[kind]] = statistics.rays[kind];
    return rays;
}

Json settingsOf(const rtcore::RenderSettings& settings) {
    Json all;
    for (const rtcore::Setting& row : rtcore::settingsTable())
        all[std::string(row.name)] =
            std::visit([](const auto& value) { return Json(value); }, rtcore::getSetting(settings, row.name));
    return all;
}

Json denoisingOf(const FrameReport& report) {
    const rtcore::NetReport& net = report.net;
    Json denoising{
        {"net", rtcore::settingText(rtcore::getSetting(report.settings, "denoise.net"))},
        {"weights", rtcore::fileOf(rtcore::netOf(report.settings).value_or(rtcore::Net::Base)).sha256},
        {"mixed", net.mixed}};
    if (!net.estimated) return denoising;
    denoising["error"] = net.error;
    denoising["largestError"] = net.largestError;
    denoising["brightDots"] = net.dots;
    denoising["lightOfBrightDots"] = net.lightOfDots;
    return denoising;
}

Json outputsOf(const FrameTask& frame) {
    Json outputs = Json::array();
    for (const std::filesystem::path& output : frame.outputs) outputs.push_back(output.string());
    return outputs;
}

} // namespace

struct ReportFile::Content {
    Json all;
};

ReportFile::ReportFile(std::filesystem::path path, const RendererOptions& options)
    : path_(std::move(path)), content_(std::make_unique<Content>()) {
    for (const rtcore::ImageText& text : app::imageTexts(rtcore::RenderSettings()))
        if (text.name == "Software") content_->all["software"] = text.text;
    content_->all["scene"] = options.scene.string();
    content_->all["frames"] = Json::array();
    write();
}

ReportFile::~ReportFile() = default;

void ReportFile::add(const FrameTask& frame, const FrameReport& report) {
    Json added{{"number", frame.number},
               {"camera", frame.camera.string()},
               {"outputs", outputsOf(frame)},
               {"renderSeconds", report.renderSeconds},
               {"finishSeconds", report.writeSeconds},
               {"rays", raysOf(report.rays)}};
    if (report.net.ran) added["denoising"] = denoisingOf(report);
    added["settings"] = settingsOf(report.settings);
    content_->all["frames"].push_back(std::move(added));
    write();
}

void ReportFile::write() const {
    // Names of files may be any bytes.
    const std::string text =
        content_->all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
    const std::span<const std::byte> piece = std::as_bytes(std::span(text));
    rtcore::writeFileAtomically(path_, std::span(&piece, 1));
}

} // namespace renderer
