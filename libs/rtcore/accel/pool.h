/// Memory that threads borrow for a while and that is used again instead of freed.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace rtcore {

/// Safe from many threads. Objects come back as they were left; all go with the pool, which must outlive its
/// loans.
template <typename T>
class Pool {
  public:
    class Loan {
      public:
        Loan(Pool& pool, std::unique_ptr<T> object) : pool_(pool), object_(std::move(object)) {}
        ~Loan() {
            const std::scoped_lock lock(pool_.mutex_);
            pool_.free_.push_back(std::move(object_));
        }
        Loan(const Loan&) = delete;
        Loan& operator=(const Loan&) = delete;
        T& operator*() const { return *object_; }
        T* operator->() const { return object_.get(); }

      private:
        Pool& pool_;
        std::unique_ptr<T> object_;
    };

    /// Lends the object that was returned last, or a new one from `make()`.
    template <typename Make>
    Loan borrow(const Make& make) {
        std::unique_ptr<T> object;
        {
            const std::scoped_lock lock(mutex_);
            if (free_.empty()) {
                free_.reserve(++made_); // so that giving back never allocates
            } else {
                object = std::move(free_.back());
                free_.pop_back();
            }
        }
        if (object == nullptr) object = make();
        return Loan(*this, std::move(object));
    }

  private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<T>> free_;
    std::size_t made_ = 0;
};

} // namespace rtcore
