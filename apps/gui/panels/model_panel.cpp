#include "gui/panels/model_panel.h"

#include "gui/models/plain_text.h"
#include "gui/panels/column_area.h"
#include "gui/panels/material_fields.h"
#include "gui/panels/model_search.h"
#include "gui/session/server_sentence.h"

#include "rtcore/platform/sentence.h"

#include <QAction>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLocale>
#include <QMenu>
#include <QSignalBlocker>
#include <QSplitter>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace gui {

namespace {

constexpr int kNumber = Qt::UserRole; ///< of the part or material; 0: a group
constexpr int kPath = Qt::UserRole + 1;
constexpr int kName = Qt::UserRole + 2; ///< of the part or material; none of a group

QGroupBox* boxOf(const QString& title, QWidget* content) {
    auto* box = new QGroupBox(title);
    auto* layout = new QVBoxLayout(box);
    layout->addWidget(content);
    return box;
}

QTreeWidget* makeTree(const QString& name) {
    auto* tree = new QTreeWidget;
    tree->setAccessibleName(name);
    tree->setHeaderHidden(true);
    tree->setUniformRowHeights(true);
    return tree;
}

QString shownName(const QString& name, int number) {
    return name.isEmpty() ? ModelPanel::tr("Without a name (%1)").arg(number) : name;
}

/// The name of a preset in the user's language: "Frosted glass".
QString presetTitle(const QString& name) {
    QString title = translated(rtcore::Sentence(name.toUtf8().constData()));
    title.replace(QLatin1Char('-'), QLatin1Char(' '));
    return plainEntry(title.left(1).toUpper() + title.mid(1));
}

void selectItems(QTreeWidget& tree, const QList<QTreeWidgetItem*>& items) {
    {
        const QSignalBlocker quiet(tree);
        tree.clearSelection();
        if (!items.isEmpty()) tree.setCurrentItem(items.first());
        for (QTreeWidgetItem* item : items) item->setSelected(true);
    }
    emit tree.itemSelectionChanged();
}

/// As its children are; of leaves as it is.
void checkGroups(QTreeWidgetItem& item) {
    if (item.childCount() == 0) return;
    int shown = 0, hidden = 0;
    const auto count = [&](Qt::CheckState state) {
        shown += state != Qt::Unchecked ? 1 : 0;
        hidden += state != Qt::Checked ? 1 : 0;
    };
    if (item.data(0, kNumber).toInt() != 0) count(item.checkState(0));
    for (int i = 0; i < item.childCount(); ++i) {
        checkGroups(*item.child(i));
        count(item.child(i)->checkState(0));
    }
    item.setCheckState(0, hidden == 0 ? Qt::Checked : shown == 0 ? Qt::Unchecked : Qt::PartiallyChecked);
}

} // namespace

ModelPanel::ModelPanel(QWidget* parent)
    : QWidget(parent), parts_(makeTree(tr("Parts"))), materials_(makeTree(tr("Materials"))),
      search_(new ModelSearch), selectFound_(new QToolButton), copy_(new QAction(tr("Copy material"), this)),
      paste_(new QAction(tr("Paste material"), this)), presets_(new QMenu(tr("Preset"), this)),
      fields_(new MaterialFields) {
    for (QTreeWidget* tree : {parts_, materials_})
        tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    parts_->setContextMenuPolicy(Qt::CustomContextMenu);
    materials_->setRootIsDecorated(false);
    auto* below = new QWidget;
    auto* column = new QVBoxLayout(below);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(materials_, 2);
    column->addWidget(makeLooks());
    column->addWidget(new ColumnArea(fields_), 3);
    auto* splitter = new QSplitter(Qt::Vertical);
    splitter->addWidget(boxOf(tr("Parts"), parts_));
    splitter->addWidget(boxOf(tr("Materials"), below));
    splitter->setSizes({400, 500}); // in their proportion
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(makeSearch());
    layout->addWidget(splitter);
    connect(parts_, &QTreeWidget::itemChanged, this, &ModelPanel::onChecked);
    connect(parts_, &QTreeWidget::itemSelectionChanged, this, [this] {
        const QList<QTreeWidgetItem*> chosen = parts_->selectedItems();
        emit partChosen(chosen.size() == 1 ? chosen.first()->data(0, kNumber).toInt() : 0);
    });
    connect(parts_, &QWidget::customContextMenuRequested, this, [this](const QPoint& position) {
        QMenu menu(this);
        fillMenu(menu);
        menu.exec(parts_->viewport()->mapToGlobal(position));
    });
    connect(materials_, &QTreeWidget::itemSelectionChanged, this, [this] {
        enableLooks();
        emit materialChosen(chosenMaterial());
    });
    enableLooks();
}

