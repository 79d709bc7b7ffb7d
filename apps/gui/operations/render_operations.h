/// Better images than the live ones: progressive rendering when nothing moves, and quick render.
#pragma once

#include "gui/models/still_quality.h"
#include "gui/operations/gui_context.h"
#include "gui/processes/preview_process.h"

#include <QElapsedTimer>
#include <QObject>
#include <QSize>
#include <QTimer>

#include <optional>

namespace gui {

class RenderOperations : public QObject {
    Q_OBJECT

  public:
    RenderOperations(const GuiContext& context, QObject* parent);

  private:
    void bindAtRest();
    void tellServer();
    void listen();
    void render(const StillQuality& quality);
    void quickRender(int antialiasing);
    void renderProgressively();
    bool mayRenderProgressively() const;
    /// The image is, or will be, out of date: back to the live frames, in this very moment.
    void interrupt();
    /// Only the size of the frame is another one: the image stays until there is one as good of that size, or
    /// something moves or is edited.
    void onResize();
    /// The server has been asked for another size, and draws it before it says so.
    bool resizes() const;
    /// The image stays whatever frames come: it goes when the user or another client edits.
    bool keeps() const { return kept_ || resizes(); }
    void beginAgain();
    void onStatus();
    void onFrame();
    void onPreferences();
    void onRefined(const QImage& picture, bool last, const PictureOrigin& origin, const QImage& errors);
    void onFailed(const QString& text);
    void showActivity();
    QString progressText() const;

    /// The view and the frame that an image belongs to.
    struct Moment {
        View view;
        QSize size;
        quint64 frame = 0;
        bool idle = false; ///< else the server draws the same frame again and again
    };

    GuiContext context_;
    PreviewProcess preview_;
    bool refines_ = false; ///< what the server was told
    QTimer rest_;          ///< how long nothing has moved
    QElapsedTimer sizeAsked_;
    bool quick_ = false;   ///< the image was asked for; else it is a progressive one
    bool settled_ = false; ///< this moment is rendered, is being rendered, or cannot be
    Moment moment_;
    std::optional<PictureOrigin> kept_; ///< of the image that is still shown, of another size
    quint64 revision_ = 0;              ///< ServerStatus::imageRevision since which it is kept
    StillQuality rendered_;             ///< of the last image
};

} // namespace gui
