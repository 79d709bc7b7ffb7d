#include "gui/operations/actions.h"

#include "gui/models/example_scenes.h"
#include "gui/models/installed_skies.h"
#include "gui/models/plain_text.h"

#include <QAction>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>

namespace gui {

Actions::Actions(QWidget& window, Preferences& preferences) : QObject(&window), preferences_(preferences) {
    for (const ActionRow& row : actionTable()) {
        auto* action = new QAction(actionText(row), this);
        action->setStatusTip(actionTip(row));
        action->setToolTip(plainTip(actionTip(row)));
        action->setCheckable(row.has(Checkable));
        action->setMenuRole(QAction::NoRole);
        window.addAction(action);
        actions_.insert(static_cast<int>(row.id), action);
    }
    setServerThere(false);
    setShortcuts();
    connect(&preferences_, &Preferences::changed, this, &Actions::setShortcuts);
}

void Actions::setShortcuts() {
    const ShortcutScheme scheme = shortcutSchemeOf(preferences_.get(pref::shortcuts));
    for (const ActionRow& row : actionTable()) (*this)[row.id]->setShortcut(shortcutOf(row, scheme));
}

void Actions::on(ActionId id, const std::function<void()>& act) {
    connect((*this)[id], &QAction::triggered, this, [act] { act(); });
}

void Actions::onToggle(ActionId id, const std::function<void(bool)>& act) {
    connect((*this)[id], &QAction::triggered, this, act);
}

void Actions::bind(ActionId id, const Preference<bool>& preference) {
    QAction* action = (*this)[id];
    action->setChecked(preferences_.get(preference));
    connect(action, &QAction::triggered, this,
            [this, &preference](bool on) { preferences_.set(preference, on); });
    connect(&preferences_, &Preferences::changed, action,
            [this, action, &preference] { action->setChecked(preferences_.get(preference)); });
}

void Actions::fill(QMenuBar& bar) {
    QHash<int, QMenu*> menus;
    for (const ActionRow& row : actionTable()) {
        QMenu*& menu = menus[static_cast<int>(row.menu)];
        if (menu == nullptr) menu = bar.addMenu(menuText(row.menu));
        if (row.has(SeparatorBefore)) menu->addSeparator();
        menu->addAction((*this)[row.id]);
        if (row.has(SkiesAfter)) addSkies(*menu);
        if (row.has(VariantsAfter)) variants_ = menu->addMenu(tr("&Variants"));
        if (!row.has(RecentFilesAfter)) continue;
        recent_ = menu->addMenu(tr("Open &recent"));
        connect(&preferences_, &Preferences::changed, this, &Actions::fillRecent);
        fillRecent();
        addExamples(*menu);
    }
}

void Actions::addExamples(QMenu& menu) {
    const QList<ExampleScene> scenes = exampleScenes();
    if (scenes.isEmpty()) return;
    QMenu* examples = menu.addMenu(tr("Exam&ples"));
    for (const ExampleScene& each : scenes) {
        QAction* entry = examples->addAction(plainEntry(each.name));
        entry->setStatusTip(each.path);
        connect(entry, &QAction::triggered, this, [this, path = each.path] { emit recentChosen(path); });
    }
}

void Actions::addSkies(QMenu& menu) {
    const QList<InstalledSky> skies = installedSkies();
    if (skies.isEmpty()) return;
    skies_ = menu.addMenu(tr("&Built-in environments"));
    for (const InstalledSky& each : skies) {
        QAction* entry = skies_->addAction(plainEntry(each.name));
        entry->setStatusTip(each.path);
        connect(entry, &QAction::triggered, this, [this, path = each.path] { emit skyChosen(path); });
    }
    skies_->setEnabled(there_);
}

void Actions::fillRecent() {
    recent_->clear();
    const QStringList files = preferences_.recentFiles();
    for (const QString& path : files) {
        QAction* entry = recent_->addAction(plainEntry(QFileInfo(path).fileName()));
        entry->setStatusTip(plainText(path));
        entry->setToolTip(plainTip(path));
        connect(entry, &QAction::triggered, this, [this, path] { emit recentChosen(path); });
    }
    if (!files.isEmpty()) {
        recent_->addSeparator();
        connect(recent_->addAction(tr("&Clear")), &QAction::triggered, &preferences_,
                &Preferences::clearRecentFiles);
    }
    recent_->setEnabled(!files.isEmpty());
}

void Actions::setServerThere(bool there) {
    there_ = there;
    if (skies_ != nullptr) skies_->setEnabled(there);
    for (const ActionRow& row : actionTable()) {
        if (row.has(NeedsServer)) (*this)[row.id]->setEnabled(there);
    }
}

} // namespace gui
