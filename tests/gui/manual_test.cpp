/// docs/window.md names what the program has. RT_RENEW_DOCS=1 in the environment writes its tables anew.
#include "gui/models/action_table.h"
#include "gui/models/bindings.h"
#include "gui/models/view_keys.h"

#include "support/document_section.h"

#include <gtest/gtest.h>

namespace {

using namespace gui;

QString plain(QString text) { return text.remove(QLatin1Char('&')).remove(QStringLiteral("…")); }

QString menus() {
    QString page = QStringLiteral("| menu | | shortcut | |\n|---|---|---|---|\n");
    for (const ActionRow& row : actionTable()) {
        const bool first = &row == actionTable().data() || (&row - 1)->menu != row.menu;
        page += QStringLiteral("| %1 | %2 | %3 | %4 |\n")
                    .arg(first ? QStringLiteral("**%1**").arg(plain(menuText(row.menu))) : QString(),
                         plain(actionText(row)), shortcutOf(row).toString(), actionTip(row));
    }
    return page;
}

QString thesisShortcuts() {
    QString page = QStringLiteral("| | |\n|---|---|\n");
    for (const ActionRow& row : actionTable()) {
        if (row.thesis == nullptr) continue;
        page += QStringLiteral("| %1 | %2 |\n")
                    .arg(plain(actionText(row)), shortcutOf(row, ShortcutScheme::Thesis).toString());
    }
    return page;
}

QString keys() {
    QString page = QStringLiteral("| keys | |\n|---|---|\n");
    for (const QString& action : bindableActions()) {
        QStringList keys;
        for (const Binding& binding : defaultBindings()) {
            if (binding.action == action) keys.append(binding.keys);
        }
        page += QStringLiteral("| %1 | %2 |\n").arg(keys.join(QStringLiteral(", ")), actionTitle(action));
    }
    return page;
}

QString ownKeys() {
    QString page = QStringLiteral("| key | |\n|---|---|\n");
    for (const ViewKey& each : viewKeys())
        page += QStringLiteral("| %1 | %2 |\n").arg(each.keys, each.meaning);
    return page;
}

TEST(Manual, NamesEveryActionAndKey) {
    test::expectSection(RT_WINDOW_PAGE, "menus", menus().toStdString());
    test::expectSection(RT_WINDOW_PAGE, "shortcuts of the thesis", thesisShortcuts().toStdString());
    test::expectSection(RT_WINDOW_PAGE, "keys", keys().toStdString());
    test::expectSection(RT_WINDOW_PAGE, "keys of the image", ownKeys().toStdString());
}

} // namespace
