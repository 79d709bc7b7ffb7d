/// The table of actions as Qt has them: menus, shortcuts, what is enabled.
#pragma once

#include "gui/models/action_table.h"
#include "gui/models/preferences.h"

#include <QHash>
#include <QObject>

#include <functional>

class QAction;
class QMenu;
class QMenuBar;
class QWidget;

namespace gui {

class Actions : public QObject {
    Q_OBJECT

  public:
    /// The shortcuts work in `window`, also while its menu bar is hidden.
    Actions(QWidget& window, Preferences& preferences);

    QAction* operator[](ActionId id) const { return actions_.value(static_cast<int>(id)); }
    /// Calls `act` when the action is chosen, or a checkable one is toggled.
    void on(ActionId id, const std::function<void()>& act);
    void onToggle(ActionId id, const std::function<void(bool)>& act);
    /// A checkable action that shows, and changes, a preference.
    void bind(ActionId id, const Preference<bool>& preference);

    void fill(QMenuBar& bar);
    void setServerThere(bool there);
    /// The menu of the installed environment maps, once fill() was called; null where there are none.
    QMenu* skies() const { return skies_; }
    /// The menu of the scene's variants, once fill() was called.
    QMenu* variants() const { return variants_; }

  signals:
    void recentChosen(const QString& path); ///< or an example
    void skyChosen(const QString& path);    ///< an installed environment map

  private:
    void setShortcuts();
    void fillRecent();
    void addExamples(QMenu& menu);
    void addSkies(QMenu& menu);

    Preferences& preferences_;
    QHash<int, QAction*> actions_;
    QMenu *recent_ = nullptr, *variants_ = nullptr;
    bool there_ = false;     ///< a server
    QMenu* skies_ = nullptr; ///< where some are installed
};

} // namespace gui
