#include "gui/operations/plan_operations.h"

#include "gui/dialogs/plan_dialog.h"
#include "gui/models/output_file.h"
#include "gui/operations/actions.h"
#include "gui/session/session.h"
#include "gui/view/frame_view.h"
#include "gui/view/notice_bar.h"

#include <QAction>
#include <QFileInfo>
#include <QPointer>

namespace gui {

namespace {

/// Of the answer to `storeys`: "1 2.800 80.10", a line for each.
std::vector<double> floorsOf(const QString& answer) {
    std::vector<double> floors;
    for (const QString& line : answer.split(QLatin1Char('\n'), Qt::SkipEmptyParts)) {
        bool good = false;
        const double floor = line.section(QLatin1Char(' '), 1, 1).toDouble(&good);
        if (good) floors.push_back(floor);
    }
    return floors;
}

} // namespace

PlanOperations::PlanOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context) {
    context_.actions.on(ActionId::Plan, [this] { ask(); });
}

void PlanOperations::ask() {
    const QString kept = context_.preferences.get(pref::planFolder);
    const QString folder =
        !kept.isEmpty() && QFileInfo(kept).isDir() ? kept : context_.preferences.picturesFolder();
    const QPointer<PlanDialog> dialog =
        new PlanDialog(nextFreeName(folder, QStringLiteral("plan"), QStringLiteral("pdf")),
                       context_.preferences, &context_.window);
    connect(dialog, &PlanDialog::wanted, this, &PlanOperations::draw);
    context_.session.send(command::storeys(), this, [dialog](const Answer& answer) {
        if (dialog && answer.done) dialog->setStoreys(floorsOf(answer.text));
    });
    dialog->open();
}

void PlanOperations::draw(const PlanWish& plan) {
    context_.preferences.set(pref::planFolder, QFileInfo(plan.path).absolutePath());
    context_.view.tell(tr("Drawing the plan…"));
    const std::string line = command::plan(plan.path.toStdString(), plan.side.toStdString(), plan.scale,
                                           plan.paper.toStdString(), plan.storey, plan.height);
    context_.session.send(line, this, [this, path = plan.path](const Answer& answer) {
        context_.view.tell(answer.done ? tr("The plan was written to %1.").arg(path) : QString());
        if (!answer.done) context_.notice.explain(answer.text, {context_.actions[ActionId::UpAndUnit]});
    });
}

} // namespace gui
