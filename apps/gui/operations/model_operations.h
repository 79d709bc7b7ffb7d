/// The model's parts and materials: the panel that shows them, what is selected by a click on the image, and
/// its mark there.
#pragma once

#include "gui/models/model_lists.h"
#include "gui/operations/gui_context.h"
#include "gui/session/session.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <functional>
#include <string>

class QDockWidget;

namespace gui {

class ModelPanel;

class ModelOperations : public QObject {
    Q_OBJECT

  public:
    ModelOperations(const GuiContext& context, QObject* parent);

  private:
    void connectPanel();
    void connectFields();
    void refresh();
    void askParts(int from, const QList<PartRow>& before);
    void askMaterials(int from, const QList<MaterialRow>& before);
    void askFields();
    void askPresets();
    void setPreset(const QList<int>& materials, const QString& name);
    void pick(const QPointF& position);
    void openMenu(const QPoint& place);
    void select(bool material, int number);
    void fitSelected();
    void onFrame();
    void askMark();
    void setMaterial(const QString& key, const std::string& line);

    GuiContext context_;
    ModelPanel* panel_;
    QDockWidget* dock_;
    QTimer refresh_, rest_;
    bool markMaterial_ = false; ///< else a part
    int marked_ = 0;            ///< its number; 0: none
    View markedView_;
    QString lastKey_; ///< whose gesture may go on
    QElapsedTimer sinceSet_;
};

} // namespace gui
