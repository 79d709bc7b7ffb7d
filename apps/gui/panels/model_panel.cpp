#include "gui/panels/model_panel.h"

#include "gui/models/plain_text.h"
#include "gui/panels/column_area.h"
#include "gui/panels/material_fields.h"

#include <QGroupBox>
#include <QHeaderView>
#include <QLocale>
#include <QMenu>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace gui {

namespace {

constexpr int kNumber = Qt::UserRole; ///< of the part or material; 0: a group
constexpr int kPath = Qt::UserRole + 1;

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
      fields_(new MaterialFields) {
    parts_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    parts_->setContextMenuPolicy(Qt::CustomContextMenu);
    materials_->setRootIsDecorated(false);
    auto* below = new QWidget;
    auto* column = new QVBoxLayout(below);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(materials_, 2);
    column->addWidget(new ColumnArea(fields_), 3);
    auto* splitter = new QSplitter(Qt::Vertical);
    splitter->addWidget(boxOf(tr("Parts"), parts_));
    splitter->addWidget(boxOf(tr("Materials"), below));
    splitter->setSizes({400, 500}); // in their proportion
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
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
    connect(materials_, &QTreeWidget::itemSelectionChanged, this,
            [this] { emit materialChosen(chosenMaterial()); });
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
            if (row.name.isEmpty()) item->setText(0, shownName(row.name, row.number));
            item->setToolTip(
                0, plainTip(tr("%1: %2 triangles")
                                .arg(shownName(row.name, row.number), QLocale().toString(row.triangles))));
        }
        item->setCheckState(0, row.hidden ? Qt::Unchecked : Qt::Checked);
    }
    for (int i = 0; i < parts_->topLevelItemCount(); ++i) checkGroups(*parts_->topLevelItem(i));
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
        QFont font = materials_->font();
        font.setItalic(row.edited);
        item->setFont(0, font);
        item->setToolTip(0, row.edited ? tr("Changed") : QString());
    }
    if (wantedMaterial_ != 0) selectMaterial(wantedMaterial_);
}

void ModelPanel::selectPart(int number) {
    const QSignalBlocker quiet(parts_);
    parts_->clearSelection();
    QTreeWidgetItem* item = byNumber_.value(number);
    wantedPart_ = item == nullptr ? number : 0;
    if (item == nullptr) return;
    parts_->setCurrentItem(item);
    parts_->scrollToItem(item);
}

void ModelPanel::selectMaterial(int number) {
    const QSignalBlocker quiet(materials_);
    QTreeWidgetItem* item = materials_->topLevelItem(number - 1);
    wantedMaterial_ = item == nullptr ? number : 0;
    materials_->setCurrentItem(item);
    if (item != nullptr) materials_->scrollToItem(item);
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

int ModelPanel::chosenMaterial() const {
    const QList<QTreeWidgetItem*> chosen = materials_->selectedItems();
    return chosen.isEmpty() ? 0 : chosen.first()->data(0, kNumber).toInt();
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
