#include "gui/view/start_page.h"

#include "gui/models/plain_text.h"
#include "gui/view/plain_widgets.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLayoutItem>
#include <QPushButton>
#include <QVBoxLayout>

namespace gui {

namespace {

constexpr qsizetype kMaxShown = 5;
constexpr int kBetweenParts = 16, kBetweenColumns = 40;

QWidget* part(QVBoxLayout*& column) {
    auto* widget = new QWidget;
    column = new QVBoxLayout(widget);
    column->setContentsMargins(0, 0, 0, kBetweenParts);
    return widget;
}

} // namespace

StartPage::StartPage(const QList<ExampleScene>& examples, const QStringList& recent, QWidget* parent)
    : QWidget(parent) {
    // On the viewport's own dark ground, whatever the theme.
    QPalette colours;
    colours.setColor(QPalette::WindowText, QColor(0xd8, 0xda, 0xde));
    setPalette(colours);
    recentPart_ = part(recent_);

    auto* open = new QPushButton(tr("Open a scene or a &model…"));
    auto* join = new QPushButton(tr("Connect to a &running server…"));
    connect(open, &QPushButton::clicked, this, &StartPage::chooseWanted);
    connect(join, &QPushButton::clicked, this, &StartPage::connectWanted);
    QVBoxLayout* files = nullptr;
    QWidget* filesPart = part(files);
    files->addWidget(headingLabel(tr("Open")));
    files->addWidget(open);
    files->addWidget(new PlainLabel(tr("or drop a file here")));
    files->addWidget(join);

    auto* scenes = new QVBoxLayout;
    if (!examples.isEmpty()) {
        QVBoxLayout* column = nullptr;
        scenes->addWidget(part(column));
        column->addWidget(headingLabel(tr("Examples")));
        for (const ExampleScene& each : examples) addScene(*column, each.name, each.path);
    }
    scenes->addWidget(recentPart_);
    scenes->addStretch();
    auto* left = new QVBoxLayout;
    left->addWidget(filesPart);
    left->addStretch();
    auto* columns = new QHBoxLayout;
    columns->setSpacing(kBetweenColumns);
    columns->addLayout(left);
    columns->addLayout(scenes);

    auto* walking =
        new PlainLabel(tr("Click into the image: the mouse looks around, W A S D move. Esc releases "
                          "both.\nF walks on the ground: Shift runs, Space jumps, C crouches. "
                          "F again flies.\nDouble-click to look somewhere. F1 shows all keys."));
    auto* page = new QVBoxLayout(this);
    page->addLayout(columns);
    page->addWidget(headingLabel(tr("To walk")));
    page->addWidget(walking);
    setRecent(recent);
}

void StartPage::addScene(QVBoxLayout& column, const QString& text, const QString& path) {
    auto* button = new QPushButton(plainEntry(text));
    button->setToolTip(plainTip(QDir::toNativeSeparators(path)));
    connect(button, &QPushButton::clicked, this, [this, path] { emit openWanted(path); });
    column.addWidget(button);
}

void StartPage::setRecent(const QStringList& files) {
    while (QLayoutItem* item = recent_->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    recentPart_->setVisible(!files.isEmpty());
    if (files.isEmpty()) return;
    recent_->addWidget(headingLabel(tr("Recent")));
    for (const QString& path : files.mid(0, kMaxShown)) addScene(*recent_, QFileInfo(path).fileName(), path);
}

} // namespace gui