QWidget* ModelPanel::makeSearch() {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(6, 4, 6, 0);
    layout->addWidget(search_, 1);
    layout->addWidget(selectFound_);
    selectFound_->setText(tr("Select all"));
    selectFound_->setToolTip(tr("Select all parts and materials that are found (Return)"));
    selectFound_->setEnabled(false);
    connect(search_, &QLineEdit::textChanged, this, &ModelPanel::showFound);
    connect(search_, &QLineEdit::returnPressed, this, &ModelPanel::selectAllFound);
    connect(selectFound_, &QToolButton::clicked, this, &ModelPanel::selectAllFound);
    return row;
}

QWidget* ModelPanel::makeLooks() {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    presets_->menuAction()->setToolTip(tr("Make it a ready-made material"));
    for (QAction* action : {copy_, paste_, presets_->menuAction()}) {
        auto* button = new QToolButton;
        button->setDefaultAction(action);
        button->setPopupMode(QToolButton::InstantPopup);
        layout->addWidget(button);
        materials_->addAction(action);
    }
    layout->addStretch();
    materials_->setContextMenuPolicy(Qt::ActionsContextMenu);
    connect(copy_, &QAction::triggered, this, [this] {
        copied_ = chosenMaterial();
        enableLooks();
    });
    connect(paste_, &QAction::triggered, this, [this] { emit pasteWanted(copied_, chosenMaterials()); });
    return row;
}

// What is copied is as it is when it is pasted.
void ModelPanel::enableLooks() {
    const QList<int> chosen = chosenMaterials();
    copy_->setEnabled(chosen.size() == 1);
    copy_->setToolTip(tr("Keep which material is to be pasted"));
    paste_->setEnabled(copied_ != 0 && !chosen.isEmpty() && chosen != QList<int>{copied_});
    const QTreeWidgetItem* from = materials_->topLevelItem(copied_ - 1);
    const QString tip =
        from != nullptr ? tr("Make it look like %1").arg(from->text(0)) : tr("No material is copied");
    paste_->setToolTip(plainTip(tip));
    presets_->menuAction()->setEnabled(!chosen.isEmpty() && !presets_->isEmpty());
}

void ModelPanel::showPresets(const QStringList& names) {
    presets_->clear();
    for (const QString& name : names)
        presets_->addAction(presetTitle(name), this,
                            [this, name] { emit presetWanted(chosenMaterials(), name); });
    enableLooks();
}

void ModelPanel::forgetCopy() {
    copied_ = 0;
    enableLooks();
}

void ModelPanel::showFound() {
    const QSignalBlocker quietParts(parts_), quietMaterials(materials_);
    foundParts_ = showMeant(*parts_, search_->text(), kName);
    foundMaterials_ = showMeant(*materials_, search_->text(), kName);
    const bool asked = !search_->text().trimmed().isEmpty();
    selectFound_->setEnabled(asked && !(foundParts_.isEmpty() && foundMaterials_.isEmpty()));
}

void ModelPanel::selectAllFound() {
    if (!selectFound_->isEnabled()) return;
    selectItems(*materials_, foundMaterials_);
    selectItems(*parts_, foundParts_);
}

QTreeWidgetItem* ModelPanel::itemOf(const QString& path) {
    if (QTreeWidgetItem* known = byPath_.value(path)) return known;
    const qsizetype slash = path.lastIndexOf(QLatin1Char('/'));
    QTreeWidgetItem* parent = slash > 0 ? itemOf(path.left(slash)) : nullptr;
    auto* item = parent != nullptr ? new QTreeWidgetItem(parent) : new QTreeWidgetItem(parts_);
    item->setText(0, path.mid(slash + 1));
    item->setData(0, kPath, path);
    item->setCheckState(0, Qt::Checked);
    byPath_[path] = item;
    return item;
}

