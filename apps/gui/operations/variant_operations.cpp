#include "gui/operations/variant_operations.h"

#include "gui/dialogs/variant_name_dialog.h"
#include "gui/models/plain_text.h"
#include "gui/operations/actions.h"
#include "gui/operations/scene_editor.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/notice_bar.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>

namespace gui {

VariantOperations::VariantOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context) {
    context_.actions.on(ActionId::KeepVariant, [this] {
        QString free = tr("Variant %1").arg(names_.size() + 1);
        for (qsizetype i = names_.size() + 2; names_.contains(free); ++i) free = tr("Variant %1").arg(i);
        askForName(tr("Keep as a variant"), free, [this](const QString& name) {
            edit(command::variantAdd(name.toStdString()), tr("Kept as the variant “%1”.").arg(name));
        });
    });
    connect(&context_.editor, &SceneEditor::stateChanged, this, [this] {
        const SceneState& state = context_.editor.state();
        if (state.variants != names_ || state.variant != active_) fill();
    });
    fill();
}

void VariantOperations::fill() {
    names_ = context_.editor.state().variants;
    active_ = context_.editor.state().variant;
    QMenu& menu = *context_.actions.variants();
    menu.clear();
    menu.setEnabled(!names_.isEmpty());
    if (names_.isEmpty()) return;
    addChoices();
    if (!active_.isEmpty()) addChanges();
}

void VariantOperations::addChoices() {
    QMenu& menu = *context_.actions.variants();
    auto* group = new QActionGroup(&menu);
    const auto add = [&](const QString& text, bool on, const std::string& line, const QString& done) {
        QAction* entry = menu.addAction(text);
        entry->setCheckable(true);
        entry->setChecked(on);
        group->addAction(entry);
        connect(entry, &QAction::triggered, this, [this, line, done] { edit(line, done); });
    };
    add(tr("&Without a variant"), active_.isEmpty(), command::variantLeave(), tr("Without a variant"));
    for (const QString& name : names_)
        add(plainEntry(name), name == active_, command::variantGo(name.toStdString()), name);
}

void VariantOperations::addChanges() {
    QMenu& menu = *context_.actions.variants();
    menu.addSeparator();
    const std::string active = active_.toStdString();
    connect(menu.addAction(tr("&Update “%1”").arg(plainEntry(active_))), &QAction::triggered, this,
            [this, active, name = active_] {
                edit(command::variantUpdate(active), tr("“%1” is what is shown now.").arg(name));
            });
    connect(menu.addAction(tr("&Rename “%1”…").arg(plainEntry(active_))), &QAction::triggered, this,
            [this, active, name = active_] {
                askForName(tr("Rename a variant"), name, [this, active](const QString& to) {
                    edit(command::variantRename(active, to.toStdString()), to);
                });
            });
    connect(menu.addAction(tr("R&emove “%1”").arg(plainEntry(active_))), &QAction::triggered, this,
            [this, active, name = active_] {
                edit(command::variantRemove(active), tr("“%1” is removed. What is shown stays.").arg(name));
            });
}

void VariantOperations::askForName(const QString& title, const QString& proposed,
                                   const std::function<void(const QString&)>& act) {
    auto* dialog = new VariantNameDialog(title, proposed, &context_.window);
    connect(dialog, &VariantNameDialog::wanted, this, act);
    dialog->open();
}

void VariantOperations::edit(const std::string& line, const QString& done) {
    context_.view.showLive();
    context_.editor.edit(line, [this, done](const Answer& answer) {
        if (!answer.done) {
            fill(); // the check mark is where it was
            return context_.notice.explain(answer.text, {});
        }
        context_.view.tell(done);
    });
}

} // namespace gui
