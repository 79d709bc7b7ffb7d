/// The image of a saved view, taken from the window once the camera rests there: none is rendered for it.
#pragma once

#include "gui/operations/gui_context.h"

#include <QImage>
#include <QObject>
#include <QString>

#include <functional>
#include <optional>

namespace gui {

/// One visit at a time: the next one ends it.
class VisitPicture : public QObject {
    Q_OBJECT

  public:
    using Take = std::function<void(const QImage&)>;

    VisitPicture(const GuiContext& context, QObject* parent);

    /// The server has just been told to go there. `take` gets what is seen when the image is complete, with
    /// the camera still where it is now; never, where it leaves before.
    void begin(Take take);
    void end() { take_ = {}; }

  private:
    void onStatus();

    GuiContext context_;
    Take take_;                     ///< empty: no visit
    std::optional<QString> camera_; ///< as it was then, once the server told it
    bool asks_ = false;
    int visit_ = 0; ///< its number: answers to earlier ones are dropped
};

/// What the window shows, as small as images of views are.
QImage smallPicture(const GuiContext& context);

} // namespace gui