void ModelPanel::showParts(const QList<PartRow>& parts) {
    const QSignalBlocker quiet(parts_);
    const bool same = std::equal(parts.begin(), parts.end(), partRows_.begin(), partRows_.end(),
                                 [](const PartRow& a, const PartRow& b) { return a.name == b.name; });
    partRows_ = parts;
    if (!same) {
        parts_->clear();
        byPath_.clear();
        byNumber_.clear();
    }
    for (const PartRow& row : parts) {
        QTreeWidgetItem*& item = byNumber_[row.number];
        if (item == nullptr) {
            item = itemOf(row.name);
            item->setData(0, kNumber, row.number);
            item->setData(0, kName, row.name);
            if (row.name.isEmpty()) item->setText(0, shownName(row.name, row.number));
            item->setToolTip(
                0, plainTip(tr("%1: %2 triangles")
                                .arg(shownName(row.name, row.number), QLocale().toString(row.triangles))));
        }
        item->setCheckState(0, row.hidden ? Qt::Unchecked : Qt::Checked);
    }
    for (int i = 0; i < parts_->topLevelItemCount(); ++i) checkGroups(*parts_->topLevelItem(i));
    showFound();
    if (wantedPart_ != 0) selectPart(wantedPart_);
}

void ModelPanel::showMaterials(const QList<MaterialRow>& materials) {
    if (materials == materialRows_) return;
    const QSignalBlocker quiet(materials_);
    const bool same = materials.size() == materialRows_.size();
    materialRows_ = materials;
    if (!same) materials_->clear();
    for (qsizetype i = 0; i < materials.size(); ++i) {
        const MaterialRow& row = materials[i];
        QTreeWidgetItem* item = materials_->topLevelItem(static_cast<int>(i));
        if (item == nullptr) item = new QTreeWidgetItem(materials_);
        item->setText(0, shownName(row.name, row.number));
        item->setData(0, kNumber, row.number);
        item->setData(0, kName, row.name);
        QFont font = materials_->font();
        font.setItalic(row.edited);
        item->setFont(0, font);
        item->setToolTip(0, row.edited ? tr("Changed") : QString());
    }
    showFound();
    if (wantedMaterial_ != 0) selectMaterial(wantedMaterial_);
    enableLooks();
}

void ModelPanel::selectPart(int number) {
    const QSignalBlocker quiet(parts_);
    parts_->clearSelection();
    QTreeWidgetItem* item = byNumber_.value(number);
    wantedPart_ = item == nullptr ? number : 0;
    if (item == nullptr) return;
    if (item->isHidden()) search_->clear();
    parts_->setCurrentItem(item);
    parts_->scrollToItem(item);
}

void ModelPanel::selectMaterial(int number) {
    const QSignalBlocker quiet(materials_);
    QTreeWidgetItem* item = materials_->topLevelItem(number - 1);
    wantedMaterial_ = item == nullptr ? number : 0;
    if (item != nullptr && item->isHidden()) search_->clear();
    materials_->clearSelection();
    materials_->setCurrentItem(item);
    if (item != nullptr) materials_->scrollToItem(item);
    enableLooks();
}

QStringList ModelPanel::chosenParts() const {
    QStringList chosen;
    for (const QTreeWidgetItem* item : parts_->selectedItems()) {
        const int number = item->data(0, kNumber).toInt();
        if (number != 0) chosen.append(QString::number(number));
        if (item->childCount() > 0) chosen.append(item->data(0, kPath).toString() + QLatin1String("/*"));
    }
    return chosen;
}

QList<int> ModelPanel::chosenMaterials() const {
    QList<int> chosen;
    for (const QTreeWidgetItem* item : materials_->selectedItems())
        chosen.append(item->data(0, kNumber).toInt());
    return chosen;
}

int ModelPanel::chosenMaterial() const {
    const QList<int> chosen = chosenMaterials();
    return chosen.size() == 1 ? chosen.first() : 0;
}

void ModelPanel::onChecked(QTreeWidgetItem* item) {
    QStringList of;
    const int number = item->data(0, kNumber).toInt();
    if (number != 0) of.append(QString::number(number));
    if (item->childCount() > 0) of.append(item->data(0, kPath).toString() + QLatin1String("/*"));
    if (item->checkState(0) == Qt::Unchecked)
        emit hideWanted(of);
    else
        emit showWanted(of);
}

void ModelPanel::fillMenu(QMenu& menu) {
    const QStringList chosen = chosenParts();
    const auto add = [&](const QString& text, auto signal) {
        QAction* action = menu.addAction(text, this, [this, chosen, signal] { emit(this->*signal)(chosen); });
        action->setEnabled(!chosen.isEmpty());
    };
    add(tr("&Hide"), &ModelPanel::hideWanted);
    add(tr("&Show"), &ModelPanel::showWanted);
    add(tr("&Isolate"), &ModelPanel::isolateWanted);
    add(tr("Do &not cut"), &ModelPanel::leaveWanted);
    add(tr("&Cut"), &ModelPanel::cutWanted);
    menu.addSeparator();
    menu.addAction(tr("Show &all"), this, &ModelPanel::showAllWanted);
}

} // namespace gui
