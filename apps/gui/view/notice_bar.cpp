#include "gui/view/notice_bar.h"

#include "gui/view/plain_widgets.h"

#include <QAction>
#include <QHBoxLayout>
#include <QPushButton>

namespace gui {

namespace {

void addButton(QHBoxLayout* row, QPushButton* button) {
    button->setFocusPolicy(Qt::StrongFocus);
    row->addWidget(button);
}

} // namespace

NoticeBar::NoticeBar(QWidget* parent) : QFrame(parent), label_(new PlainLabel), buttons_(new QHBoxLayout) {
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setAccessibleName(tr("Notice"));
    label_->setWordWrap(true);
    label_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* row = new QHBoxLayout(this);
    row->addWidget(label_, 1);
    row->addLayout(buttons_);
    hide();
}

void NoticeBar::explain(const QString& text, const QList<QAction*>& actions) {
    text_ = text;
    label_->setText(text);
    while (QLayoutItem* item = buttons_->takeAt(0)) {
        item->widget()->deleteLater();
        delete item;
    }
    for (QAction* action : actions) {
        // Its mnemonic belongs to the menu.
        auto* button = new QPushButton(action->text().remove(QLatin1Char('&')));
        connect(button, &QPushButton::clicked, this, &QWidget::hide);
        connect(button, &QPushButton::clicked, action, &QAction::trigger);
        addButton(buttons_, button);
    }
    auto* close = new QPushButton(tr("Close"));
    connect(close, &QPushButton::clicked, this, &QWidget::hide);
    addButton(buttons_, close);
    setVisible(true);
}

} // namespace gui
