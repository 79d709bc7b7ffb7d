/// The plan in the corner, and the ways from storey to storey.
#pragma once

#include "gui/operations/gui_context.h"

#include "common/commands/outline_text.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <array>
#include <functional>
#include <optional>

namespace gui {

class CornerPlan;

/// The server finds the lines, in the background and once for a storey; the window asks when another one is
/// to be shown, or a while after the scene changed, and never twice at a time.
class CornerPlanOperations : public QObject {
    Q_OBJECT

  public:
    CornerPlanOperations(const GuiContext& context, QObject* parent);

  private:
    void addStoreys();
    void showPlan();
    void forget();
    void ask();
    void take(const QString& text);
    void refuse(const QString& text);
    void follow();
    int storeyOfCamera() const;
    void want(int storey);
    void choose(int storey);
    void go(const std::array<double, 3>& eye);
    void look(const std::array<float, 3>& forward, bool goesOn);
    void goToStorey(const std::function<int(const app::ToldOutline&)>& choose);

    GuiContext context_;
    CornerPlan* plan_;
    QTimer changed_;            ///< until the scene is asked about anew
    QString text_;              ///< the last answer
    std::optional<int> wanted_; ///< storey; nothing: that of the camera
    bool byHand_ = false;       ///< it was chosen by the arrows
    int storey_ = 0;            ///< of the camera
    bool asks_ = false, again_ = false;
};

} // namespace gui
