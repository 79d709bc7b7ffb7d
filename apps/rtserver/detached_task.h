/// Work that no thread has to wait for: reading a file may take for ever.
#pragma once

#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace rtserver {

/// Threads of DetachedTasks that are at work. A process that ends while there are any must not run
/// destructors of static objects: see endProcess().
int tasksAtWork() noexcept;
void countTask(int change) noexcept;

/// A thread of its own does `work`, which therefore owns all that it uses. Destroying the task drops the
/// result; the thread goes on. All functions are for one thread.
template <typename Result>
class DetachedTask {
  public:
    explicit DetachedTask(std::function<Result()> work) : state_(std::make_shared<State>()) {
        countTask(1);
        try {
            std::thread([state = state_, work = std::move(work)]() mutable {
                run(*state, work);
                work = nullptr; // what it owns goes before the count
                state.reset();
                countTask(-1);
            }).detach();
        } catch (...) {
            countTask(-1);
            throw;
        }
    }
    DetachedTask(const DetachedTask&) = delete;
    DetachedTask& operator=(const DetachedTask&) = delete;

    bool done() const {
        const std::scoped_lock lock(state_->mutex);
        return state_->done;
    }
    /// False when it is not done in that time.
    bool wait(std::chrono::nanoseconds time) const {
        std::unique_lock lock(state_->mutex);
        return state_->changed.wait_for(lock, time, [this] { return state_->done; });
    }
    /// Once, when done(). Throws what the work threw.
    Result take() {
        const std::scoped_lock lock(state_->mutex);
        if (state_->error) std::rethrow_exception(state_->error);
        return std::move(*state_->result);
    }

  private:
    struct State {
        std::mutex mutex;
        std::condition_variable changed;
        bool done = false;
        std::optional<Result> result;
        std::exception_ptr error;
    };

    static void run(State& state, const std::function<Result()>& work) {
        std::optional<Result> result;
        std::exception_ptr error;
        try {
            result.emplace(work());
        } catch (...) {
            error = std::current_exception();
        }
        const std::scoped_lock lock(state.mutex);
        state.result = std::move(result);
        state.error = std::move(error);
        state.done = true;
        state.changed.notify_all();
    }

    std::shared_ptr<State> state_;
};

} // namespace rtserver
