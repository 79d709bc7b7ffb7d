/// The lights of the scene, each with a check box, and its environment maps, one of which is chosen. Knows no
/// server.
#pragma once

#include "gui/models/scene_state.h"

#include <QWidget>

class QAbstractButton;
class QButtonGroup;
class QGroupBox;
class QLabel;

namespace gui {

class LightsPanel : public QWidget {
    Q_OBJECT

  public:
    explicit LightsPanel(QWidget* parent = nullptr);

    /// Emits nothing. The fields stay the same ones while their number does.
    void show(const QList<NamedSwitch>& lights, const QList<NamedSwitch>& environments);
    using QWidget::show;
    /// Null when there is none.
    QAbstractButton* light(int number) const;
    QAbstractButton* environment(int number) const;

  signals:
    void lightSwitched(int light, bool on);
    void environmentChosen(int environment);

  private:
    void refill(QButtonGroup& buttons, const QList<NamedSwitch>& switches, bool lights);

    QGroupBox *lightBox_, *environmentBox_;
    QButtonGroup *lights_, *environments_;
    QLabel* nothing_;
};

} // namespace gui
