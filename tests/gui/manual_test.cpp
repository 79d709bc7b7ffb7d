/// docs/window.md names what the program has. RT_RENEW_DOCS=1 in the environment writes its tables anew.
#include "gui/models/action_table.h"
#include "gui/models/bindings.h"

#include <gtest/gtest.h>

#include <QFile>

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

// What stands between <!-- name --> and <!-- end -->.
QString replaced(const QString& page, const QString& name, const QString& table) {
    const QString mark = QStringLiteral("<!-- %1 -->\n").arg(name);
    const qsizetype begin = page.indexOf(mark) + mark.size();
    const qsizetype end = page.indexOf(QStringLiteral("<!-- end -->"), begin);
    EXPECT_GE(end, begin) << name.toStdString();
    return page.left(begin) + table + page.mid(end);
}

TEST(Manual, NamesEveryActionAndKey) {
    QFile file(QStringLiteral(RT_WINDOW_PAGE));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QString page = QString::fromUtf8(file.readAll());
    const QString wanted =
        replaced(replaced(page, QStringLiteral("menus"), menus()), QStringLiteral("keys"), keys());
    if (qEnvironmentVariableIsSet("RT_RENEW_DOCS")) {
        file.close();
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(wanted.toUtf8());
        return;
    }
    EXPECT_EQ(page.toStdString(), wanted.toStdString())
        << "RT_RENEW_DOCS=1 test_gui --gtest_filter=Manual.* writes the tables of docs/window.md anew";
}

} // namespace
