#include "gui/session/preview_reader.h"

#include "gui/session/pixel_order.h"
#include "gui/session/server_sentence.h"

#include "common/cli/instance_option.h"
#include "common/frames/error_byte.h"

#include "ipc/endpoint/viewer.h"

#include <QCoreApplication>

#include <cstddef>
#include <cstring>
#include <span>

namespace gui {

namespace {

bool isLast(const ipc::FrameInfo& info) { return info.tag == ipc::kPreviewDone; }

QSize sizeOf(const ipc::FrameInfo& info) {
    return {static_cast<int>(info.width), static_cast<int>(info.height)};
}

// Both without gaps between the rows.
QImage imageOf(const ipc::Frame& frame, const QImage* below) {
    QImage image(sizeOf(frame.info), QImage::Format_RGB32);
    if (image.isNull()) return image;
    const auto bytes = static_cast<std::size_t>(image.sizeInBytes());
    std::memcpy(image.bits(), frame.pixels.data(), std::min(bytes, frame.pixels.size()));
    const std::span<std::byte> pixels(reinterpret_cast<std::byte*>(image.bits()), bytes);
    if (below == nullptr) {
        toRgb32(pixels);
    } else {
        toRgb32Over(pixels, {reinterpret_cast<const std::byte*>(below->constBits()), bytes});
    }
    return image;
}

/// The fourth bytes of the pixels.
QImage errorsOf(const ipc::Frame& frame) {
    QImage errors(sizeOf(frame.info), QImage::Format_Grayscale8);
    if (errors.isNull()) return errors;
    const std::byte* pixel = frame.pixels.data();
    for (int y = 0; y < errors.height(); ++y) {
        uchar* const row = errors.scanLine(y);
        for (int x = 0; x < errors.width(); ++x, pixel += 4) row[x] = std::to_integer<uchar>(pixel[3]);
    }
    return errors;
}

} // namespace

struct PreviewReader::Link {
    std::string instance;
    std::uint64_t run = 0;
    std::unique_ptr<ipc::Viewer> viewer;
    ipc::Frame frame;
};

PreviewReader::PreviewReader(const QString& instance, quint64 run)
    : link_(std::make_unique<Link>(Link{instance.toStdString(), run, {}, {}})) {}

PreviewReader::~PreviewReader() = default;

void PreviewReader::look() {
    try {
        if (!link_->viewer)
            link_->viewer = std::make_unique<ipc::Viewer>(link_->instance, std::chrono::nanoseconds(0));
        link_->viewer->update();
    } catch (const ipc::Error& error) {
        if (error.problem != ipc::Problem::NoServer) trouble_ = translated(error);
    }
}

std::optional<PreviewPicture> PreviewReader::read(const QImage& live) {
    look();
    if (!link_->viewer || !trouble_.isEmpty()) return std::nullopt;
    ipc::Frame& frame = link_->frame;
    if (!link_->viewer->readFrame(frame) || frame.info.run != link_->run) return std::nullopt;
    progress_ = static_cast<double>(frame.info.tag) / static_cast<double>(ipc::kPreviewDone);
    const bool whole = frame.info.samples > 0 || isLast(frame.info);
    const bool fits = live.size() == sizeOf(frame.info) && live.format() == QImage::Format_RGB32;
    if (!whole && !fits) return std::nullopt;
    QImage image = imageOf(frame, whole ? nullptr : &live);
    if (image.isNull()) return std::nullopt;
    PreviewPicture picture{std::move(image), isLast(frame.info), static_cast<int>(frame.info.samples), {}};
    if (frame.info.format == ipc::PixelFormat::Rgb8Error8) {
        picture.errors = errorsOf(frame);
        picture.error = app::errorOfThousandths(frame.info.error);
        picture.largestError = app::errorOfThousandths(frame.info.largestError);
    }
    return picture;
}

QString previewPrefix() { return QString::fromUtf8(app::kPreviewPrefix.data(), app::kPreviewPrefix.size()); }

QString previewInstance(int number) {
    return previewPrefix() + QStringLiteral("%1-%2").arg(QCoreApplication::applicationPid()).arg(number);
}

} // namespace gui
