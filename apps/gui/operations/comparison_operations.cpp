#include "gui/operations/comparison_operations.h"

#include "gui/operations/actions.h"
#include "gui/view/comparison.h"
#include "gui/view/frame_view.h"

#include <QAction>
#include <QKeySequence>

#include <array>
#include <utility>

namespace gui {

namespace {

constexpr std::array<std::pair<ActionId, CompareMode>, 3> kModes{
    {{ActionId::CompareDivider, CompareMode::Divider},
     {ActionId::CompareBlink, CompareMode::Blink},
     {ActionId::CompareDifference, CompareMode::Difference}}};

} // namespace

ComparisonOperations::ComparisonOperations(const GuiContext& context, QObject* parent)
    : QObject(parent), context_(context), comparison_(new Comparison(context.view)) {
    context_.actions.on(ActionId::KeepImage, [this] { keep(); });
    for (const auto& [id, mode] : kModes)
        context_.actions.onToggle(id, [this, id = id, mode = mode](bool on) { toggle(id, mode, on); });
}

void ComparisonOperations::keep() {
    const QImage shown = context_.view.shown();
    if (shown.isNull()) return;
    comparison_->keep(shown);
    context_.view.tell(tr("This image is kept. The menu Render compares others with it."));
}

/// One way at a time.
void ComparisonOperations::toggle(ActionId id, CompareMode mode, bool on) {
    if (!on) {
        if (comparison_->mode() == mode) comparison_->show(CompareMode::Off);
        return;
    }
    if (comparison_->kept().isNull()) {
        context_.actions[id]->setChecked(false);
        context_.view.tell(
            tr("Nothing is kept to compare with: press %1 first.")
                .arg(context_.actions[ActionId::KeepImage]->shortcut().toString(QKeySequence::NativeText)));
        return;
    }
    comparison_->show(mode);
    for (const auto& [other, itsMode] : kModes)
        if (other != id) context_.actions[other]->setChecked(false);
}

} // namespace gui
