/// The lights of the scene, each with a check box, what can be changed of the selected one, the scene's
/// surroundings - one of its environments, a computed sky, or none - and what can be changed of those. Knows
/// no server.
#pragma once

#include "gui/models/scene_state.h"

#include <QWidget>

#include <string>

class QAbstractButton;
class QAction;
class QButtonGroup;
class QGroupBox;
class QListWidget;
class QListWidgetItem;
class QPushButton;
class QRadioButton;
class QVBoxLayout;

namespace gui {

class LightFields;
class SkyFields;

class LightsPanel : public QWidget {
    Q_OBJECT

  public:
    /// `marks`: what shows the marks of lights in the image; `openMap`: what asks for an environment map.
    LightsPanel(QAction* marks, QAction* openMap, QWidget* parent = nullptr);

    /// Emits nothing. The fields stay the same ones while their number does.
    void show(const SceneState& state);
    using QWidget::show;
    /// Emits nothing. 0: none.
    void select(int id);
    int selected() const { return selected_; }

    QListWidget& lights() { return *list_; }
    LightFields& fields() { return *fields_; }
    SkyFields& sky() { return *sky_; }
    /// Null when there is none.
    QListWidgetItem* light(int place) const;
    QAbstractButton* environment(int number) const;
    QAbstractButton& computedSky();
    QAbstractButton& noBackground();

  signals:
    void lightSwitched(int id, bool on);
    void lightSelected(int id);
    /// As LightFields::edited().
    void lightEdited(const QString& step, const std::string& line);
    void addWanted(const std::string& kind);
    void copyWanted(int id);
    void removeWanted(int id);
    void environmentChosen(int environment);
    void skyWanted();
    void noBackgroundWanted();

  private:
    void makeLights(QVBoxLayout& column, QAction* marks);
    void makeEnvironments(QVBoxLayout& column, QAction* openMap);
    void showLights(const QList<ShownLight>& lights);
    void showSelected();
    void showEnvironments(const SceneState& state);
    void showMaps(const QList<NamedSwitch>& maps);
    void onItem(QListWidgetItem& item);

    QList<ShownLight> shown_;
    int selected_ = 0; ///< id
    float metresPerUnit_ = 1;
    rtcore::LocalOrigin origin_;
    QListWidget* list_;
    QPushButton *copy_, *remove_;
    LightFields* fields_;
    SkyFields* sky_;
    QVBoxLayout* environmentList_;
    QButtonGroup* environments_;
    QRadioButton *computed_, *none_;
    QList<QRadioButton*> maps_; ///< by their numbers
};

} // namespace gui
