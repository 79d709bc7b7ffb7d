#include "gui/dialogs/keys_dialog.h"

#include "gui/models/action_table.h"
#include "gui/models/view_keys.h"
#include "gui/session/session.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace gui {

namespace {

QString row(const QString& keys, const QString& meaning) {
    return QStringLiteral("<tr><td align=right style=\"padding-right:10px\"><b>%1</b></td><td>%2</td></tr>")
        .arg(keys.toHtmlEscaped(), meaning.toHtmlEscaped());
}

QString table(const QString& title, const QString& rows) {
    return QStringLiteral("<h4>%1</h4><table cellspacing=1>%2</table>").arg(title.toHtmlEscaped(), rows);
}

// One row for each action; lights and environments have ten keys each.
QString bindingRows(const QList<Binding>& bindings) {
    QString rows;
    for (const QString& action : bindableActions()) {
        QStringList keys;
        for (const Binding& binding : bindings) {
            if (binding.action == action) keys.append(binding.keys);
        }
        if (keys.isEmpty()) continue;
        constexpr qsizetype kMax = 4;
        const QString text = keys.size() > kMax ? keys.first() + QStringLiteral(" … ") + keys.last()
                                                : keys.join(QStringLiteral(", "));
        rows += row(text, actionTitle(action));
    }
    return rows;
}

QString shortcutRows(ShortcutScheme scheme) {
    QString rows;
    for (const ActionRow& action : actionTable()) {
        const QString keys = shortcutOf(action, scheme).toString(QKeySequence::NativeText);
        if (keys.isEmpty()) continue;
        rows += row(keys, actionText(action).remove(QLatin1Char('&')).remove(QStringLiteral("…")));
    }
    return rows;
}

} // namespace

QString keysPage(const QList<Binding>& bindings, ShortcutScheme scheme, MouseScheme mouse) {
    const auto tr = [](const char* text) { return QCoreApplication::translate("gui", text); };
    QString view;
    for (const ViewKey& each : viewKeys(mouse)) view += row(each.keys, each.meaning);
    return QStringLiteral("<table cellspacing=12 width=\"100%\"><tr><td>%1%2</td><td>%3</td></tr></table>")
        .arg(table(tr("Moving"), bindingRows(bindings)), table(tr("Image"), view),
             table(tr("Menus"), shortcutRows(scheme)));
}

KeysDialog::KeysDialog(Session& session, ShortcutScheme scheme, MouseScheme mouse, QWidget* parent)
    : QDialog(parent), page_(new QTextBrowser) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Keys"));
    page_->setHtml(keysPage(defaultBindings(), scheme, mouse));
    page_->setAccessibleName(tr("Keys"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    auto* column = new QVBoxLayout(this);
    column->addWidget(page_);
    column->addWidget(buttons);
    constexpr QSize kSize(760, 640);
    resize(kSize);
    if (!session.live()) return;
    session.send(command::bindings(), this, [this, scheme, mouse](const Answer& answer) {
        const QList<Binding> bindings = answer.done ? readBindings(answer.text) : QList<Binding>();
        if (!bindings.isEmpty()) page_->setHtml(keysPage(bindings, scheme, mouse));
    });
}

} // namespace gui
