#include "gui/panels/fold_box.h"

#include <QKeyEvent>
#include <QToolButton>
#include <QVBoxLayout>

namespace gui {

FoldBox::FoldBox(const QString& title, QWidget* content, QWidget* parent)
    : QWidget(parent), title_(title), header_(new QToolButton), content_(content) {
    header_->setText(title);
    header_->setAccessibleName(title);
    header_->setCheckable(true);
    header_->setAutoRaise(true);
    header_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    header_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    header_->setFocusPolicy(Qt::StrongFocus);
    QFont bold = header_->font();
    bold.setBold(true);
    header_->setFont(bold);
    header_->installEventFilter(this);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(header_);
    column->addWidget(content_);
    connect(header_, &QToolButton::toggled, this, &FoldBox::show);
    connect(header_, &QToolButton::clicked, this, [this](bool open) { emit foldedChanged(!open); });
    header_->setChecked(true);
}

void FoldBox::show(bool open) {
    header_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    content_->setVisible(open);
}

void FoldBox::setFolded(bool folded) { header_->setChecked(!folded); }
bool FoldBox::folded() const { return !header_->isChecked(); }

void FoldBox::setMarked(bool marked) {
    header_->setText(marked ? title_ + QStringLiteral(" •") : title_);
    header_->setToolTip(marked ? tr("Some of these differ from their defaults") : QString());
}

bool FoldBox::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == (folded() ? Qt::Key_Right : Qt::Key_Left)) {
            header_->click();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace gui
