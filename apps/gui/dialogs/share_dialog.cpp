#include "gui/dialogs/share_dialog.h"

#include <QDialogButtonBox>
#include <QEvent>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

namespace gui {

namespace {

constexpr int kNarrowest = 560;

} // namespace

ShareDialog::ShareDialog(Preferences& preferences, const QList<OwnAddress>& addresses, QWidget* parent)
    : QDialog(parent), pages_(new QStackedWidget), plan_(new SharePlanPage(preferences, addresses)),
      links_(new ShareLinksPage) {
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Share in a browser"));
    pages_->addWidget(plan_);
    pages_->addWidget(links_);
    auto* buttons = new QDialogButtonBox;
    start_ = buttons->addButton(tr("&Share"), QDialogButtonBox::AcceptRole);
    stop_ = buttons->addButton(tr("S&top sharing"), QDialogButtonBox::ActionRole);
    close_ = buttons->addButton(QDialogButtonBox::Close);
    auto* column = new QVBoxLayout(this);
    column->addWidget(pages_);
    column->addWidget(buttons);
    setMinimumWidth(kNarrowest);
    connect(plan_, &SharePlanPage::changed, this, [this] { start_->setEnabled(plan_->complete()); });
    connect(start_, &QPushButton::clicked, this, &ShareDialog::start);
    connect(stop_, &QPushButton::clicked, this, &ShareDialog::stopWanted);
    connect(close_, &QPushButton::clicked, this, &QDialog::close);
    become(Stage::Plan);
}

// A layout asks for no more than one line of a text that takes several.
bool ShareDialog::event(QEvent* event) {
    if (event->type() == QEvent::LayoutRequest) setMinimumHeight(layout()->totalHeightForWidth(kNarrowest));
    return QDialog::event(event);
}

void ShareDialog::become(Stage stage) {
    pages_->setCurrentIndex(stage == Stage::Links ? 1 : 0);
    plan_->setEnabled(stage == Stage::Plan);
    start_->setVisible(stage != Stage::Links);
    start_->setEnabled(stage == Stage::Plan && plan_->complete());
    stop_->setVisible(stage != Stage::Plan);
    (stage == Stage::Plan ? start_ : close_)->setDefault(true);
}

void ShareDialog::start() {
    plan_->remember();
    emit startWanted(plan_->request());
}

void ShareDialog::showPlan(const QString& trouble) {
    plan_->tell(trouble);
    become(Stage::Plan);
}

void ShareDialog::showStarting() {
    plan_->tell(tr("Starting…"));
    become(Stage::Starting);
}

void ShareDialog::showLinks(const BridgeRequest& request, const BridgeLinks& links) {
    links_->show(request, links);
    become(Stage::Links);
}

} // namespace gui
