#include "rtcore/io/import/materials/model_folder.h"

#include <algorithm>
#include <system_error>

namespace rtcore {

namespace fs = std::filesystem;

ModelFolder::ModelFolder(const fs::path& model) {
    std::error_code error;
    const fs::path folder = model.parent_path();
    homes_[0] = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
    homes_[1] = fs::canonical(model, error).parent_path();
}

bool ModelFolder::holds(const fs::path& file) const {
    std::error_code error;
    const fs::path real = fs::canonical(file, error);
    return !error && std::ranges::any_of(homes_, [&](const fs::path& home) {
        return !home.empty() && std::ranges::mismatch(home, real).in1 == home.end();
    });
}

} // namespace rtcore
