/// The parts and the materials of the model, each in a tree, the fields of the chosen material, and a line
/// that looks for names in both. Knows no server.
#pragma once

#include "gui/models/model_lists.h"

#include <QHash>
#include <QList>
#include <QStringList>
#include <QWidget>

class QAction;
class QMenu;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace gui {

class MaterialFields;
class ModelSearch;

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
    /// Names of ready-made materials, as the server has them.
    void showPresets(const QStringList& names);
    /// Nothing can be pasted: materials are others.
    void forgetCopy();

    QTreeWidget& parts() const { return *parts_; }
    QTreeWidget& materials() const { return *materials_; }
    MaterialFields& fields() const { return *fields_; }
    ModelSearch& search() const { return *search_; }
    QToolButton& selectFound() const { return *selectFound_; }
    QAction& copyAction() const { return *copy_; }
    QAction& pasteAction() const { return *paste_; }
    QMenu& presets() const { return *presets_; }
    /// Those of the chosen parts, as commands take them: numbers, patterns for groups.
    QStringList chosenParts() const;
    int chosenMaterial() const; ///< 0: none, or several
    QList<int> chosenMaterials() const;
    /// Adds the actions on the chosen parts.
    void fillMenu(QMenu& menu);

  signals:
    void partChosen(int number);     ///< 0: none, or a group
    void materialChosen(int number); ///< 0: none, or several
    void pasteWanted(int from, const QList<int>& to);
    void presetWanted(const QList<int>& materials, const QString& name); ///< the server's name
    void hideWanted(const QStringList& parts);
    void showWanted(const QStringList& parts);
    void isolateWanted(const QStringList& parts);
    void leaveWanted(const QStringList& parts); ///< by sections
    void cutWanted(const QStringList& parts);
    void showAllWanted();

  private:
    QTreeWidgetItem* itemOf(const QString& path);
    void onChecked(QTreeWidgetItem* item);
    QWidget* makeSearch();
    QWidget* makeLooks();
    void showFound();
    void selectAllFound();
    void enableLooks();

    QTreeWidget *parts_, *materials_;
    ModelSearch* search_;
    QToolButton* selectFound_;
    QAction *copy_, *paste_;
    QMenu* presets_;
    MaterialFields* fields_;
    QList<PartRow> partRows_;
    QList<MaterialRow> materialRows_;
    QHash<QString, QTreeWidgetItem*> byPath_;
    QHash<int, QTreeWidgetItem*> byNumber_;
    QList<QTreeWidgetItem*> foundParts_, foundMaterials_;
    int copied_ = 0;                          ///< the number of a material; 0: none
    int wantedPart_ = 0, wantedMaterial_ = 0; ///< to be selected when they come; 0: none
};

} // namespace gui
