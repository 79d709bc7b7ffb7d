#include "bench/walk/walk_report.h"

#include "rtcore/io/images/image_file.h"
#include "rtcore/platform/files.h"
#include "support/quantile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>

namespace bench {

namespace {

constexpr double kWorst = 0.95; ///< a twentieth is worse

std::string lineOf(const char* name, const char* form, const std::vector<Moment>& moments,
                   const std::function<double(const Moment&)>& value, double worst) {
    std::vector<double> values;
    double sum = 0;
    for (const Moment& moment : moments) {
        values.push_back(value(moment));
        sum += values.back();
    }
    const auto text = [&](double x) { return fmt::format(fmt::runtime(form), x); };
    return fmt::format("{:<28}{:>10}{:>12}\n", name, text(sum / static_cast<double>(values.size())),
                       text(test::quantile(values, worst)));
}

} // namespace

std::string tableOf(const std::vector<Moment>& moments) {
    std::string text =
        fmt::format("{:>6}{:>10}{:>10}{:>10}{:>16}{:>10}{:>11}{:>22}{:>10}\n", "camera", "relMSE", "blocks",
                    "mean FLIP", "mean error, %", "PSNR, dB", "change, %", "uncovered: error, %", "blocks");
    for (const Moment& m : moments) {
        text += fmt::format(
            "{:>6}{:>10.4f}{:>10.4f}{:>10.4f}{:>+16.2f}{:>10.2f}{:>11.3f}{:>+22.2f}{:>10.4f}\n", m.camera,
            m.errors.relMse, m.errors.blocks, m.errors.flip, 100 * m.errors.bias, m.errors.psnr,
            100 * m.errors.change, 100 * m.errors.uncoveredBias, m.errors.uncoveredBlocks);
    }
    return text;
}

std::string summaryOf(const std::vector<Moment>& moments) {
    if (moments.empty()) return "no moments were compared\n";
    std::string text = fmt::format("{:<28}{:>10}{:>12}\n", "", "mean", "worst 5 %");
    text += lineOf(
        "mean FLIP", "{:.4f}", moments, [](const Moment& m) { return m.errors.flip; }, kWorst);
    text += lineOf(
        "PSNR, dB", "{:.2f}", moments, [](const Moment& m) { return m.errors.psnr; }, 1 - kWorst);
    text += lineOf(
        "relMSE", "{:.4f}", moments, [](const Moment& m) { return m.errors.relMse; }, kWorst);
    text += lineOf(
        "blocks", "{:.4f}", moments, [](const Moment& m) { return m.errors.blocks; }, kWorst);
    text += lineOf(
        "mean error, %", "{:+.2f}", moments, [](const Moment& m) { return 100 * m.errors.bias; }, kWorst);
    text += lineOf(
        "size each way, %", "{:.0f}", moments, [](const Moment& m) { return 100 * m.scale; }, 1 - kWorst);
    text += lineOf(
        "from frame to frame, ms", "{:.1f}", moments, [](const Moment& m) { return m.milliseconds; }, kWorst);
    text += lineOf(
        "to trace a frame, ms", "{:.1f}", moments, [](const Moment& m) { return m.drawn; }, kWorst);
    return text;
}

void writeCsv(const std::filesystem::path& path, const std::vector<Moment>& moments) {
    std::string text = "camera,milliseconds,drawn,age,scale,flip,psnr,relmse,bias,blocks,change,"
                       "uncoveredbias,uncoveredblocks\n";
    for (const Moment& m : moments) {
        text += fmt::format(
            "{},{:.2f},{:.2f},{:.2f},{:.4f},{:.5f},{:.3f},{:.5f},{:.5f},{:.5f},{:.6f},{:.5f},{:.5f}\n",
            m.camera, m.milliseconds, m.drawn, m.age, m.scale, m.errors.flip, m.errors.psnr, m.errors.relMse,
            m.errors.bias, m.errors.blocks, m.errors.change, m.errors.uncoveredBias,
            m.errors.uncoveredBlocks);
    }
    const std::span<const std::byte> piece = std::as_bytes(std::span(text));
    rtcore::writeFileAtomically(path, std::span(&piece, 1));
}

void ContactSheet::add(const rtcore::LdrImage& shown, const rtcore::LdrImage& reference,
                       const std::vector<float>& errors) {
    rtcore::LdrImage row(3 * shown.width, shown.height);
    for (int y = 0; y < shown.height; ++y) {
        for (int x = 0; x < shown.width; ++x) {
            const float error = errors[static_cast<std::size_t>(y) * static_cast<std::size_t>(shown.width) +
                                       static_cast<std::size_t>(x)];
            const auto code = static_cast<std::uint8_t>(std::lround(255 * std::clamp(error, 0.0F, 1.0F)));
            row.at(x, y) = shown.at(x, y);
            row.at(shown.width + x, y) = reference.at(x, y);
            row.at(2 * shown.width + x, y) = {code, code, code};
        }
    }
    rows_.push_back(std::move(row));
}

void ContactSheet::write(const std::filesystem::path& path) const {
    if (rows_.empty()) return;
    rtcore::LdrImage sheet(rows_[0].width, rows_[0].height * static_cast<int>(rows_.size()));
    auto to = sheet.pixels.begin();
    for (const rtcore::LdrImage& row : rows_) to = std::ranges::copy(row.pixels, to).out;
    rtcore::writeImage(path, sheet);
}

} // namespace bench
