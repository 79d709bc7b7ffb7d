/// The images of a Renderer that shows what it renders (docs/protocol.md, "A preview").
#pragma once

#include <QImage>
#include <QString>

#include <memory>
#include <optional>

namespace gui {

struct PreviewPicture {
    QImage image; ///< memory of its own
    bool last = false;
    int samples = 0;                     ///< of each pixel, at least
    QImage errors;                       ///< bytes (common/frames/error_byte.h) of pixels; null: not known
    float error = -1, largestError = -1; ///< as PictureOrigin's
};

/// One thread. Nothing waits: read() is called every few milliseconds.
class PreviewReader {
  public:
    /// Looks for the instance until it is there. Other runs' images are passed over.
    PreviewReader(const QString& instance, quint64 run);
    ~PreviewReader();
    PreviewReader(const PreviewReader&) = delete;
    PreviewReader& operator=(const PreviewReader&) = delete;

    /// A newer image, where there is one that is better than `live`. Interpolated pixels of the Renderer are
    /// worse: there `live` is seen, or, where that is null or has another size, there is no image yet.
    std::optional<PreviewPicture> read(const QImage& live);
    double progress() const { return progress_; } ///< fraction of the work that is done; 0 while it loads
    const QString& trouble() const { return trouble_; } ///< why nothing will come; empty while all is well

  private:
    struct Link;
    void look();

    std::unique_ptr<Link> link_;
    double progress_ = 0;
    QString trouble_;
};

/// The beginning of the name of every instance that is no server but a preview.
QString previewPrefix();
/// A name that no other preview has; of a process's n-th one.
QString previewInstance(int number);

} // namespace gui
