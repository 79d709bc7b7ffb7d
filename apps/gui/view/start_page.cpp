#include "gui/view/start_page.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLayoutItem>
#include <QPushButton>
#include <QVBoxLayout>

namespace gui {

namespace {

constexpr qsizetype kMostShown = 5;
constexpr int kBetweenParts = 16, kBetweenColumns = 40;

QLabel* heading(const QString& text) {
    auto* label = new QLabel(QStringLiteral("<b>%1</b>").arg(text.toHtmlEscaped()));
    label->setTextFormat(Qt::RichText);
    return label;
}

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
    setStyleSheet(QStringLiteral("QLabel { color: #d8dade; }"));
    recentPart_ = part(recent_);

    auto* open = new QPushButton(tr("&Open a scene or a model…"));
    auto* join = new QPushButton(tr("Connect to a running &server…"));
    connect(open, &QPushButton::clicked, this, &StartPage::chooseWanted);
    connect(join, &QPushButton::clicked, this, &StartPage::connectWanted);
    QVBoxLayout* files = nullptr;
    QWidget* filesPart = part(files);
    files->addWidget(heading(tr("Open")));
    files->addWidget(open);
    files->addWidget(new QLabel(tr("or drop a file here")));
    files->addWidget(join);

    auto* scenes = new QVBoxLayout;
    if (!examples.isEmpty()) {
        QVBoxLayout* column = nullptr;
        scenes->addWidget(part(column));
        column->addWidget(heading(tr("Examples")));
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

    auto* walking = new QLabel(tr("Click into the image: the mouse looks around, W A S D move. Esc releases "
                                  "both.\nF walks on the ground: Shift runs, Space jumps, C crouches. "
                                  "F again flies.\nDouble-click to look somewhere. F1 shows all keys."));
    auto* page = new QVBoxLayout(this);
    page->addLayout(columns);
    page->addWidget(heading(tr("To walk")));
    page->addWidget(walking);
    setRecent(recent);
}

void StartPage::addScene(QVBoxLayout& column, const QString& text, const QString& path) {
    QString label = text;
    auto* button = new QPushButton(label.replace(QLatin1Char('&'), QLatin1String("&&")));
    button->setToolTip(QDir::toNativeSeparators(path));
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
    recent_->addWidget(heading(tr("Recent")));
    for (const QString& path : files.mid(0, kMostShown)) addScene(*recent_, QFileInfo(path).fileName(), path);
}

} // namespace gui
