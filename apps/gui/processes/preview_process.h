/// The current view, rendered in higher quality by the Renderer, shown while it refines.
#pragma once

#include "gui/models/picture_origin.h"
#include "gui/models/still_quality.h"
#include "gui/session/preview_reader.h"
#include "gui/session/session.h"

#include <QImage>
#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>

class QProcess;

namespace gui {

class ModelCache;
class PrivateFolder;

/// One image at a time. The Renderer stays for the next one, so that it does not load the model again.
/// Nothing waits but the destructor.
class PreviewProcess : public QObject {
    Q_OBJECT

  public:
    /// `models` are read in place of what takes long to load.
    PreviewProcess(Session& session, const ModelCache& models, QObject* parent = nullptr);
    /// Renderers that run are ended, and waited for.
    ~PreviewProcess() override;

    /// Renders an image of the size of a live frame. An image still under way is given up.
    void render(const StillQuality& quality);
    /// Nothing more is heard of the image under way, which its Renderer is told to give up.
    void cancel();
    /// The same, and the Renderer is told to end: no image will be asked for soon.
    void leave();
    bool active() const { return active_; }
    double progress() const { return progress_; } ///< 0..1
    qint64 process() const;                       ///< of the Renderer; 0 when there is none
    const QString& instance() const { return instance_; }

  signals:
    /// A better image than the one before, with the errors of its pixels (PreviewPicture).
    void refined(const QImage& picture, bool last, const PictureOrigin& origin, const QImage& errors);
    void failed(const QString& text);
    void progressed(); ///< also when it begins and ends

  private:
    void exportScene();
    void ask();
    void launch(const QStringList& options, const QString& model);
    QStringList options() const;
    bool serves(const QStringList& options, const QString& model) const;
    void look();
    void finish(int exitCode, bool crashed);
    void tryAgain();
    void fail(const QString& text);
    void release();
    void end();
    QString file(const QString& extension, quint64 run) const;

    Session& session_;
    const ModelCache& models_;
    QString instance_;
    quint64 run_; ///< of the image under way, or of the next
    StillQuality quality_;
    bool active_ = false;
    int tries_ = 0; ///< of the image under way
    double progress_ = 0;
    std::unique_ptr<PrivateFolder> folder_;
    QProcess* process_ = nullptr;
    QStringList options_; ///< that it was started with, but for its first image
    QString model_;       ///< that it reads in place of the scene's; empty: none
    QTimer patience_;     ///< with a Renderer that nothing is asked of
    std::optional<PreviewReader> reader_;
    QTimer timer_;
};

} // namespace gui
