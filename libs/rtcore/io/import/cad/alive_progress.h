/// Signs of progress while Open CASCADE works.
#pragma once

#include <Message_ProgressIndicator.hxx>

#include <functional>
#include <utility>

namespace rtcore {

class AliveProgress : public Message_ProgressIndicator {
    DEFINE_STANDARD_RTTI_INLINE(AliveProgress, Message_ProgressIndicator)
  public:
    explicit AliveProgress(std::function<void()> alive) : alive_(std::move(alive)) {}

  protected:
    void Show(const Message_ProgressScope& /*scope*/, const Standard_Boolean /*force*/) override { alive_(); }

  private:
    std::function<void()> alive_;
};

} // namespace rtcore
