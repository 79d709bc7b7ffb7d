/// The cheat sheet: every key on one page.
#pragma once

#include "gui/models/action_table.h"
#include "gui/models/bindings.h"
#include "gui/models/mouse_scheme.h"

#include <QDialog>

class QTextBrowser;

namespace gui {

class Session;

class KeysDialog : public QDialog {
    Q_OBJECT

  public:
    /// Asks the server for its bindings; shows the built-in ones until it answers.
    explicit KeysDialog(Session& session, ShortcutScheme scheme = ShortcutScheme::Desktop,
                        MouseScheme mouse = MouseScheme::Usual, QWidget* parent = nullptr);

  private:
    QTextBrowser* page_;
};

/// The page, as HTML.
QString keysPage(const QList<Binding>& bindings, ShortcutScheme scheme = ShortcutScheme::Desktop,
                 MouseScheme mouse = MouseScheme::Usual);

} // namespace gui
