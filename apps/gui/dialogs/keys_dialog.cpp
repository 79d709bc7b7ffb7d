#include "gui/dialogs/keys_dialog.h"

#include "gui/models/action_table.h"
#include "gui/session/session.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace gui {

namespace {

QString row(const QString& keys, const QString& meaning) {
    return QStringLiteral("<tr><td align=right><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>")
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
        constexpr qsizetype kMost = 4;
        const QString text = keys.size() > kMost ? keys.first() + QStringLiteral(" … ") + keys.last()
                                                 : keys.join(QStringLiteral(", "));
        rows += row(text, actionTitle(action));
    }
    return rows;
}

QString shortcutRows() {
    QString rows;
    for (const ActionRow& action : actionTable()) {
        const QString keys = shortcutOf(action).toString(QKeySequence::NativeText);
        if (keys.isEmpty()) continue;
        rows += row(keys, actionText(action).remove(QLatin1Char('&')).remove(QStringLiteral("…")));
    }
    return rows;
}

} // namespace

QString keysPage(const QList<Binding>& bindings) {
    const auto tr = [](const char* text) { return QCoreApplication::translate("gui", text); };
    const QString picture = row(tr("Click, Enter"), tr("Capture mouse and keyboard")) +
                            row(tr("Esc"), tr("Release them")) + row(tr("Mouse"), tr("Look around")) +
                            row(tr("Double click"), tr("Look there")) +
                            row(tr("Alt+digit"), tr("Go to a bookmark")) + row(tr("Wheel"), tr("Speed")) +
                            row(QStringLiteral("E"), tr("Export the camera")) +
                            row(QStringLiteral("H"), tr("Export the camera for high quality")) +
                            row(QStringLiteral("R"), tr("Render in higher quality")) +
                            row(QStringLiteral("R+L"), tr("The same with anti-aliasing"));
    return QStringLiteral("<table cellspacing=12 width=\"100%\"><tr><td>%1%2</td><td>%3</td></tr></table>")
        .arg(table(tr("Moving"), bindingRows(bindings)), table(tr("Image"), picture),
             table(tr("Menus"), shortcutRows()));
}

KeysDialog::KeysDialog(Session& session, QWidget* parent) : QDialog(parent), page_(new QTextBrowser) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Keys"));
    page_->setHtml(keysPage(defaultBindings()));
    page_->setAccessibleName(tr("Keys"));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    auto* column = new QVBoxLayout(this);
    column->addWidget(page_);
    column->addWidget(buttons);
    constexpr QSize kSize(760, 640);
    resize(kSize);
    if (!session.live()) return;
    session.send(command::bindings(), this, [this](const Answer& answer) {
        const QList<Binding> bindings = answer.done ? readBindings(answer.text) : QList<Binding>();
        if (!bindings.isEmpty()) page_->setHtml(keysPage(bindings));
    });
}

} // namespace gui
