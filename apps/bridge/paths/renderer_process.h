/// The Renderer program, kept for the next image so that it does not load the model again.
#pragma once

#include "bridge/clock.h"
#include "bridge/paths/path_renderer.h"

#include "common/process/started_process.h"

#include "rtcore/platform/temporary_folder.h"

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace bridge {

/// Ends its program after ten minutes without an image, and with itself.
class RendererProcess : public PathRenderer {
  public:
    /// `clock` must outlive it.
    explicit RendererProcess(const Clock& clock);
    ~RendererProcess() override;
    RendererProcess(const RendererProcess&) = delete;
    RendererProcess& operator=(const RendererProcess&) = delete;

    const std::string& instance() const override { return instance_; }
    std::string file(const std::string& name) override;
    void render(std::uint64_t run, const std::string& scene, const std::string& camera) override;
    void giveUp() override;
    int tick(bool wanted) override;

  private:
    struct Order {
        std::uint64_t run = 0;
        std::string scene, camera;
    };
    void launch(const Order& order);
    void end();

    const Clock& clock_;
    const std::string instance_;
    std::unique_ptr<rtcore::TemporaryFolder> folder_;
    std::map<std::string, std::string> files_; ///< paths by their names
    std::unique_ptr<app::StartedProcess> process_;
    bool ending_ = false;        ///< it was asked to
    std::optional<Order> order_; ///< for the next one, once it has ended
    double used_ = 0;            ///< when an image was last under way
};

} // namespace bridge
