#include "gui/panels/notes_panel.h"

#include "gui/models/note_texts.h"
#include "gui/models/plain_text.h"
#include "gui/panels/column_area.h"
#include "gui/view/plain_widgets.h"

#include "common/commands/command_lines.h"

#include <QGridLayout>
#include <QListWidget>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace gui {

namespace {

namespace command = app::command;

QPushButton* noteButton(const QString& text, const QString& tip) {
    auto* button = new QPushButton(text);
    button->setToolTip(plainTip(tip));
    return button;
}

} // namespace

NotesPanel::NotesPanel(QWidget* parent) : QWidget(parent), list_(new QListWidget), whole_(new PlainLabel) {
    constexpr int kRows = 8;
    list_->setAccessibleName(tr("Notes"));
    list_->setUniformItemSizes(true);
    list_->setTextElideMode(Qt::ElideRight);
    list_->setMinimumHeight(kRows * (list_->fontMetrics().height() + 4));
    whole_->setWordWrap(true);
    whole_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    whole_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    addButtons();
    auto* column = new QWidget;
    auto* rows = new QVBoxLayout(column);
    rows->addWidget(list_);
    auto* grid = new QGridLayout;
    grid->addWidget(add_, 0, 0, 1, 2);
    grid->addWidget(go_, 1, 0);
    grid->addWidget(edit_, 1, 1);
    grid->addWidget(remove_, 2, 0);
    grid->addWidget(export_, 2, 1);
    rows->addLayout(grid);
    rows->addWidget(whole_);
    rows->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(new ColumnArea(column));
    show(SceneState());
}

void NotesPanel::addButtons() {
    add_ = noteButton(tr("Add a note"), tr("Click the place in the image that the note is about"));
    add_->setCheckable(true);
    go_ =
        noteButton(tr("Go there"), tr("Look from where the note was written; also Enter or a double click"));
    edit_ = noteButton(tr("Edit…"), tr("Change the text or the author of the selected note"));
    remove_ = noteButton(tr("Remove"), tr("Remove the selected note; also Del"));
    export_ = noteButton(tr("Export…"), tr("Write all notes as a table, a .csv file"));
    connect(add_, &QPushButton::clicked, this, &NotesPanel::addWanted);
    connect(go_, &QPushButton::clicked, this, [this] { emit goWanted(selected()); });
    connect(edit_, &QPushButton::clicked, this, [this] { emit editWanted(selected()); });
    connect(remove_, &QPushButton::clicked, this, &NotesPanel::remove);
    connect(export_, &QPushButton::clicked, this, &NotesPanel::exportWanted);
    connect(list_, &QListWidget::currentRowChanged, this, &NotesPanel::showWhole);
    connect(list_, &QListWidget::itemActivated, this, [this] {
        if (selected() >= 0) emit goWanted(selected());
    });
    auto* key = new QShortcut(Qt::Key_Delete, list_, nullptr, nullptr, Qt::WidgetShortcut);
    key->setAutoRepeat(false); // a note at a time
    connect(key, &QShortcut::activated, this, &NotesPanel::remove);
}

void NotesPanel::remove() {
    if (selected() >= 0) emit wanted(command::noteRemove(selected() + 1));
}

int NotesPanel::selected() const {
    const int row = list_->currentRow();
    return row < std::ssize(state_.notes) ? row : -1;
}

void NotesPanel::select(int index) { list_->setCurrentRow(index); }

void NotesPanel::setAdding(bool adding) { add_->setChecked(adding); }

void NotesPanel::show(const SceneState& state) {
    const bool same = state.notes == state_.notes && state.noteCount == state_.noteCount;
    state_ = state;
    if (!same) showList();
    showWhole();
}

void NotesPanel::showList() {
    const QSignalBlocker quiet(list_);
    const int count = static_cast<int>(state_.notes.size());
    const int row = list_->currentRow();
    list_->clear();
    for (int i = 0; i < count; ++i) {
        const rtcore::SceneNote& note = state_.notes[static_cast<std::size_t>(i)];
        auto* item = new QListWidgetItem(noteRow(note, i + 1), list_);
        item->setToolTip(plainTip(wholeNote(note)));
    }
    const int left = state_.noteCount - count;
    if (left > 0) (new QListWidgetItem(tr("%n more", nullptr, left), list_))->setFlags(Qt::NoItemFlags);
    // Others add notes, too.
    list_->setCurrentRow(row < 0 ? count - 1 : std::min(row, count - 1));
}

void NotesPanel::showWhole() {
    const int row = selected();
    whole_->setText(row < 0 ? QString() : wholeNote(state_.notes[static_cast<std::size_t>(row)]));
    for (QWidget* each : std::initializer_list<QWidget*>{go_, edit_, remove_}) each->setEnabled(row >= 0);
    export_->setEnabled(!state_.notes.empty());
}

} // namespace gui
