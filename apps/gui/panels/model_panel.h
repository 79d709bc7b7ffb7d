/// The parts and the materials of the model, each in a tree, and the fields of the chosen material. Knows no
/// server.
#pragma once

#include "gui/models/model_lists.h"

#include <QHash>
#include <QStringList>
#include <QWidget>

class QMenu;
class QTreeWidget;
class QTreeWidgetItem;

namespace gui {

class MaterialFields;

class ModelPanel : public QWidget {
    Q_OBJECT

  public:
    explicit ModelPanel(QWidget* parent = nullptr);

    // They emit nothing.
    void showParts(const QList<PartRow>& parts);
    void showMaterials(const QList<MaterialRow>& materials);
    /// 0: none. One that is not in the list yet is selected once it is.
    void selectPart(int number);
    void selectMaterial(int number);

    QTreeWidget& parts() const { return *parts_; }
    QTreeWidget& materials() const { return *materials_; }
    MaterialFields& fields() const { return *fields_; }
    /// Those of the chosen parts, as commands take them: numbers, patterns for groups.
    QStringList chosenParts() const;
    int chosenMaterial() const; ///< 0: none
    /// Adds the actions on the chosen parts.
    void fillMenu(QMenu& menu);

  signals:
    void partChosen(int number);     ///< 0: none, or a group
    void materialChosen(int number); ///< 0: none
    void hideWanted(const QStringList& parts);
    void showWanted(const QStringList& parts);
    void isolateWanted(const QStringList& parts);
    void leaveWanted(const QStringList& parts); ///< by sections
    void cutWanted(const QStringList& parts);
    void showAllWanted();

  private:
    QTreeWidgetItem* itemOf(const QString& path);
    void onChecked(QTreeWidgetItem* item);

    QTreeWidget *parts_, *materials_;
    MaterialFields* fields_;
    QList<PartRow> partRows_;
    QList<MaterialRow> materialRows_;
    QHash<QString, QTreeWidgetItem*> byPath_;
    QHash<int, QTreeWidgetItem*> byNumber_;
    int wantedPart_ = 0, wantedMaterial_ = 0; ///< to be selected when they come; 0: none
};

} // namespace gui
