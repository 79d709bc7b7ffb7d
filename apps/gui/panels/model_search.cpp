#include "gui/panels/model_search.h"

#include "rtcore/io/text/pattern.h"

#include <QKeyEvent>
#include <QTreeWidget>

#include <string>

namespace gui {

namespace {

bool fits(const std::string& pattern, const QString& name) {
    return rtcore::matchesPattern(pattern, name.toLower().toStdString());
}

/// Whether it, or anything below it, is shown.
bool showMeantOf(QTreeWidgetItem& item, const QString& text, int nameRole, QList<QTreeWidgetItem*>& meant) {
    const QVariant name = item.data(0, nameRole);
    bool shown = name.isValid() && isMeant(text, name.toString());
    if (shown) meant.append(&item);
    bool below = false;
    for (int i = 0; i < item.childCount(); ++i)
        below = showMeantOf(*item.child(i), text, nameRole, meant) || below;
    if (below && !text.trimmed().isEmpty()) item.setExpanded(true);
    shown = shown || below;
    item.setHidden(!shown);
    return shown;
}

} // namespace

bool isMeant(const QString& text, const QString& name) {
    const QString wanted = text.trimmed().toLower();
    const std::string pattern = wanted.toStdString();
    if (!rtcore::isPattern(pattern)) return name.toLower().contains(wanted);
    return fits(pattern, name) || fits(pattern, name.mid(name.lastIndexOf(QLatin1Char('/')) + 1));
}

QList<QTreeWidgetItem*> showMeant(QTreeWidget& tree, const QString& text, int nameRole) {
    QList<QTreeWidgetItem*> meant;
    for (int i = 0; i < tree.topLevelItemCount(); ++i)
        showMeantOf(*tree.topLevelItem(i), text, nameRole, meant);
    return meant;
}

ModelSearch::ModelSearch(QWidget* parent) : QLineEdit(parent) {
    setClearButtonEnabled(true);
    setPlaceholderText(tr("Find by name, with * and ?"));
    setAccessibleName(tr("Find parts and materials"));
}

bool ModelSearch::event(QEvent* event) {
    const bool asks = event->type() == QEvent::ShortcutOverride;
    if (!asks || text().isEmpty() || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape)
        return QLineEdit::event(event);
    event->accept();
    return true;
}

void ModelSearch::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && !text().isEmpty()) return clear();
    QLineEdit::keyPressEvent(event);
}

} // namespace gui
