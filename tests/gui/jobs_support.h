/// Jobs for the queue.
#pragma once

#include "gui/gui_support.h"

#include "gui/processes/job_queue.h"

namespace test {

/// `Fixture` has a folder with room.obj.
template <typename Fixture>
class WithJobs : public Fixture {
  protected:
    gui::JobRequest render(const std::string& output, const QStringList& options = {}) const {
        QStringList words{this->file("room.obj"), QStringLiteral("--output=") + this->file(output),
                          QStringLiteral("--threads=1")};
        return {QString::fromStdString(output), QStringLiteral("Renderer"), words + options,
                this->file(output), nullptr};
    }
    /// Takes minutes, if it is left alone.
    gui::JobRequest longRender(const std::string& output) const {
        return render(output, {QStringLiteral("--width=2000"), QStringLiteral("--height=2000"),
                               QStringLiteral("--antialiasing=16")});
    }
    gui::JobRequest shortRender(const std::string& output) const {
        return render(output, {QStringLiteral("--width=32"), QStringLiteral("--height=24")});
    }
    static gui::JobState state(const gui::JobQueue& queue, quint64 id) {
        return queue.job(queue.rowOf(id)).state;
    }
    static bool becomes(const gui::JobQueue& queue, quint64 id, gui::JobState wanted) {
        return comes([&] { return state(queue, id) == wanted; });
    }
    static std::string text(const QString& text) { return text.toStdString(); }
};

} // namespace test
